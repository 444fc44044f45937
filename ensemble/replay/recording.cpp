// Recordings in HDF5: read, and written.

#include "replay/recording.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "hdf5/pages.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

constexpr double most_elements = 1e6;  // of a floe; a damaged number is not to ask for all memory

/// The roll of a field without end, which the file has.
FloeSet read_own_floes(hid_t file, const Scenario& scenario) {
    const auto length = hdf5::read_values<double>(file, "floes/length");
    const std::size_t count = length.size();
    const auto breadth = hdf5::read_column<double>(file, "floes/breadth", count);
    const auto thickness = hdf5::read_column<double>(file, "floes/thickness", count);
    const auto element = hdf5::read_column<double>(file, "floes/element", count);
    const auto pattern = hdf5::read_column<std::int32_t>(file, "floes/pattern", count);
    std::vector<double> x;
    std::vector<double> z;
    std::size_t corners = 0;
    if (hdf5::exists(file, "floes/corner_x")) {
        x = hdf5::read_table<double>(file, "floes/corner_x", count, corners);
        z = hdf5::read_column<double>(file, "floes/corner_z", x.size());
    }
    std::vector<SingleFloe> floes;
    for (std::size_t i = 0; i < count; ++i) {
        FloeShape shape{length[i], breadth[i], thickness[i], element[i], {}, pattern[i]};
        for (std::size_t k = corners * i; k < corners * (i + 1) && !std::isnan(x[k]); ++k)
            shape.outline.push_back({x[k], z[k]});
        const double elements = shape.element > 0 ? shape.length * shape.breadth / (shape.element * shape.element) : 0;
        if (!(elements >= 0.5 && elements < most_elements) || !(shape.thickness > 0))
            hdf5::refuse_damaged(file, fmt::format("floes has a floe {} that there cannot be", i));
        floes.push_back({{}, std::move(shape), scenario.material()});
    }
    return gathered(floes);
}

void check_floes(hid_t file, const FloeSet& floes, const std::vector<std::int32_t>& floe) {
    const IceLayout layout(floes);
    if (!std::ranges::equal(floe, layout.elements, {}, {}, &IceLayout::LaidElement::floe))
        hdf5::refuse_damaged(file, "ice/floe has other elements than its floes");
}

/// The floes of the scenario, as many as the file has. `floe`: of each element.
FloeSet read_floes(hid_t file, Scenario scenario, const Draw& draw, const std::vector<std::int32_t>& floe) {
    FloeSet floes = floes_of(scenario, draw);
    const std::size_t count = floe.empty() || floe.back() < 0 ? 0 : static_cast<std::size_t>(floe.back()) + 1;
    if (!floes_may_differ(scenario) && count <= floe.size()) {
        scenario.field.floes = static_cast<int>(count);
        floes = floes_of(scenario, draw);
    }
    check_floes(file, floes, floe);
    return floes;
}

/// A history of a hull that gives way, as the file has it.
struct HullColumn {
    const char* path;
    const char* unit;
    const char* text;
    std::vector<double> HullHistory::*values;
};
constexpr std::array<HullColumn, 4> hull_columns{
    {{"history/mooring_force", "N", "horizontal resultant of springs, lines and turret", &HullHistory::mooring_force},
     {"history/offset", "m", "horizontal offset of the turret, without one of the hull's axis", &HullHistory::offset},
     {"history/structure_yaw", "rad", "positive where +z turns to +x", &HullHistory::yaw},
     {"history/largest_tension", "N", "of the line that has most; 0 once all have broken", &HullHistory::tension}}};

/// Recordings before layout 1.6 show the load of a step.
Asked read_asked(hid_t file) {
    if (!hdf5::has_attribute(file, "largest_of")) return {};
    const std::string name = hdf5::read_text_attribute(file, "largest_of");
    const std::optional<AskedOf> of = asked_of(name);
    if (!of) hdf5::refuse_damaged(file, "largest_of is none of " + name);
    const int milliseconds = hdf5::read_int_attribute(file, "averaging_ms").at(0);
    return {*of, milliseconds / 1e3};
}

