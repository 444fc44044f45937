#pragma once
// The arrays of a member: their axes, how they are taken out of a result, the list of them all, and results as bytes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/bytes.hpp"
#include "core/error.hpp"
#include "member/quantity.hpp"
#include "member/result.hpp"
#include "scenario/scenario.hpp"
#include "simulation/record.hpp"

namespace floes {

/// Whose the places along an axis are.
enum class AxisKind : std::uint8_t {
    fixed,    ///< the same in every member
    counted,  ///< 0, 1, … as far as the scenario goes; a file has those of the case that goes farthest
    placed,   ///< values that the scenario gives; a file has those of all cases, rising
    longest,  ///< 0, 1, … as far as the member found any, then NaN; a file has those of the member that found most
    listed    ///< 0, 1, … as many as the member found; a file lists those of all members one after another
};

struct ArrayAxis {
    std::string_view key;  ///< name of the dimension in a file
    std::string_view unit;
    std::string_view long_name;
    AxisKind kind;
    std::vector<double> (*places)(const Scenario&) = nullptr;  ///< none of longest and listed
    bool whole_numbers = true;                                 ///< the places are 0, 1, …
    std::span<const char* const> words = {};                   ///< in place of numbers
    std::string_view owner = {};                               ///< of listed: what its column of members says
    std::string_view unlike = {};  ///< of counted: its meaning where cases differ in their places, and it counts from 1
};

extern const ArrayAxis segment_axis, level_axis, averaging_axis, peak_axis, floe_axis, coordinate_axis, property_axis,
    part_axis, time_axis, bed_axis, motion_axis, mooring_axis, thrust_axis, floating_axis, line_axis, height_axis,
    angle_axis, tow_axis, break_axis, piece_axis, response_axis, line_use_axis;

/// Those of which a member alone knows how far they go.
inline constexpr std::array<const ArrayAxis*, 3> found_axes{&peak_axis, &break_axis, &piece_axis};

// The values of one array of one member, and how they are taken out of its result and put back.

/// Row-major; as many values as the sizes multiply to. Without values: the member does not have the array.
struct ArrayValues {
    std::vector<std::size_t> sizes;  ///< one for each axis
    std::vector<double> values;

