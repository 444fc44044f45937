#include "member/array_output.hpp"

#include <fmt/format.h>

#include "member/design_of.hpp"
#include "statistics/load_map.hpp"

namespace floes {

namespace {

std::vector<double> counted_to(std::size_t count) {
    std::vector<double> places(count);
    for (std::size_t k = 0; k < count; ++k) places[k] = static_cast<double>(k);
    return places;
}

template <auto middle, std::size_t count>
std::vector<double> middles(const Scenario&) {
    std::vector<double> places(count);
    for (std::size_t k = 0; k < count; ++k) places[k] = middle(k);
    return places;
}

/// Ends of what the values of a history are of.
std::vector<double> history_times(const Scenario& scenario) {
    const int stride = scenario.analysis.history_stride;
    const double step = scenario.general.time_step * stride;
    std::vector<double> times(static_cast<std::size_t>(scenario.step_count() / stride));
    for (std::size_t k = 0; k < times.size(); ++k) times[k] = static_cast<double>(k + 1) * step;
    return times;
}

/// Of the values of a history, which members have where `has` holds of the scenario.
template <auto has>
constexpr ArrayAxis history_axis(std::string_view key, std::string_view long_name) {
    const auto places = [](const Scenario& scenario) {
        return has(scenario) ? history_times(scenario) : std::vector<double>{};
    };
    return {.key = key,
            .unit = "s",
            .long_name = long_name,
            .kind = AxisKind::counted,
            .places = places,
            .whole_numbers = false,
            .unlike = "number of the value from 1; times /cases/time_step and /cases/history_stride"};
}

constexpr const char* pose_words[]{"x", "z", "yaw"};

constexpr auto property_words = [] {
    std::array<const char*, floe_properties.size()> words{};
    for (std::size_t k = 0; k < words.size(); ++k) words[k] = floe_properties[k].name;
    return words;
}();

const auto response_words = [] {
    std::array<const char*, design_ofs.size() - 1> words{};
    for (std::size_t k = 0; k < words.size(); ++k) words[k] = design_ofs[k + 1].word.data();
    return words;
}();

}  // namespace

const ArrayAxis segment_axis{
    "segment", "1", "equal part of the analysis window", AxisKind::counted,
    [](const Scenario& scenario) { return counted_to(static_cast<std::size_t>(scenario.analysis.segments)); }};

const ArrayAxis level_axis{"level",
                           "N",
                           "surge load that steps are counted above",
                           AxisKind::placed,
                           [](const Scenario& scenario) { return scenario.analysis.exceedance_levels; },
                           false};

const ArrayAxis averaging_axis{"averaging_time",
                               "s",
                               "time that the surge load is averaged over",
                               AxisKind::placed,
                               [](const Scenario& scenario) { return scenario.averaging_times(); },
                               false};

const ArrayAxis peak_axis{"peak", "1", "declustered peak of a member, the highest first", AxisKind::longest};

const ArrayAxis floe_axis{"floe", "1", "floe of an arrangement", AxisKind::counted, [](const Scenario& scenario) {
                              return counted_to(static_cast<std::size_t>(scenario.field.floes));
                          }};

const ArrayAxis coordinate_axis{"coordinate",
                                "1",
                                "coordinate of a floe's pose",
                                AxisKind::fixed,
                                [](const Scenario&) { return counted_to(std::size(pose_words)); },
                                true,
                                pose_words};

const ArrayAxis property_axis{
    "property",
    "1",
    "property of a floe",
    AxisKind::counted,
    [](const Scenario& scenario) { return counted_to(floes_may_differ(scenario) ? property_words.size() : 0); },
    true,
    property_words};

const ArrayAxis part_axis{"part", "1", "part of the structure, by /cases/parts", AxisKind::counted,
                          [](const Scenario& scenario) {
                              const std::size_t parts = scenario.structure.shape.parts().size();
                              return counted_to(parts > 1 ? parts : 0);
                          }};

const ArrayAxis time_axis =
    history_axis<[](const Scenario&) { return true; }>("time", "end of the time steps of a value");

const ArrayAxis bed_axis = history_axis<[](const Scenario& scenario) { return scenario.water.has_bed(); }>(
    "bed_time", "end of the time steps of a value, of water with a bed");

const ArrayAxis motion_axis = history_axis<[](const Scenario& scenario) { return !scenario.towed_straight(); }>(
    "motion_time", "end of the time steps of a value, of structures that are not towed straight on");

const ArrayAxis mooring_axis = history_axis<[](const Scenario& scenario) { return scenario.moorings.give_way(); }>(
    "mooring_time", "end of the time steps of a value, of moored structures");

const ArrayAxis line_use_axis = history_axis<[](const Scenario& scenario) {
    return scenario.moorings.give_way() && has_lines_that_break(scenario.moorings);
}>("line_use_time", "end of the time steps of a value, of structures on lines that break");

const ArrayAxis thrust_axis = history_axis<[](const Scenario& scenario) {
    return scenario.moorings.give_way() && scenario.moorings.thrusters.any();
}>("thrust_time", "end of the time steps of a value, of structures with thrusters");

const ArrayAxis floating_axis =
    history_axis<[](const Scenario& scenario) { return scenario.moorings.give_way() && scenario.moorings.floats(); }>(
        "floating_time", "end of the time steps of a value, of structures that heave, pitch or roll");

const ArrayAxis line_axis{
    "mooring_line", "1", "mooring line, in the order of moorings.lines and hanging_lines", AxisKind::counted,
    [](const Scenario& scenario) {
        return counted_to(scenario.moorings.give_way() ? scenario.moorings.line_count() : std::size_t{0});
    }};

const ArrayAxis response_axis{
    "response",
    "1",
    "how a structure gives way, or what holds it; units: N, m, rad, 1",
    AxisKind::counted,
    [](const Scenario& scenario) {
        return counted_to(scenario.moorings.give_way() ? response_words.size() : std::size_t{0});
    },
    true,
    response_words};

const ArrayAxis height_axis{"height",
                            "1",
                            "height on the structure over its depth, from the keel",
                            AxisKind::fixed,
                            middles<middle_height, LoadMap::heights>,
                            false};

const ArrayAxis angle_axis{"angle",
                           "degree",
                           "angle round the structure's axis, 0 ahead, positive towards +z",
                           AxisKind::fixed,
                           middles<middle_angle, LoadMap::angles>,
                           false};

const ArrayAxis tow_axis{
    "tow", "1", "time in the window over its length", AxisKind::fixed, middles<middle_part, LoadMap::parts>, false};

const ArrayAxis break_axis{"break", "1", "failed joint, a row of /breaks",  AxisKind::listed, nullptr,
                           true,    {},  "member in which the joint failed"};

const ArrayAxis piece_axis{"piece", "1", "piece of a floe, a row of /pieces",        AxisKind::listed, nullptr,
                           true,    {},  "member in which the floe fell into pieces"};

void clear_arrays(MemberResult& result) {
    for (const ArrayOutput& one : array_outputs)
        if (one.axes[0] != nullptr) one.access.set(result, {{0, 0}, {}});
}

namespace {

std::uint8_t read_below(ByteReader& in, std::uint8_t limit) {
    const std::uint8_t value = in.u8();
    if (value >= limit) throw RunError("a stored member has an unknown state; it was damaged");
    return value;
}

void write_quantities(ByteWriter& out, const MemberOutputs& outputs) {
    out.u32(static_cast<std::uint32_t>(quantities.size()));
    for (const Quantity& one : quantities) {
        out.text(one.key.view());
        out.f64(one.of(outputs));
    }
}

/// Keys unknown to this version are skipped.
void read_quantities(ByteReader& in, MemberOutputs& outputs) {
    outputs = unmeasured(0);
    for (std::uint32_t left = in.u32(); left > 0; --left) {
        const Quantity* known = find_quantity(in.text());
        const double value = in.f64();
        if (known == nullptr) continue;
        if (!known->holds(value)) throw RunError("a stored member has a count beyond all counts; it was damaged");
        known->place.set(outputs, value);
    }
}

}  // namespace

void write(ByteWriter& out, const MemberResult& result) {
    out.u8(static_cast<std::uint8_t>(result.status));
    out.text(result.reason);
    write_quantities(out, result);
    out.u8(result.load.steady ? 1 : 0);
    out.f64(result.wall_time);
    out.f64(result.cpu_time);
}

MemberResult read_member_result(ByteReader& in) {
    MemberResult result;
    result.status = static_cast<MemberStatus>(read_below(in, 2));
    result.reason = in.text();
    read_quantities(in, result);
    result.load.steady = read_below(in, 2) == 1;
    result.wall_time = in.f64();
    result.cpu_time = in.f64();
    return result;
}

void write_arrays(ByteWriter& out, const MemberResult& result) {
    for (const ArrayOutput& one : array_outputs) {
        const ArrayValues array = one.access.get(result);
        if (array.empty()) continue;
        out.text(one.path);
        out.u8(static_cast<std::uint8_t>(array.sizes.size()));
        for (const std::size_t size : array.sizes) out.u64(size);
        out.doubles(array.values);
    }
    out.text("");
}

void read_arrays(ByteReader& in, MemberResult& result) {
    for (std::string path = in.text(); !path.empty(); path = in.text()) {
        ArrayValues array;
        array.sizes.resize(in.u8());
        for (std::size_t& size : array.sizes) size = in.u64();
        array.values = in.doubles();
        const std::size_t number = array_number(path);
        if (number == array_outputs.size()) continue;
        check_sizes(array_outputs[number], array.sizes, array.values.size());
        array_outputs[number].access.set(result, array);
    }
}

void check_sizes(const ArrayOutput& array, std::span<const std::size_t> sizes, std::uint64_t values) {
    static const Scenario any;  // fixed axes are the same in all
    std::size_t axes = 0;
    std::uint64_t product = 1;
    bool right = true;
    for (const ArrayAxis* axis : array.axes) {
        if (axis == nullptr) break;
        if (axes >= sizes.size()) break;
        const std::size_t size = sizes[axes++];
        right = right && (axis->kind != AxisKind::fixed || size == axis->places(any).size()) && size <= values;
        product *= size;
    }
    const auto wanted =
        static_cast<std::size_t>(std::ranges::count_if(array.axes, [](const auto* one) { return one != nullptr; }));
    if (!right || axes != wanted || sizes.size() != wanted || product != values)
        throw RunError(fmt::format("a stored member has {} with sizes that do not fit; it was damaged", array.path));
}

}  // namespace floes
