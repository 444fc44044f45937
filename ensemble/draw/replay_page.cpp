#include "draw/replay_page.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <ostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "draw/picture.hpp"
#include "replay/view.hpp"
#include "scenario/scenario.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

constexpr double most_quanta = 32767;
constexpr std::size_t parts = 7;  // of an element's state

std::int16_t rounded(double quanta) {
    return static_cast<std::int16_t>(std::lround(std::clamp(quanta, -most_quanta, most_quanta)));
}

bool of_structure(const FrameContact& contact) {
    return contact.other == touches_structure;
}

/// Forces among the ice below this share of the largest load would be arrows of a few pixels, and are most of them.
constexpr double least_share = 0.002;

}  // namespace

Quanta quanta_of(const Recording& recording) {
    Eigen::AlignedBox3d box;
    double force = 0;
    double load = 0;
    Frame frame;
    for (int i = 0; i < recording.frames(); ++i) {
        recording.read(i, frame);
        for (const BodyState& one : frame.elements) box.extend(one.position);
        load = std::max(load, frame.load.norm());
        for (const FrameContact& contact : frame.contacts) {
            box.extend(contact.point);
            force = std::max({force, contact.normal.cwiseAbs().maxCoeff(), contact.friction.cwiseAbs().maxCoeff()});
        }
    }
    Quanta quanta;
    if (box.isEmpty()) return quanta;
    quanta.middle = box.center();
    quanta.length = std::max(0.5 * box.sizes().maxCoeff(), 1e-6) / most_quanta;
    quanta.force = std::max(force, 1e-6) / most_quanta;
    quanta.least_force = least_share * load;
    return quanta;
}

FramePacker::FramePacker(const Quanta& quanta, int elements)
    : quanta_(quanta),
      elements_(static_cast<std::size_t>(elements)),
      states_(parts * elements_),
      percent_(elements_),
      pieces_(elements_, -1) {}

void FramePacker::add(const Frame& frame) {
    at_.assign(elements_, -1);
    for (std::size_t k = 0; k < frame.elements.size(); ++k) at_[frame.id(k)] = static_cast<int>(k);
    add_states(frame);
    add_utilisation(frame);
    add_contacts(frame);
    add_pieces(frame);
    ++frames_;
}

std::int16_t FramePacker::part_of_position(double value, int axis) const {
    return rounded((value - quanta_.middle[axis]) / quanta_.length);
}

void FramePacker::add_states(const Frame& frame) {
    low_.resize(states_.size());
    high_.resize(states_.size());
    for (std::size_t e = 0; e < elements_; ++e) {
        const auto before = [&](std::size_t part) -> std::int16_t& { return states_[part * elements_ + e]; };
        const bool there = at_[e] >= 0;
        const BodyState state = there ? frame.elements[static_cast<std::size_t>(at_[e])] : BodyState{};
        const Quat q(state.rotation);
        const std::array<double, 4> turn =
            there ? std::array<double, 4>{q.w(), q.x(), q.y(), q.z()} : std::array<double, 4>{};
        double along = frames_ == 0 ? turn[0] : 0;
        for (std::size_t k = 0; k < 4; ++k) along += turn[k] * before(3 + k);
        const double sign = along < 0 ? -1 : 1;
        std::array<std::int16_t, parts> now{};
        for (std::size_t k = 0; k < 3; ++k)
            now[k] = there ? part_of_position(state.position[static_cast<int>(k)], static_cast<int>(k)) : before(k);
        for (std::size_t k = 0; k < 4; ++k) now[3 + k] = rounded(sign * turn[k] / quanta_.orientation);
        for (std::size_t part = 0; part < parts; ++part) {
            const auto difference = static_cast<std::uint16_t>(now[part] - before(part));
            low_[part * elements_ + e] = static_cast<std::byte>(difference);
            high_[part * elements_ + e] = static_cast<std::byte>(difference >> 8);
            before(part) = now[part];
        }
    }
    packed(FrameStream::low).add(low_);
    packed(FrameStream::high).add(high_);
}

void FramePacker::add_utilisation(const Frame& frame) {
    Bytes differences(elements_);
    for (std::size_t e = 0; e < elements_; ++e) {
        const double used = at_[e] < 0 ? 0.0 : frame.utilisation[static_cast<std::size_t>(at_[e])];
        const auto now = static_cast<std::uint8_t>(std::lround(100 * std::clamp(used, 0.0, 2.0)));
        differences[e] = static_cast<std::byte>(now - percent_[e]);
        percent_[e] = now;
    }
    packed(FrameStream::utilisation).add(differences);
}

void FramePacker::add_contacts(const Frame& frame) {
    Bytes bytes;
    float count = 0;
    for (const FrameContact& contact : frame.contacts) {
        if (!of_structure(contact) && (contact.normal + contact.friction).norm() < quanta_.least_force) continue;
        ++count;
        for (int axis = 0; axis < 3; ++axis) put(bytes, part_of_position(contact.point[axis], axis));
        for (const Vec3& force : {contact.normal, contact.friction})
            for (int axis = 0; axis < 3; ++axis) put(bytes, rounded(force[axis] / quanta_.force));
        put(bytes, static_cast<std::int16_t>(of_structure(contact) ? 1 : 0));
    }
    packed(FrameStream::contacts).add(bytes);
    Bytes numbers;
    put(numbers, static_cast<float>(frame.time));
    for (int axis = 0; axis < 3; ++axis) put(numbers, static_cast<float>(frame.load[axis]));
    put(numbers, count);
    packed(FrameStream::numbers).add(numbers);
}

