#include "player/page_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "ice/floe_grid.hpp"
#include "ice/polygon_floe.hpp"
#include "player/thinned_history.hpp"
#include "scenario/scenario.hpp"
#include "view/camera.hpp"

namespace floes {
namespace {

using nlohmann::json;

constexpr int most_points = 4000;  // of a load history

json list(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

json conditions(const RecordingSubject& subject) {
    const Scenario& scenario = subject.scenario;
    const Ice& ice = scenario.ice;
    const Field& field = scenario.field;
    json rows = json::array();
    const auto row = [&](const char* name, const std::string& value) { rows.push_back({name, value}); };
    const FloeShape& shape = scenario.floe;
    row("Floes", subject.floes.alike() ? fmt::format("{} of {:g} m × {:g} m × {:g} m", subject.floes.size(),
                                                     shape.length, shape.breadth, shape.thickness)
                                       : fmt::format("{} that differ", subject.floes.size()));
    row("Concentration", fmt::format("{:g} %", field.concentration / unit::percent));
    row("Elastic modulus", fmt::format("{:g} MPa", ice.elastic_modulus / 1e6));
    row("Bending strength", fmt::format("{:g} kPa", ice.bending_strength / 1e3));
    row("Speed of the tow", fmt::format("{:g} m/s", scenario.structure.speed));
    row("Structure", scenario.structure.shape.words());
    row("Channel", fmt::format("{:g} m wide", 2 * field.half_width));
    row("Time step", fmt::format("{:g} s", scenario.general.time_step));
    return rows;
}

/// Time, x, z and yaw of the structure in each frame; null on the straight tow.
json poses(const Recording& recording) {
    if (recording.subject().scenario.towed_straight()) return nullptr;
    json all = json::array();
    for (int frame = 0; frame < recording.frames(); ++frame) {
        const PlanarPose pose = recording.structure(frame);
        all.push_back({recording.time(frame), pose.x, pose.z, pose.yaw});
    }
    return all;
}

/// Fairlead and direction (x and z) of the mooring lines that hold in each frame; null without lines.
json lines(const Recording& recording) {
    if (recording.subject().scenario.moorings.lines.empty()) return nullptr;
    json all = json::array();
    for (int frame = 0; frame < recording.frames(); ++frame) {
        json& seen = all.emplace_back(json::array());
        for (const FrameLine& line : recording.lines(frame)) {
            const Vec3 way = (line.anchor - line.fairlead).normalized();
            seen.push_back({line.fairlead.x(), line.fairlead.z(), way.x(), way.z()});
        }
    }
    return all;
}

/// Cameras relative to the structure where they follow it.
json views(const RecordingSubject& subject) {
    json all = json::array();
    for (std::size_t i = 0; i < view_names.size(); ++i) {
        const auto view = static_cast<View>(i);
        const Camera one = camera(view, subject, 0);
        const bool follows = camera(view, subject, 1).target != one.target;
        all.push_back({{"name", view_names[i]},
                       {"eye", list(one.eye)},
                       {"target", list(one.target)},
                       {"up", list(one.up)},
                       {"angle", one.angle},
                       {"height", one.height},
                       {"length", view == View::plan ? plan_of(subject, 0).y() - plan_of(subject, 0).x() : 0},
                       {"cut", one.angle > 0 ? 0 : (one.eye - one.target).norm()},
                       {"follows", follows}});
    }
    return all;
}

json sheets(const Channel& channel) {
    json all = json::array();
    for (const IceSheet& sheet : channel.sheets)
        all.push_back({{"centre", list(sheet.centre)}, {"half", list(sheet.half_extents)}});
    return all;
}

/// The same of polygons: of each element its corners in its own x and z, and edge k on the outline as bit k.
json polygons(const CutFloe& cut, std::size_t floes, double thickness) {
    json outline = json::array();
    json corners = json::array();
    for (const CutElement& one : cut.elements) {
        outline.push_back(one.rim);
        json own = json::array();
        for (const Corner& corner : one.corners)
            own.push_back({static_cast<float>(corner.x), static_cast<float>(corner.z)});
        corners.push_back(std::move(own));
    }
    return {{"floes", floes},
            {"element", {0, thickness, 0}},
            {"outline", std::move(outline)},
            {"corners", std::move(corners)}};
}

/// Floes by kind: how many one after another, the size of an element, and of each element of one the edges on the
/// outline, as bits of Edge.
json ice(const FloeSet& floes) {
    json kinds = json::array();
    for (std::size_t first = 0; first < floes.size();) {
        std::size_t next = first + 1;
        while (next < floes.size() && floes.floes[next].shape == floes.floes[first].shape) ++next;
        const FloeShape& shape = floes.shape(first);
        if (const std::shared_ptr<const CutFloe> cut = cut_of(shape)) {
            kinds.push_back(polygons(*cut, next - first, shape.thickness));
            first = next;
            continue;
        }
        const FloeGrid grid = grid_of(shape);
        json outline = json::array();
        for (int index = 0; index < grid.elements(); ++index) outline.push_back(grid.outline_edges(index));
        kinds.push_back({{"floes", next - first},
                         {"element", {shape.element, shape.thickness, shape.element}},
                         {"outline", std::move(outline)}});
        first = next;
    }
    return kinds;
}

json structure(const Shape& shape) {
    const SurfaceMesh mesh = shape.mesh(96);
    json points = json::array();
    for (const Vec3& point : mesh.points)
        for (const double value : point) points.push_back(static_cast<float>(value));
    return {{"points", std::move(points)},
            {"polygons", mesh.polygons},
            {"radius", shape.largest_radius()},
            {"top", shape.top()}};
}

/// [time, mode, floe, element a, its edge, element b, its edge]; edges as bits of Edge.
json failures(const Recording& recording) {
    const IceLayout& layout = recording.layout();
    json all = json::array();
    for (const BreakEvent& event : recording.outcome().breaks) {
        const IceLayout::LaidJoint& joint = layout.joints.at(layout.joint(event.floe, event.joint));
        all.push_back({event.time, event.mode, event.floe, joint.a, joint.edge_a, joint.b, joint.edge_b});
    }
    return all;
}

/// Of the steps that end in (from, to], s.
json history(const Recording& recording, double from, double to) {
    const Scenario& scenario = recording.subject().scenario;
    const LoadHistory& loads = recording.outcome().history;
    const double step = scenario.general.time_step;
    const int all = static_cast<int>(loads.surge.size());
    const int begin = std::clamp(static_cast<int>(from / step + 0.5), 0, all);
    const int end = std::clamp(static_cast<int>(to / step + 0.5), begin, all);
    const auto points = [&](const std::vector<double>& load) -> json {
        const ThinnedHistory kept = thinned(load, begin, end, most_points);
        return {{"steps", kept.steps}, {"values", kept.values}};
    };
    return {{"from", from},
            {"to", to},
            {"surge", points(loads.surge)},
            {"sway", points(loads.sway)},
            {"heave", points(loads.heave)}};
}

}  // namespace

std::string page_header(const Recording& recording, const Quanta& quanta, const PackedFrames& frames,
                        std::optional<double> start) {
    const RecordingSubject& subject = recording.subject();
    const Scenario& scenario = subject.scenario;
    const Channel channel = subject.channel();
    const double begin = recording.time(0);
    const double end = recording.time(recording.frames() - 1);
    const double run = static_cast<double>(scenario.step_count()) * scenario.general.time_step;
    const json header{
        {"campaign", subject.campaign},
        {"fingerprint", subject.fingerprint},
        {"case", subject.case_name},
        {"member", subject.member},
        {"arrangement", subject.arrangement},
        {"conditions", conditions(subject)},
        {"configuration", subject.configuration},
        {"elements", recording.layout().elements.size()},
        {"floes", recording.layout().floes()},
        {"ice", ice(subject.floes)},
        {"structure", structure(scenario.structure.shape)},
        {"tow", {{"start", scenario.structure.start}, {"speed", scenario.structure.speed}}},
        {"poses", poses(recording)},
        {"lines", lines(recording)},
        {"channel",
         {{"begin", channel.begin}, {"end", channel.end}, {"edge", channel.outer_edge}, {"sheets", sheets(channel)}}},
        {"window", {scenario.analysis.steady_start, run}},
        {"views", views(subject)},
        {"frames", frames.frames},
        {"start", start.value_or(begin)},
        {"quanta",
         {{"middle", list(quanta.middle)},
          {"length", quanta.length},
          {"force", quanta.force},
          {"orientation", quanta.orientation}}},
        {"modes", failure_mode_names},
        {"failures", failures(recording)},
        {"step", scenario.general.time_step},
        {"histories", {history(recording, 0, run), history(recording, begin, end)}}};
    return header.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace floes