    bool empty() const { return values.empty(); }
};

struct ArrayAccess {
    ArrayValues (*get)(const MemberResult&);
    /// The array must have as many sizes as the list gives it axes. Throws RunError for what the field cannot hold.
    void (*set)(MemberResult&, const ArrayValues&);
};

/// Access to a field that holds fewer numbers than doubles: throws RunError for those that it cannot.
template <class Field>
Field as_field(double value) {
    if constexpr (std::is_same_v<Field, double>) {
        return value;
    } else {
        using Number = std::conditional_t<std::is_enum_v<Field>, std::int8_t, Field>;
        double most = std::numeric_limits<Number>::max();
        if constexpr (std::is_same_v<Field, FailureMode>) most = failure_mode_names.size() - 1;
        if (!(value >= 0 && value <= most && value == std::floor(value)))
            throw RunError("a stored member has a number that there is not; it was damaged");
        return static_cast<Field>(static_cast<Number>(value));
    }
}

/// A vector of numbers along one axis, reached by a chain of data members.
template <auto... Path>
constexpr ArrayAccess at_vector() {
    return {[](const MemberResult& result) {
                const std::vector<double>& field = (result.*....*Path);
                return ArrayValues{{field.size()}, field};
            },
            [](MemberResult& result, const ArrayValues& array) { (result.*....*Path) = array.values; }};
}

/// One number of each element of a vector.
template <auto Elements, auto Number>
constexpr ArrayAccess at_each() {
    return {[](const MemberResult& result) {
                ArrayValues array{{(result.*Elements).size()}, {}};
                for (const auto& one : result.*Elements) array.values.push_back(static_cast<double>(one.*Number));
                return array;
            },
            [](MemberResult& result, const ArrayValues& array) {
                auto& elements = result.*Elements;
                elements.resize(array.values.size());
                for (std::size_t k = 0; k < elements.size(); ++k)
                    elements[k].*Number =
                        as_field<std::remove_reference_t<decltype(elements[k].*Number)>>(array.values[k]);
            }};
}

/// A vector of numbers in each element of a vector; shorter ones are filled up with NaN, which is left out again.
template <auto Elements, auto Numbers>
constexpr ArrayAccess at_rows() {
    return {[](const MemberResult& result) {
                std::size_t width = 0;
                for (const auto& one : result.*Elements) width = std::max(width, (one.*Numbers).size());
                ArrayValues array{{(result.*Elements).size(), width}, {}};
                for (const auto& one : result.*Elements) {
                    array.values.insert(array.values.end(), (one.*Numbers).begin(), (one.*Numbers).end());
                    array.values.insert(array.values.end(), width - (one.*Numbers).size(),
                                        std::numeric_limits<double>::quiet_NaN());
                }
                return array;
            },
            [](MemberResult& result, const ArrayValues& array) {
                auto& elements = result.*Elements;
                elements.resize(array.sizes.at(0));
                for (std::size_t k = 0; k < elements.size(); ++k) {
                    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(k * array.sizes.at(1));
                    auto last = first + static_cast<std::ptrdiff_t>(array.sizes.at(1));
                    while (last != first && std::isnan(*(last - 1))) --last;
                    (elements[k].*Numbers).assign(first, last);
                }
            }};
}

/// Poses as rows of x, z and yaw.
template <auto Poses>
constexpr ArrayAccess at_poses() {
    return {[](const MemberResult& result) {
                ArrayValues array{{(result.*Poses).size(), 3}, {}};
                for (const PlanarPose& pose : result.*Poses)
                    array.values.insert(array.values.end(), {pose.x, pose.z, pose.yaw});
                return array;
            },
            [](MemberResult& result, const ArrayValues& array) {
                (result.*Poses).clear();
                for (std::size_t k = 0; k + 2 < array.values.size(); k += 3)
                    (result.*Poses).push_back({array.values[k], array.values[k + 1], array.values[k + 2]});
            }};
}

/// Rows of as many numbers as the second axis has places, one after another.
template <std::size_t columns, auto... Path>
constexpr ArrayAccess at_row_list() {
    ArrayAccess access = at_vector<Path...>();
    access.get = [](const MemberResult& result) {
        const std::vector<double>& field = (result.*....*Path);
        return ArrayValues{{field.size() / columns, columns}, field};
    };
    return access;
}

/// A single number, which has no axis.
template <auto Number>
constexpr ArrayAccess at_number() {
    return {[](const MemberResult& result) {
                return ArrayValues{{}, {result.*Number}};
            },
            [](MemberResult& result, const ArrayValues& array) { result.*Number = array.values.at(0); }};
}

// What array_output.hpp's list says of each array.

/// What the numbers are in a campaign file; everywhere else they are doubles.
enum class ArrayNumbers { real, index, flag };

/// How a campaign file keeps the values of a member.
enum class ArrayChunks {
    with_others,  ///< plain, many members together
    of_its_own    ///< compressed, a chunk a member, which the process that computed it makes
};

struct ArrayOutput {
    std::string_view path;  ///< group and name in the file, and its key in journals; only a name: in journals alone
    std::string_view unit;  ///< in the file
    std::string_view long_name;              ///< in the file and on its page
    std::array<const ArrayAxis*, 2> axes{};  ///< row-major; nullptr after the last
    ArrayAccess access;
    ArrayChunks chunks = ArrayChunks::with_others;
    bool in_table = false;        ///< read with the quantities; others when somebody asks for them
    bool of_arrangement = false;  ///< stored once for all members that begin from the same floes
    ArrayNumbers numbers = ArrayNumbers::real;
    std::span<const char* const> words = {};  ///< of flags, counted from 0
    int held_steps = 1;                       ///< a value of a history is that of so many steps