void FramePacker::add_pieces(const Frame& frame) {
    Bytes changes;
    for (std::size_t e = 0; e < elements_; ++e) {
        if (at_[e] < 0) continue;
        const int piece = frame.pieces[static_cast<std::size_t>(at_[e])];
        if (piece == pieces_[e]) continue;
        pieces_[e] = piece;
        put(changes, frames_);
        put(changes, static_cast<std::int32_t>(e));
        put(changes, pieces_[e]);
    }
    packed(FrameStream::pieces).add(changes);
}

std::size_t FramePacker::size() const {
    std::size_t all = 0;
    for (const Deflater& one : packed_) all += one.size();
    return all;
}

PackedFrames FramePacker::finish() {
    PackedFrames made{.frames = frames_};
    std::ranges::transform(packed_, made.streams.begin(), &Deflater::finish);
    return made;
}

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
    row("Speed of the tow", fmt::format("{:.4g} m/s", scenario.drift()));
    row("Structure", scenario.structure.shape.words().text());
    row("Channel", fmt::format("{:g} m wide", 2 * field.half_width));
    row("Time step", fmt::format("{:g} s", scenario.general.time_step));
    return rows;
}

/// Time, x, z, yaw, y, pitch and roll of the structure in each frame; null where it is towed straight on.
json poses(const Recording& recording) {
    const Scenario& scenario = recording.subject().scenario;
    if (scenario.towed_straight() && !scenario.field.level_pushed) return nullptr;
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

/// What there are histories of beside the load.
std::vector<AskedOf> of_hull(const HullHistory& hull) {
    std::vector<AskedOf> all;
    if (!hull.mooring_force.empty()) all = {AskedOf::mooring_force, AskedOf::offset};
    if (!hull.tension.empty()) all.push_back(AskedOf::tension);
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
    json found{{"from", from},
               {"to", to},
               {"surge", points(loads.surge)},
               {"sway", points(loads.sway)},
               {"heave", points(loads.heave)}};
    for (const AskedOf of : of_hull(recording.outcome().hull))
        found[std::string{name_of(of)}] =
            points(asked_history({of, recording.subject().asked.averaging}, loads, recording.outcome().hull, step));
    return found;
}

/// What the figure can show of a hull that gives way, beside the load: key, words and unit; first what is asked.
json hull_histories(const Recording& recording) {
    const Asked& asked = recording.subject().asked;
    json all = json::array();
    for (const AskedOf of : of_hull(recording.outcome().hull)) {
        const Asked one{of, asked.averaging};
        all.push_back({{"key", name_of(of)}, {"words", one.words()}, {"unit", one.unit()}, {"asked", of == asked.of}});
    }
    return all;
}

/// Broken ones and all, of each frame.
json counts(const std::vector<FloeCounts>& floes) {
    json all = json::array();
    for (const FloeCounts& one : floes) all.push_back({one.broken, one.all});
    return all;
}

/// A JSON object; its names are read by page_assets/data.js. SI units.
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
        {"floes_there", counts(frames.floes)},
        {"sheet", scenario.arrangement.level()},
        {"ice", ice(subject.floes)},
        {"structure", structure(scenario.structure.shape)},
        {"tow", {{"start", scenario.structure.start}, {"speed", scenario.drift()}}},
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
        {"hull_histories", hull_histories(recording)},
        {"histories", {history(recording, 0, run), history(recording, begin, end)}}};
    return header.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Every `stride`-th frame and the last; nothing once they take more than `most` bytes, with an estimate of the whole.
struct Attempt {
    std::optional<PackedFrames> frames;
    double expected = 0;  // bytes
};

Attempt pack(const Recording& recording, const Quanta& quanta, int stride, std::size_t most) {
    FramePacker packer(quanta, static_cast<int>(recording.layout().elements.size()));
    Frame frame;
    std::vector<FloeCounts> floes;
    const Scenario& scenario = recording.subject().scenario;
    const int last = recording.frames() - 1;
    for (int i = 0; i <= last; i = i == last ? last + 1 : std::min(i + stride, last)) {
        recording.read(i, frame);
        packer.add(frame);
        if (scenario.arrangement.level())
            floes.push_back(count_pieces(frame));
        else if (scenario.field.endless())
            floes.push_back(count_floes(frame, recording.layout(), recording.outcome().breaks));
        if (packer.size() > most) return {std::nullopt, static_cast<double>(packer.size()) * (last + 1) / (i + 1)};
    }
    PackedFrames frames = packer.finish();
    frames.floes = std::move(floes);
    std::size_t size = 0;
    for (const Bytes& stream : frames.streams) size += stream.size();
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
                page << markup_escaped(
                    fmt::format("{}: case {}, member {}", subject.campaign, subject.case_name, subject.member));
            else if (name == "header")
                page << in_a_script(page_header(recording, quanta, frames, options.start));
            else if (name == "frames")
                for (std::size_t k = 0; k < stream_names.size(); ++k)
                    write_stream(page, stream_names[k], frames.streams[k]);
            else
                page << asset(name).value();
        });
}

void write_replay_page(const std::filesystem::path& path, const Recording& recording, const PageOptions& options) {
    std::ofstream file(path, std::ios::binary);
    if (file) write_replay_page(file, recording, options);
    file.close();
    if (!file) throw not_written(path, std::strerror(errno));
}

}  // namespace floes
