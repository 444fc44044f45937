#include "draw/replay_page.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "draw/assets.hpp"
#include "draw/frame_packer.hpp"
#include "replay/view.hpp"
#include "scenario/scenario.hpp"
#include "tables/table.hpp"

namespace floes {

ThinnedHistory thinned(std::span<const double> history, int begin, int end, int most) {
    ThinnedHistory kept;
    const auto keep = [&](int step) {
        kept.steps.push_back(step);
        kept.values.push_back(static_cast<float>(history[static_cast<std::size_t>(step)]));
    };
    const int count = end - begin;
    if (count <= most) {
        for (int step = begin; step < end; ++step) keep(step);
        return kept;
    }
    const int parts = most / 2;
    const auto edge = [&](int part) { return begin + static_cast<int>(std::int64_t{count} * part / parts); };
    for (int part = 0; part < parts; ++part) {
        const auto [least, largest] =
            std::minmax_element(history.begin() + edge(part), history.begin() + edge(part + 1));
        const auto first = static_cast<int>(std::min(least, largest) - history.begin());
        const auto second = static_cast<int>(std::max(least, largest) - history.begin());
        keep(first);
        if (second != first) keep(second);
    }
    return kept;
}

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

/// Time, x, z, yaw, y, pitch and roll of the structure in each frame; null on the straight tow.
json poses(const Recording& recording) {
    if (recording.subject().scenario.towed_straight()) return nullptr;
    json all = json::array();
    for (int frame = 0; frame < recording.frames(); ++frame) {
        const StructurePose pose = recording.structure(frame);
        all.push_back({recording.time(frame), pose.position.x(), pose.position.z(), pose.yaw, pose.position.y(),
                       pose.pitch, pose.roll});
    }
    return all;
}

/// Fairlead, and the way to what is seen of them, of the mooring lines that hold in each frame; null without lines.
json lines(const Recording& recording) {
    const Scenario& scenario = recording.subject().scenario;
    if (scenario.moorings.line_count() == 0) return nullptr;
    const double seen_of_each = 1.5 * scenario.structure.shape.largest_radius();
    json all = json::array();
    for (int frame = 0; frame < recording.frames(); ++frame) {
        json& seen = all.emplace_back(json::array());
        for (const FrameLine& line : recording.lines(frame)) {
            const Vec3 way = beginning_of(scenario.moorings, line, seen_of_each).back() - line.fairlead;
            seen.push_back({line.fairlead.x(), line.fairlead.y(), line.fairlead.z(), way.x(), way.y(), way.z()});
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

/// Of elements that are no squares their corners, in their own x and z.
json corners_of(const CutFloe& cut) {
    json all = json::array();
    for (const CutElement& one : cut.elements) {
        json own = json::array();
        for (const Corner& corner : one.corners)
            own.push_back({static_cast<float>(corner.x), static_cast<float>(corner.z)});
        all.push_back(std::move(own));
    }
    return all;
}

/// Floes by kind: how many one after another, the size of an element, which is its thickness alone unless it is a
/// square, and of each element of one the edges on the outline: bit k for edge k.
json ice(const FloeSet& floes) {
    json kinds = json::array();
    for (std::size_t first = 0; first < floes.size();) {
        std::size_t next = first + 1;
        while (next < floes.size() && floes.floes[next].shape == floes.floes[first].shape) ++next;
        const FloeShape& shape = floes.shape(first);
        const CutFloe cut = shape.cut();
        json outline = json::array();
        for (const CutElement& one : cut.elements) outline.push_back(one.rim);
        const double side = cut.squares ? shape.element : 0;
        json kind{{"floes", next - first}, {"element", {side, shape.thickness, side}}, {"outline", std::move(outline)}};
        if (!cut.squares) kind["corners"] = corners_of(cut);
        kinds.push_back(std::move(kind));
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

/// [time, mode, floe, element a, its edge, element b, its edge]; edge k as bit k.
json failures(const Recording& recording) {
    const IceLayout& layout = recording.layout();
    json all = json::array();
    for (const BreakEvent& event : recording.outcome().breaks) {
        const IceLayout::LaidJoint& joint = layout.joints.at(layout.joint(event.floe, event.joint));
        all.push_back({event.time, event.mode, event.floe, joint.a, joint.edge_a, joint.b, joint.edge_b});
    }
    return all;
}

/// For the steps that end in (from, to], s.
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

namespace {

/// Every `stride`-th frame and the last; nothing once they take more than `most` bytes, with an estimate of the whole.
struct Attempt {
    std::optional<PackedFrames> frames;
    double expected = 0;  // bytes
};

Attempt pack(const Recording& recording, const Quanta& quanta, int stride, std::size_t most) {
    FramePacker packer(quanta, static_cast<int>(recording.layout().elements.size()));
    Frame frame;
    const int last = recording.frames() - 1;
    for (int i = 0; i <= last; i = i == last ? last + 1 : std::min(i + stride, last)) {
        recording.read(i, frame);
        packer.add(frame);
        if (packer.size() > most) return {std::nullopt, static_cast<double>(packer.size()) * (last + 1) / (i + 1)};
    }
    PackedFrames frames = packer.finish();
    std::size_t size = 0;
    for (const auto& [name, stream] : streams_of(frames)) size += stream->size();
    if (size > most) return {std::nullopt, static_cast<double>(size)};
    return {std::move(frames), static_cast<double>(size)};
}

PackedFrames pack_within(const Recording& recording, const Quanta& quanta, std::size_t most) {
    for (int stride = 1;;) {
        Attempt attempt = pack(recording, quanta, stride, most);
        if (attempt.frames) return std::move(*attempt.frames);
        if (stride >= recording.frames())
            throw InputError(
                fmt::format("A page of this replay does not fit into the bytes it may take; its first and "
                            "last frames alone take {:.0f} kB. Allow a larger page.",
                            attempt.expected / 1e3));
        // Frames farther apart differ more, so fewer of them take more bytes each.
        stride = std::max(stride + 1, static_cast<int>(stride * attempt.expected / static_cast<double>(most)));
    }
}

/// JSON that may stand in a script element.
std::string in_a_script(std::string text) {
    for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos;) text.replace(at, 2, "<\\/");
    return text;
}

void write_frames(std::ostream& page, const PackedFrames& frames) {
    for (const auto& [name, stream] : streams_of(frames)) {
        page << fmt::format("<script type=\"application/octet-stream\" id=\"{}\">", name);
        write_base64(page, *stream);
        page << "</script>\n";
    }
}

/// Calls `text` for each part of a template and `name` for each {{name}} in it.
template <typename Text, typename Name>
void expand(std::string_view pattern, const Text& text, const Name& name) {
    for (std::size_t at = 0;;) {
        const std::size_t open = pattern.find("{{", at);
        text(pattern.substr(at, open - at));
        if (open == std::string_view::npos) return;
        const std::size_t close = pattern.find("}}", open);
        name(pattern.substr(open + 2, close - open - 2));
        at = close + 2;
    }
}

std::string_view pattern() {
    return asset("replay.html").value();
}

std::size_t size_without_frames() {
    std::size_t size = 0;
    expand(
        pattern(), [&](std::string_view text) { size += text.size(); },
        [&](std::string_view name) { size += asset(name).value_or("").size(); });
    return size;
}

}  // namespace

void write_replay_page(std::ostream& page, const Recording& recording, const PageOptions& options) {
    const Quanta quanta = quanta_of(recording);
    const std::size_t header_size = page_header(recording, quanta, {}, options.start).size();
    const std::size_t fixed = size_without_frames() + header_size + 1000;
    const std::size_t most = options.most_bytes > fixed ? (options.most_bytes - fixed) / 4 * 3 : 0;
    const PackedFrames frames = pack_within(recording, quanta, most);
    const RecordingSubject& subject = recording.subject();
    expand(
        pattern(), [&](std::string_view text) { page << text; },
        [&](std::string_view name) {
            if (name == "title")
                page << html_escaped(
                    fmt::format("{}: case {}, member {}", subject.campaign, subject.case_name, subject.member));
            else if (name == "header")
                page << in_a_script(page_header(recording, quanta, frames, options.start));
            else if (name == "frames")
                write_frames(page, frames);
            else
                page << asset(name).value();
        });
}

void write_replay_page(const std::filesystem::path& path, const Recording& recording, const PageOptions& options) {
    std::ofstream file(path, std::ios::binary);
    if (file) write_replay_page(file, recording, options);
    file.close();
    if (!file)
        throw RunError(fmt::format("{} cannot be written ({}); does the folder exist, and has it free space?",
                                   path.string(), std::strerror(errno)));
}

}  // namespace floes