/// Both throw InputError for files that are damaged.
RecordingSubject read_subject(hid_t file) {
    RecordingSubject subject;
    subject.campaign = hdf5::read_text_attribute(file, "campaign");
    subject.fingerprint = hdf5::read_text_attribute(file, "fingerprint");
    subject.case_name = hdf5::read_text_attribute(file, "case");
    subject.member = hdf5::read_int_attribute(file, "member").at(0);
    subject.arrangement = hdf5::read_int_attribute(file, "arrangement").at(0);
    subject.asked = read_asked(file);
    subject.configuration = hdf5::read_text(file, "configuration");
    const Campaign campaign = read_campaign({subject.configuration, "its configuration", {}}, nullptr);
    subject.scenario = campaign.cases.at(0).scenario;
    const Draw draw{arrangement_seed(campaign, 0), static_cast<std::uint32_t>(subject.arrangement)};
    const auto floe = hdf5::read_values<std::int32_t>(file, "ice/floe");
    if (!subject.scenario.field.endless()) {
        subject.floes = read_floes(file, subject.scenario, draw, floe);
        return subject;
    }
    subject.floes = read_own_floes(file, subject.scenario);
    check_floes(file, subject.floes, floe);
    const auto way = hdf5::read_values<double>(file, "frames/structure");
    if (!way.empty()) subject.way = {std::ranges::min(way), std::ranges::max(way)};
    return subject;
}

RecordingOutcome read_outcome(hid_t file, const IceLayout& layout) {
    RecordingOutcome outcome;
    outcome.history.surge = hdf5::read_values<double>(file, "history/surge_load");
    const std::size_t steps = outcome.history.surge.size();
    outcome.history.sway = hdf5::read_column<double>(file, "history/sway_load", steps);
    outcome.history.heave = hdf5::read_column<double>(file, "history/heave_load", steps);
    for (const HullColumn& column : hull_columns)
        if (hdf5::exists(file, column.path))
            outcome.hull.*column.values = hdf5::read_column<double>(file, column.path, steps);
    const std::size_t joints = layout.joints.size();
    const auto time = hdf5::read_column<double>(file, "joints/failure_time", joints);
    const auto last_mode = static_cast<std::int8_t>(std::size(failure_mode_names) - 1);
    const auto mode = hdf5::read_numbers<std::int8_t>(file, "joints/failure_mode", joints, -1, last_mode);
    for (std::size_t k = 0; k < joints; ++k) {
        if (std::isnan(time[k])) continue;
        if (mode[k] < 0) hdf5::refuse_damaged(file, "joints/failure_mode has no mode for a joint that failed");
        const std::size_t floe = layout.floe_of_joint(k);
        outcome.breaks.push_back({time[k], static_cast<int>(floe), static_cast<int>(k - layout.first_joint[floe]),
                                  static_cast<FailureMode>(mode[k])});
    }
    std::ranges::stable_sort(outcome.breaks, {}, &BreakEvent::time);
    return outcome;
}

Vec3 vector_at(std::span<const float> values, std::size_t index) {
    return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

}  // namespace

bool is_recording(const std::filesystem::path& path) {
    const hdf5::QuietErrors quiet;
    try {
        return hdf5::is_of_kind(hdf5::open_for_reading(path).id(), recording_kind);
    } catch (const InputError&) {
        return false;  // no such file, or no HDF5 file
    }
}

namespace {

hdf5::Handle opened(const std::filesystem::path& path) {
    hdf5::Handle file = hdf5::open_for_reading(path);
    hdf5::check_kind(file.id(), recording_kind, path);
    return file;
}

ElementColumns<hdf5::RowReader> element_readers(hid_t file) {
    const std::string group = hdf5::exists(file, "states") ? "states/" : "frames/";
    return {{file, group + "position"},
            {file, group + "orientation"},
            {file, group + "velocity"},
            {file, group + "piece"},
            {file, group + "utilisation"}};
}

}  // namespace

Recording::States::States(hid_t file)
    : first(hdf5::read_values<std::int32_t>(file, "frames/first_state")),
      count(hdf5::read_values<std::int32_t>(file, "frames/states")),
      element(file, "states/element") {}

