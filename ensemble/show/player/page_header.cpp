#include "player/page_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "ice/floe_grid.hpp"
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

FloeGrid grid_of(const Floe& floe) {
    return {floe.elements_long(), floe.elements_broad(), floe.element};
}

json conditions(const Scenario& scenario) {
    const Ice& ice = scenario.ice;
    const Field& field = scenario.field;
    json rows = json::array();
    const auto row = [&](const char* name, const std::string& value) { rows.push_back({name, value}); };
    row("Floes", fmt::format("{} of {:g} m × {:g} m × {:g} m", field.floes, scenario.floe.length, scenario.floe.breadth,
                             ice.thickness));
    row("Concentration", fmt::format("{:g} %", field.concentration / unit::percent));
    row("Elastic modulus", fmt::format("{:g} MPa", ice.elastic_modulus / 1e6));
    row("Bending strength", fmt::format("{:g} kPa", ice.bending_strength / 1e3));
    row("Speed of the tow", fmt::format("{:g} m/s", scenario.structure.speed));
    row("Structure", scenario.structure.shape.words());
    row("Channel", fmt::format("{:g} m wide", 2 * field.half_width));
    row("Time step", fmt::format("{:g} s", scenario.general.time_step));
    return rows;
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

json outline(const FloeGrid& grid) {
    json edges = json::array();
    for (int index = 0; index < grid.elements(); ++index) edges.push_back(grid.outline_edges(index));
    return edges;
}

/// [time, mode, floe, element a, its edge, element b, its edge]; edges as bits of Edge.
json failures(const Recording& recording) {
    const std::vector<RecordJoint> joints = joints_of(recording.subject(), 1);
    json all = json::array();
    for (const BreakEvent& event : recording.outcome().breaks) {
        const RecordJoint& joint = joints.at(static_cast<std::size_t>(event.joint));
        const bool along_x = joint.axis == JointAxis::x;
        const int first = event.floe * elements_of_a_floe(recording.subject());
        all.push_back({event.time, event.mode, event.floe, first + joint.a, along_x ? edge_plus_x : edge_plus_z,
                       first + joint.b, along_x ? edge_minus_x : edge_minus_z});
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

std::string page_header(const Recording& recording, const Quanta& quanta, const PackedFrames& frames) {
    const RecordingSubject& subject = recording.subject();
    const Scenario& scenario = subject.scenario;
    const FloeGrid grid = grid_of(scenario.floe);
    const Channel channel = channel_of(subject);
    const double begin = recording.time(0);
    const double end = recording.time(recording.frames() - 1);
    const double run = static_cast<double>(scenario.step_count()) * scenario.general.time_step;
    const json header{
        {"campaign", subject.campaign},
        {"fingerprint", subject.fingerprint},
        {"case", subject.case_name},
        {"member", subject.member},
        {"arrangement", subject.arrangement},
        {"conditions", conditions(scenario)},
        {"configuration", subject.configuration},
        {"elements", recording.elements()},
        {"floes", recording.floes()},
        {"elements_of_a_floe", grid.elements()},
        {"element", {scenario.floe.element, scenario.ice.thickness, scenario.floe.element}},
        {"outline", outline(grid)},
        {"profile", scenario.structure.shape.rows()},
        {"tow", {{"start", scenario.structure.start}, {"speed", scenario.structure.speed}}},
        {"channel",
         {{"begin", channel.begin}, {"end", channel.end}, {"edge", channel.outer_edge}, {"sheets", sheets(channel)}}},
        {"window", {scenario.analysis.steady_start, run}},
        {"views", views(subject)},
        {"frames", frames.frames},
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
