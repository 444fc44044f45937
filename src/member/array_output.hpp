#pragma once
// The list of all arrays that a member yields, beside its quantities: by it they travel from the process that computed
// them to the journal and to the campaign file, and are read again. A new array is its field in MemberResult, one line
// here, and its computation in run_member.cpp.

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "member/array_axis.hpp"
#include "member/array_values.hpp"
#include "member/floe_properties.hpp"

namespace floes {

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

    constexpr std::string_view group() const { return in_file() ? path.substr(0, path.find('/')) : ""; }
    constexpr std::string_view name() const { return path.substr(path.find('/') + 1); }
    constexpr bool in_file() const { return path.find('/') != std::string_view::npos; }
    constexpr bool lies_along(const ArrayAxis& axis) const { return std::ranges::find(axes, &axis) != axes.end(); }
    /// Its axis of that kind; nullptr if it has none.
    constexpr const ArrayAxis* axis_of(AxisKind kind) const {
        for (const ArrayAxis* axis : axes)
            if (axis != nullptr && axis->kind == kind) return axis;
        return nullptr;
    }
};

/// In the order in which they are stored and set: what others need comes first.
inline constexpr std::array array_outputs{
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
    ArrayOutput{.path = "exceedance/steps_above",
                .unit = "1",
                .long_name = "steps of the window with a surge load above the level",
                .axes = {&level_axis},
                .access = at_each<&MemberResult::levels, &LevelCount::steps_above>(),
                .in_table = true},
    ArrayOutput{.path = "exceedance/upcrossings",
                .unit = "1",
                .long_name = "rises of the surge load through the level within the window",
                .axes = {&level_axis},
                .access = at_each<&MemberResult::levels, &LevelCount::upcrossings>(),
                .in_table = true},
    ArrayOutput{.path = "averaging_time",
                .unit = "s",
                .long_name = "time that the surge load is averaged over",
                .axes = {&averaging_axis},
                .access = at_each<&MemberOutputs::averaged, &AveragedLoad::time>()},
    ArrayOutput{.path = "averaged/sd_load",
                .unit = "N",
                .long_name = "population standard deviation of the surge load over the window, of its running means",
                .axes = {&averaging_axis},
                .access = at_each<&MemberOutputs::averaged, &AveragedLoad::sd>(),
                .in_table = true},
    ArrayOutput{.path = "averaged/mean_maximum",
                .unit = "N",
                .long_name = "mean of the segment maxima of the surge load, of its running means",
                .axes = {&averaging_axis},
                .access = at_each<&MemberOutputs::averaged, &AveragedLoad::mean_maximum>(),
                .in_table = true},
    ArrayOutput{.path = "averaged/sd_maximum",
                .unit = "N",
                .long_name = "population standard deviation of the segment maxima of the surge load, of its running "
                             "means",
                .axes = {&averaging_axis},
                .access = at_each<&MemberOutputs::averaged, &AveragedLoad::sd_maximum>(),
                .in_table = true},
    ArrayOutput{.path = "averaged/segment_maximum",
                .unit = "N",
                .long_name = "largest running mean that ends in each segment",
                .axes = {&averaging_axis, &segment_axis},
                .access = at_rows<&MemberOutputs::averaged, &AveragedLoad::segment_maximum>(),
                .in_table = true},
    ArrayOutput{.path = "averaged/peaks",
                .unit = "N",
                .long_name = "declustered peaks of the running means above their mean, falling",
                .axes = {&averaging_axis, &peak_axis},
                .access = at_rows<&MemberOutputs::averaged, &AveragedLoad::peaks>(),
                .in_table = true},
    ArrayOutput{.path = "parts/mean_load",
                .unit = "N",
                .long_name = "mean surge load on the part over the window",
                .axes = {&part_axis},
                .access = at_each<&MemberOutputs::parts, &PartLoad::mean>(),
                .in_table = true},
    ArrayOutput{.path = "parts/sd_load",
                .unit = "N",
                .long_name = "population standard deviation of the surge load on the part over the window",
                .axes = {&part_axis},
                .access = at_each<&MemberOutputs::parts, &PartLoad::sd>(),
                .in_table = true},
    ArrayOutput{.path = "parts/maximum_load",
                .unit = "N",
                .long_name = "largest surge load on the part in the window",
                .axes = {&part_axis},
                .access = at_each<&MemberOutputs::parts, &PartLoad::maximum>(),
                .in_table = true},
    ArrayOutput{.path = "parts/mean_sway",
                .unit = "N",
                .long_name = "mean load on the part towards +z over the window",
                .axes = {&part_axis},
                .access = at_each<&MemberOutputs::parts, &PartLoad::mean_sway>(),
                .in_table = true},
    ArrayOutput{.path = "parts/mean_heave",
                .unit = "N",
                .long_name = "mean load on the part upwards over the window",
                .axes = {&part_axis},
                .access = at_each<&MemberOutputs::parts, &PartLoad::mean_heave>(),
                .in_table = true},
    ArrayOutput{.path = "parts/mean_maximum",
                .unit = "N",
                .long_name = "mean of the segment maxima of the surge load on the part, of its running means",
                .axes = {&part_axis, &averaging_axis},
                .access = at_rows<&MemberOutputs::parts, &PartLoad::mean_maximum>(),
                .in_table = true},
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
    ArrayOutput{.path = "history/surge_load",
                .unit = "N",
                .long_name = "contact force on the structure against the tow",
                .axes = {&time_axis},
                .access = at_vector<&MemberResult::history, &LoadHistory::surge>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/sway_load",
                .unit = "N",
                .long_name = "contact force on the structure towards +z",
                .axes = {&time_axis},
                .access = at_vector<&MemberResult::history, &LoadHistory::sway>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/heave_load",
                .unit = "N",
                .long_name = "contact force on the structure upwards",
                .axes = {&time_axis},
                .access = at_vector<&MemberResult::history, &LoadHistory::heave>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/structure_x",
                .unit = "m",
                .long_name = "x of the structure's axis",
                .axes = {&motion_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::x>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/structure_z",
                .unit = "m",
                .long_name = "z of the structure's axis",
                .axes = {&motion_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::z>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/structure_yaw",
                .unit = "rad",
                .long_name = "yaw of the structure, positive where +z turns to +x",
                .axes = {&motion_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::yaw>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{
        .path = "history/yaw_load",
        .unit = "N m",
        .long_name = "moment of the contact forces about the structure's axis, positive where it turns +z to +x",
        .axes = {&motion_axis},
        .access = at_vector<&MemberResult::motion, &MotionHistory::yaw_load>(),
        .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/surge_offset",
                .unit = "m",
                .long_name = "offset of the moored structure along the surge load",
                .axes = {&mooring_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::surge_offset>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/sway_offset",
                .unit = "m",
                .long_name = "offset of the moored structure towards +z",
                .axes = {&mooring_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::sway_offset>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/surge_mooring",
                .unit = "N",
                .long_name = "force of springs and lines against the surge load",
                .axes = {&mooring_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::surge_mooring>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/sway_mooring",
                .unit = "N",
                .long_name = "force of springs and lines against the sway load",
                .axes = {&mooring_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::sway_mooring>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "history/yaw_mooring",
                .unit = "N m",
                .long_name = "moment of springs and lines against the yaw load",
                .axes = {&mooring_axis},
                .access = at_vector<&MemberResult::motion, &MotionHistory::yaw_mooring>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "members/line_tension",
                .unit = "N",
                .long_name = "largest horizontal tension of each mooring line over the run",
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
                .access = at_table<LoadMap::heights, LoadMap::angles, &MemberResult::load_map, &LoadMap::surge>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "load_map/normal_force",
                .unit = "N",
                .long_name = "mean sum of the magnitudes of the normal forces here",
                .axes = {&height_axis, &angle_axis},
                .access = at_table<LoadMap::heights, LoadMap::angles, &MemberResult::load_map, &LoadMap::normal>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "load_map/surge_load_along_tow",
                .unit = "N",
                .long_name = "mean surge load in this part of the window",
                .axes = {&tow_axis},
                .access = at_vector<&MemberResult::load_map, &LoadMap::along_tow>(),
                .chunks = ArrayChunks::of_its_own},
    ArrayOutput{.path = "breaks/time",
                .unit = "s",
                .long_name = "end of the step in which the joint failed",
                .axes = {&break_axis},
                .access = at_each<&MemberResult::breaks, &BreakEvent::time>()},
    ArrayOutput{.path = "breaks/floe",
                .unit = "1",
                .long_name = "floe of the joint",
                .axes = {&break_axis},
                .access = at_each<&MemberResult::breaks, &BreakEvent::floe>(),
                .numbers = ArrayNumbers::index},
    ArrayOutput{.path = "breaks/joint",
                .unit = "1",
                .long_name = "joint within its floe",
                .axes = {&break_axis},
                .access = at_each<&MemberResult::breaks, &BreakEvent::joint>(),
                .numbers = ArrayNumbers::index},
    ArrayOutput{.path = "breaks/mode",
                .unit = "1",
                .long_name = "how the joint failed",
                .axes = {&break_axis},
                .access = at_each<&MemberResult::breaks, &BreakEvent::mode>(),
                .numbers = ArrayNumbers::flag,
                .words = failure_mode_names},
    ArrayOutput{.path = "pieces/floe",
                .unit = "1",
                .long_name = "floe of the piece; only of floes in more than one piece at the end",
                .axes = {&piece_axis},
                .access = at_each<&MemberResult::piece_areas, &PieceArea::floe>(),
                .numbers = ArrayNumbers::index},
    ArrayOutput{.path = "pieces/area",
                .unit = "m2",
                .long_name = "area of the piece, of its upper side",
                .axes = {&piece_axis},
                .access = at_each<&MemberResult::piece_areas, &PieceArea::area>()},
};

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

}  // namespace floes