Recording::Recording(const std::filesystem::path& path)
    : file_(opened(path)),
      subject_(read_subject(file_.id())),
      layout_(subject_.floes),
      elements_(element_readers(file_.id())),
      contacts_{{file_.id(), "contacts/element"},
                {file_.id(), "contacts/other"},
                {file_.id(), "contacts/point"},
                {file_.id(), "contacts/normal_force"},
                {file_.id(), "contacts/friction_force"}} {
    times_ = hdf5::read_values<double>(file_.id(), "time");
    outcome_ = read_outcome(file_.id(), layout_);
    step_ = hdf5::read_values<std::int32_t>(file_.id(), "frames/step");
    for (const FrameNumber& one : frame_numbers) {
        const std::string name = fmt::format("frames/{}", one.name);
        numbers_.push_back(one.late && !hdf5::exists(file_.id(), name) ? std::vector<double>(times_.size(), 0.0)
                                                                       : hdf5::read_values<double>(file_.id(), name));
    }
    first_contact_ = hdf5::read_values<std::int32_t>(file_.id(), "frames/first_contact");
    contact_count_ = hdf5::read_values<std::int32_t>(file_.id(), "frames/contacts");
    if (subject_.scenario.field.endless()) states_.emplace(file_.id());
    if (hdf5::exists(file_.id(), "frames/line_tension"))
        lines_.emplace(LineColumns<hdf5::RowReader>{{file_.id(), "frames/line_fairlead"},
                                                    {file_.id(), "frames/line_anchor"},
                                                    {file_.id(), "frames/line_tension"}});
    if (times_.empty()) throw InputError(fmt::format("{} has no frames.", path.string()));
    check_sizes();
}

void Recording::check_sizes() const {
    if (lines_) {
        const std::size_t lines = lines_->tension.width();
        hdf5::check_count(file_.id(), "frames/line_tension", lines, subject_.scenario.moorings.line_count());
        hdf5::check_count(file_.id(), "frames/line_fairlead", lines_->fairlead.width(), 3 * lines);
        hdf5::check_count(file_.id(), "frames/line_anchor", lines_->anchor.width(), 3 * lines);
    }
    const std::size_t count = states_ ? 1 : layout_.elements.size();
    if (states_) {
        hdf5::check_count(file_.id(), "frames/first_state", states_->first.size(), times_.size());
        hdf5::check_count(file_.id(), "frames/states", states_->count.size(), times_.size());
    }
    hdf5::check_count(file_.id(), "frames/position", elements_.position.width(), 3 * count);
    hdf5::check_count(file_.id(), "frames/orientation", elements_.orientation.width(), 4 * count);
    hdf5::check_count(file_.id(), "frames/velocity", elements_.velocity.width(), 3 * count);
    hdf5::check_count(file_.id(), "frames/utilisation", elements_.utilisation.width(), count);
    hdf5::check_count(file_.id(), "frames/piece", elements_.piece.width(), count);
    for (const hdf5::RowReader<float>* one : {&contacts_.point, &contacts_.normal, &contacts_.friction})
        hdf5::check_count(file_.id(), "a vector of contacts", one->width(), 3);
    for (const std::vector<double>& one : numbers_)
        hdf5::check_count(file_.id(), "a number of frames", one.size(), times_.size());
    for (const std::vector<std::int32_t>* one : {&step_, &first_contact_, &contact_count_})
        hdf5::check_count(file_.id(), "a number of frames", one->size(), times_.size());
}

int Recording::nearest(double time) const {
    const auto nearest = std::ranges::min_element(times_, {}, [time](double one) { return std::abs(one - time); });
    return static_cast<int>(nearest - times_.begin());
}

StructurePose Recording::moment(std::size_t number, Vec3& load) const {
    StructurePose structure;
    for (std::size_t k = 0; k < frame_numbers.size(); ++k)
        frame_numbers[k].of(structure, load) = frame_numbers[k].sign * numbers_[k].at(number);
    return structure;
}

StructurePose Recording::structure(int frame) const {
    Vec3 load = Vec3::Zero();
    return moment(static_cast<std::size_t>(frame), load);
}