    constexpr std::string_view group() const { return in_file() ? path.substr(0, path.find('/')) : ""; }
    constexpr std::string_view name() const { return path.substr(path.find('/') + 1); }
    constexpr bool in_file() const { return path.find('/') != std::string_view::npos; }
    /// Its axis of that kind; nullptr if it has none.
    constexpr const ArrayAxis* axis_of(AxisKind kind) const {
        for (const ArrayAxis* axis : axes)
            if (axis != nullptr && axis->kind == kind) return axis;
        return nullptr;
    }
};

// The list of all arrays that a member yields, beside its quantities: by it they travel from the process that computed
// them to the journal and to the campaign file, and are read again. A new array is its field in MemberResult, one line
// here, and its computation in run_member.cpp; a new history stands in simulation/record.hpp.

/// The times of a history.
constexpr const ArrayAxis* axis_of(HistoryOf of) {
    constexpr std::array axes{&time_axis,     &bed_axis,    &motion_axis,  &mooring_axis,
                              &line_use_axis, &thrust_axis, &floating_axis};
    return axes[static_cast<std::size_t>(of)];
}

/// An array for each history of the list.
template <auto owner, const auto& histories>
constexpr auto history_outputs() {
    return []<std::size_t... k>(std::index_sequence<k...>) {
        return std::array{ArrayOutput{.path = histories[k].path,
                                      .unit = histories[k].unit,
                                      .long_name = histories[k].long_name,
                                      .axes = {axis_of(histories[k].of)},
                                      .access = at_vector<owner, histories[k].values>(),
                                      .chunks = ArrayChunks::of_its_own,
                                      .held_steps = histories[k].held_steps}...};
    }
    (std::make_index_sequence<histories.size()>{});
}

/// One number of each element of a vector.
template <auto elements, auto number>
constexpr ArrayOutput each_output(std::string_view path, std::string_view unit, std::string_view long_name,
                                  const ArrayAxis& axis, ArrayNumbers numbers = ArrayNumbers::real) {
    return {.path = path,
            .unit = unit,
            .long_name = long_name,
            .axes = {&axis},
            .access = at_each<elements, number>(),
            .numbers = numbers};
}

/// The same, read with the quantities.
template <auto elements, auto number>
constexpr ArrayOutput table_output(std::string_view path, std::string_view unit, std::string_view long_name,
                                   const ArrayAxis& axis) {
    ArrayOutput array = each_output<elements, number>(path, unit, long_name, axis);
    array.in_table = true;
    return array;
}

/// A vector of numbers in each element of a vector, read with the quantities.
template <auto elements, auto numbers>
constexpr ArrayOutput rows_output(std::string_view path, std::string_view unit, std::string_view long_name,
                                  const ArrayAxis& axis, const ArrayAxis& second,
                                  ArrayChunks chunks = ArrayChunks::with_others) {
    return {.path = path,
            .unit = unit,
            .long_name = long_name,
            .axes = {&axis, &second},
            .access = at_rows<elements, numbers>(),
            .chunks = chunks,
            .in_table = true};
}

inline constexpr std::array outputs_before_histories{
    ArrayOutput{.path = "members/segment_maximum",
                .unit = "N",
                .long_name = "largest surge load in each segment of the window",
                .axes = {&segment_axis},
                .access = at_vector<&MemberOutputs::load, &LoadStatistics::segment_maximum>(),
                .chunks = ArrayChunks::of_its_own,
                .in_table = true},
    ArrayOutput{.path = "members/floe_properties",
                .unit = "SI",
                .long_name = "properties of each floe, where they differ",
                .axes = {&floe_axis, &property_axis},
                .access = at_row_list<floe_properties.size(), &MemberResult::floe_properties>(),
                .chunks = ArrayChunks::of_its_own},
    table_output<&MemberResult::levels, &LevelCount::steps_above>(
        "exceedance/steps_above", "1", "steps of the window with a surge load above the level", level_axis),
    table_output<&MemberResult::levels, &LevelCount::upcrossings>(
        "exceedance/upcrossings", "1", "rises of the surge load through the level within the window", level_axis),
    each_output<&MemberOutputs::averaged, &AveragedLoad::time>(
        "averaging_time", "s", "time that the surge load is averaged over", averaging_axis),
    table_output<&MemberOutputs::averaged, &AveragedLoad::sd>(
        "averaged/sd_load", "N",
        "population standard deviation of the surge load over the window, of its running means", averaging_axis),
    table_output<&MemberOutputs::averaged, &AveragedLoad::mean_maximum>(
        "averaged/mean_maximum", "N", "mean of the segment maxima of the surge load, of its running means",
        averaging_axis),
    table_output<&MemberOutputs::averaged, &AveragedLoad::sd_maximum>(
        "averaged/sd_maximum", "N",
        "population standard deviation of the segment maxima of the surge load, of its running means", averaging_axis),
    rows_output<&MemberOutputs::averaged, &AveragedLoad::segment_maximum>(
        "averaged/segment_maximum", "N", "largest running mean that ends in each segment", averaging_axis,
        segment_axis),
    rows_output<&MemberOutputs::averaged, &AveragedLoad::peaks>(
        "averaged/peaks", "N", "declustered peaks of the running means above their mean, falling", averaging_axis,
        peak_axis),
    table_output<&MemberOutputs::responses, &Response::mean>("responses/mean", "SI",
                                                             "mean of the response over the window", response_axis),
    table_output<&MemberOutputs::responses, &Response::rise>(
        "responses/rise", "SI", "slope of the response over the window, times its length", response_axis),
    rows_output<&MemberOutputs::responses, &Response::segment_maximum>(
        "responses/segment_maximum", "SI", "largest response in each segment of the window", response_axis,
        segment_axis, ArrayChunks::of_its_own),
    rows_output<&MemberOutputs::responses, &Response::peaks>(
        "responses/peaks", "SI", "declustered peaks of the response above its mean, falling", response_axis, peak_axis,
        ArrayChunks::of_its_own),
    table_output<&MemberOutputs::parts, &PartLoad::mean>("parts/mean_load", "N",
                                                         "mean surge load on the part over the window", part_axis),
    table_output<&MemberOutputs::parts, &PartLoad::sd>(
        "parts/sd_load", "N", "population standard deviation of the surge load on the part over the window", part_axis),
    table_output<&MemberOutputs::parts, &PartLoad::maximum>("parts/maximum_load", "N",
                                                            "largest surge load on the part in the window", part_axis),
    table_output<&MemberOutputs::parts, &PartLoad::mean_sway>(
        "parts/mean_sway", "N", "mean load on the part towards +z over the window", part_axis),
    table_output<&MemberOutputs::parts, &PartLoad::mean_heave>(
        "parts/mean_heave", "N", "mean load on the part upwards over the window", part_axis),
    rows_output<&MemberOutputs::parts, &PartLoad::mean_maximum>(
        "parts/mean_maximum", "N", "mean of the segment maxima of the surge load on the part, of its running means",
        part_axis, averaging_axis),
    rows_output<&MemberOutputs::parts, &PartLoad::normal_maximum>(
        "parts/normal_maximum", "N",
        "mean of the segment maxima of the sum of the normal forces on the part, of its running means", part_axis,
        averaging_axis),
    ArrayOutput{.path = "arrangements/pose",
                .unit = "m, m, rad",
                .long_name = "pose of each floe at the start: x, z, yaw",
                .axes = {&floe_axis, &coordinate_axis},
                .access = at_poses<&MemberResult::arrangement>(),
                .of_arrangement = true},
    ArrayOutput{.path = "arrangements/psi4",
                .unit = "1",
                .long_name = "fourfold orientational order of the arrangement",
                .access = at_number<&MemberResult::psi4>(),
                .of_arrangement = true},
};

inline constexpr std::array outputs_after_histories{
    ArrayOutput{.path = "members/line_tension",
                .unit = "N",
                .long_name = "largest tension of each mooring line over the run, horizontal where it has no weight",
                .axes = {&line_axis},
                .access = at_vector<&MemberResult::line_tension>()},
    ArrayOutput{.path = "members/line_broken_at",
                .unit = "s",
                .long_name = "end of the step in which the mooring line broke; NaN where it holds",
                .axes = {&line_axis},
                .access = at_vector<&MemberResult::line_broken_at>()},
    ArrayOutput{.path = "load_map/surge_load",
                .unit = "N",
                .long_name = "mean surge load that acts here",
                .axes = {&height_axis, &angle_axis},
                .access = at_row_list<LoadMap::angles, &MemberResult::load_map, &LoadMap::surge>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "load_map/normal_force",
                .unit = "N",
                .long_name = "mean sum of the magnitudes of the normal forces here",
                .axes = {&height_axis, &angle_axis},
                .access = at_row_list<LoadMap::angles, &MemberResult::load_map, &LoadMap::normal>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "load_map/surge_load_along_tow",
                .unit = "N",
                .long_name = "mean surge load in this part of the window",
                .axes = {&tow_axis},
                .access = at_vector<&MemberResult::load_map, &LoadMap::along_tow>(),
                .chunks = ArrayChunks::of_its_own},
    each_output<&MemberResult::breaks, &BreakEvent::time>("breaks/time", "s",
                                                          "end of the step in which the joint failed", break_axis),
    each_output<&MemberResult::breaks, &BreakEvent::floe>("breaks/floe", "1", "floe of the joint", break_axis,
                                                          ArrayNumbers::index),
    each_output<&MemberResult::breaks, &BreakEvent::joint>("breaks/joint", "1", "joint within its floe", break_axis,
                                                           ArrayNumbers::index),
    ArrayOutput{.path = "breaks/mode",
                .unit = "1",
                .long_name = "how the joint failed",
                .axes = {&break_axis},
                .access = at_each<&MemberResult::breaks, &BreakEvent::mode>(),
                .numbers = ArrayNumbers::flag,
                .words = failure_mode_names},
    each_output<&MemberResult::piece_areas, &PieceArea::floe>(
        "pieces/floe", "1", "floe of the piece; only of floes in more than one piece at the end", piece_axis,
        ArrayNumbers::index),
    each_output<&MemberResult::piece_areas, &PieceArea::area>("pieces/area", "m2",
                                                              "area of the piece, of its upper side", piece_axis),
};

/// In the order in which they are stored and set: what others need comes first.
inline constexpr auto array_outputs =
    joined(outputs_before_histories, history_outputs<&MemberResult::history, load_histories>(),
           history_outputs<&MemberResult::bed, bed_histories>(),
           history_outputs<&MemberResult::motion, motion_histories>(), outputs_after_histories);

/// Its number in the list; array_outputs.size() for a path that is not in it.
constexpr std::size_t array_number(std::string_view path) {
    return static_cast<std::size_t>(std::ranges::find(array_outputs, path, &ArrayOutput::path) - array_outputs.begin());
}

/// array_output("load_map/surge_load"): a path that is not in the list does not compile.
consteval const ArrayOutput& array_output(std::string_view path) {
    return array_outputs.at(array_number(path));
}

/// Removes what the member keeps of all arrays.
void clear_arrays(MemberResult& result);

// A member's result as bytes, exact and the same on every machine: for journals, and for messages between ranks and
// from isolated processes. Quantities and arrays go by their lists, each with its key, so that a reader of another
// version knows what it has.

/// All but the arrays.
void write(ByteWriter& out, const MemberResult& result);

/// Restores what write() wrote, bit for bit. Quantities that are not in the bytes are NaN. Throws RunError if the bytes
/// are not a result.
MemberResult read_member_result(ByteReader& in);

/// The arrays that the member has, as they are.
void write_arrays(ByteWriter& out, const MemberResult& result);

/// What write_arrays() wrote. Throws RunError if the bytes are no arrays.
void read_arrays(ByteReader& in, MemberResult& result);

/// Whether the array may have these sizes: one for each axis, those of fixed axes as they are, and as many values as
/// they multiply to. Throws RunError otherwise.
void check_sizes(const ArrayOutput& array, std::span<const std::size_t> sizes, std::uint64_t values);

}  // namespace floes