std::vector<FrameLine> Recording::lines(int frame) const {
    std::vector<FrameLine> held;
    if (!lines_) return held;
    const auto number = static_cast<std::size_t>(frame);
    const std::span<const float> fairlead = lines_->fairlead.read(number);
    const std::span<const float> anchor = lines_->anchor.read(number);
    const std::span<const float> tension = lines_->tension.read(number);
    for (std::size_t k = 0; k < tension.size(); ++k) {
        if (std::isnan(tension[k])) continue;
        held.push_back({static_cast<int>(k), vector_at(fairlead, k), vector_at(anchor, k), tension[k]});
    }
    return held;
}

Frame Recording::read(int number) const {
    Frame frame;
    read(number, frame);
    return frame;
}

void Recording::read(int number, Frame& frame) const {
    const auto at = static_cast<std::size_t>(number);
    frame.step = step_.at(at);
    frame.time = times_.at(at);
    frame.structure = moment(at, frame.load);
    read_elements(at, frame);
    read_contacts(at, frame);
    frame.lines = lines(number);
}

void Recording::read_elements(std::size_t number, Frame& frame) const {
    std::size_t row = number;
    std::size_t rows = 1;
    frame.ids.clear();
    if (states_) {
        row = static_cast<std::size_t>(states_->first[number]);
        rows = static_cast<std::size_t>(states_->count[number]);
        for (const std::int32_t id : states_->element.read(row, rows)) {
            if (id < 0 || static_cast<std::size_t>(id) >= layout_.elements.size())
                hdf5::refuse_damaged(file_.id(), fmt::format("states/element has the value {}", id));
            frame.ids.push_back(id);
        }
    }
    const std::span<const float> position = elements_.position.read(row, rows);
    const std::span<const float> orientation = elements_.orientation.read(row, rows);
    const std::span<const float> velocity = elements_.velocity.read(row, rows);
    frame.elements.resize(states_ ? rows : layout_.elements.size());
    for (std::size_t k = 0; k < frame.elements.size(); ++k) {
        const float* q = &orientation[4 * k];
        frame.elements[k] = {.position = vector_at(position, k),
                             .rotation = Quat(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix(),
                             .velocity = vector_at(velocity, k)};
    }
    const std::span<const float> utilisation = elements_.utilisation.read(row, rows);
    const std::span<const std::int32_t> pieces = elements_.piece.read(row, rows);
    frame.utilisation.assign(utilisation.begin(), utilisation.end());
    frame.pieces.assign(pieces.begin(), pieces.end());
}

void Recording::read_contacts(std::size_t number, Frame& frame) const {
    const auto first = static_cast<std::size_t>(first_contact_.at(number));
    const auto count = static_cast<std::size_t>(contact_count_.at(number));
    const std::span<const std::int32_t> element = contacts_.element.read(first, count);
    const std::span<const std::int32_t> other = contacts_.other.read(first, count);
    const std::span<const float> point = contacts_.point.read(first, count);
    const std::span<const float> normal = contacts_.normal.read(first, count);
    const std::span<const float> friction = contacts_.friction.read(first, count);
    frame.contacts.clear();
    for (std::size_t k = 0; k < count; ++k)
        frame.contacts.push_back(
            {element[k], other[k], vector_at(point, k), vector_at(normal, k), vector_at(friction, k)});
}

namespace {

using hdf5::Handle;
using hdf5::Scale;

Scale words_scale(hid_t parent, const char* name, const char* long_name, const std::vector<std::string>& words) {
    return hdf5::write_scale(parent, {name, "1", long_name}, words);
}

void write_root(hid_t file, const RecordingSubject& subject) {
    const auto write_number = [file](const char* name, std::int32_t value) {
        hdf5::write_attribute(file, name, std::span<const std::int32_t>(&value, 1));
    };
    hdf5::write_kind(file, recording_kind,
                     fmt::format("{}: member {}, case {}, arrangement {}", subject.campaign, subject.member,
                                 subject.case_name, subject.arrangement));
    hdf5::write_attribute(file, "campaign", subject.campaign);
    hdf5::write_attribute(file, "fingerprint", subject.fingerprint);
    hdf5::write_attribute(file, "case", subject.case_name);
    write_number("member", subject.member);
    write_number("arrangement", subject.arrangement);
    hdf5::write_attribute(file, "largest_of", std::string(name_of(subject.asked.of)));
    write_number("averaging_ms", static_cast<std::int32_t>(std::lround(1e3 * subject.asked.averaging)));
    hdf5::write_attribute(file, "time_step", subject.scenario.general.time_step);
}

void write_structure(hid_t file, const Shape& shape) {
    const Handle group = hdf5::create_group(file, "structure");
    const std::vector<std::vector<double>> rows = shape.profile();
    if (rows.empty()) return;  // the configuration has its sizes or pieces
    const Scale point =
        hdf5::write_index_scale(group.id(), "profile_point", "point of the profile, from the bottom up", rows.size());
    for (std::size_t k = 0; k < Shape::columns.size(); ++k) {
        std::vector<double> column;
        for (const std::vector<double>& row : rows) column.push_back(row[k]);
        const ShapeColumn& about = Shape::columns[k];
        hdf5::write_values(group.id(), {std::string(about.name), std::string(about.unit), std::string(about.text)},
                           {point}, column);
    }
}

void write_sheets(hid_t file, const std::vector<IceSheet>& all, const Scale& coordinate) {
    const Handle group = hdf5::create_group(file, "ice_sheets");
    const Scale sheet = hdf5::write_index_scale(group.id(), "sheet", "fixed box of ice along the channel", all.size());
    std::vector<double> centres;
    std::vector<double> sides;
    for (const IceSheet& one : all) {
        const Vec3 whole = 2 * one.half_extents;
        centres.insert(centres.end(), one.centre.begin(), one.centre.end());
        sides.insert(sides.end(), whole.begin(), whole.end());
    }
    hdf5::write_values(group.id(), {"centre", "m", "middle of each sheet"}, {sheet, coordinate}, centres);
    hdf5::write_values(group.id(), {"sides", "m", "length of its sides"}, {sheet, coordinate}, sides);
}

void write_history(hid_t file, const RecordingOutcome& outcome, double time_step) {
    const LoadHistory& history = outcome.history;
    std::vector<double> end;
    for (std::size_t k = 0; k < history.surge.size(); ++k) end.push_back(static_cast<double>(k + 1) * time_step);
    const Handle group = hdf5::create_group(file, "history");
    const Scale step = hdf5::write_scale(file, {"step_end", "s", "end of each time step"}, end);
    hdf5::write_values(group.id(), {"surge_load", "N", "positive against the tow"}, {step}, history.surge);
    hdf5::write_values(group.id(), {"sway_load", "N", "positive towards +z"}, {step}, history.sway);
    hdf5::write_values(group.id(), {"heave_load", "N", "positive up"}, {step}, history.heave);
    for (const HullColumn& column : hull_columns)
        if (const std::vector<double>& values = outcome.hull.*column.values; !values.empty())
            hdf5::write_values(file, {column.path, column.unit, column.text}, {step}, values);
}

/// None of a field without end, whose elements are known at the end.
std::optional<Scale> elements_known(hid_t file, const RecordingSubject& subject) {
    if (subject.scenario.field.endless()) return {};
    return element_scale(file, IceLayout(subject.floes));
}

std::optional<Scale> line_scale(hid_t file, const Scenario& scenario) {
    const std::size_t lines = scenario.moorings.give_way() ? scenario.moorings.line_count() : 0;
    if (lines == 0) return {};
    return hdf5::write_index_scale(file, "mooring_line",
                                   "mooring line, in the order of moorings.lines and hanging_lines", lines);
}

}  // namespace

RecordingWriter::Open::Open(hid_t file, const RecordingSubject& subject)
    : scales{words_scale(file, "coordinate", "axis of a vector", {"x", "y", "z"}),
             words_scale(file, "quaternion", "part of a quaternion", {"w", "x", "y", "z"}),
             elements_known(file, subject), line_scale(file, subject.scenario)},
      series(file, scales) {
    write_root(file, subject);
    hdf5::write_text(file, {"configuration", "1", "the member's case as a campaign, TOML"}, subject.configuration);
    write_structure(file, subject.scenario.structure.shape);
}

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const RecordingSubject& subject)
    : path_(path), aside_(path.string() + ".tmp"), subject_(subject) {
    file_.emplace(hdf5::create_file(aside_));
    open_.emplace(file_->id(), subject_);
}

RecordingWriter::~RecordingWriter() {
    if (!file_) return;
    open_.reset();
    file_.reset();
    std::error_code ignored;
    std::filesystem::remove(aside_, ignored);
}

void RecordingWriter::add(const Frame& frame) {
    const double x = frame.structure.position.x();
    subject_.way = any_ ? Vec2(std::min(subject_.way.x(), x), std::max(subject_.way.y(), x)) : Vec2(x, x);
    any_ = true;
    open_->series.add(frame);
}

void RecordingWriter::finish(const RecordingOutcome& outcome, const FloeRoll& roll) {
    if (subject_.scenario.field.endless()) {
        subject_.floes = roll.floes();
        write_floes(file_->id(), subject_.floes, roll.numbers());
    }
    const IceLayout layout(subject_.floes);
    RecordScales& scales = open_->scales;
    if (!scales.element) scales.element.emplace(element_scale(file_->id(), layout));
    write_ice(file_->id(), subject_.scenario.floe, layout, scales);
    write_sheets(file_->id(), subject_.channel().sheets, scales.coordinate);
    write_joints(file_->id(), layout, outcome.breaks);
    write_history(file_->id(), outcome, subject_.scenario.general.time_step);
    open_->series.finish();
    hdf5::write_contents_digests(file_->id());
    open_.reset();  // only then does closing the file write everything
    file_->close("H5Fclose", path_.string());
    file_.reset();
    hdf5::append_page_digests(aside_);
    sync_data(open_file(aside_, O_RDWR));
    rename_into_place(aside_, path_);
}

std::vector<std::uint8_t> broken_floes(const std::vector<BreakEvent>& breaks, int floes, double time) {
    std::vector<std::uint8_t> broken(static_cast<std::size_t>(floes), 0);
    for (const BreakEvent& event : breaks) {
        if (event.time > time) break;
        broken[static_cast<std::size_t>(event.floe)] = 1;
    }
    return broken;
}

FloeCounts count_floes(const Frame& frame, const IceLayout& layout, const std::vector<BreakEvent>& breaks) {
    const std::vector<std::uint8_t> broken = broken_floes(breaks, layout.floes(), frame.time);
    FloeCounts counts;
    int last = -1;  // elements of a floe stand together
    for (std::size_t k = 0; k < frame.elements.size(); ++k) {
        const int floe = layout.elements[frame.id(k)].floe;
        if (floe == last) continue;
        last = floe;
        ++counts.all;
        counts.broken += broken[static_cast<std::size_t>(floe)];
    }
    return counts;
}

namespace {

std::map<int, int> elements_of_pieces(const Frame& frame) {
    std::map<int, int> elements;
    for (const int piece : frame.pieces) ++elements[piece];
    return elements;
}

}  // namespace

FloeCounts count_pieces(const Frame& frame) {
    const auto all = static_cast<int>(elements_of_pieces(frame).size());
    return {all - 1, all};
}

int largest_piece(const Frame& frame) {
    const std::map<int, int> elements = elements_of_pieces(frame);
    return std::ranges::max_element(elements, {}, [](const auto& one) { return one.second; })->first;
}

Channel RecordingSubject::channel() const {
    Channel channel = make_channel(scenario, floes);
    if (!scenario.field.endless()) return channel;
    channel.begin = std::max(channel.begin, way.x() - seen_behind());
    channel.end = way.y() + seen_ahead();
    for (IceSheet& sheet : channel.sheets) {
        sheet.centre.x() = 0.5 * (channel.begin + channel.end);
        sheet.half_extents.x() = 0.5 * (channel.end - channel.begin);
    }
    return channel;
}

}  // namespace floes
