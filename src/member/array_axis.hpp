#pragma once
// The axes along which the arrays of a member lie.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scenario/scenario.hpp"

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
    part_axis, time_axis, motion_axis, mooring_axis, thrust_axis, line_axis, height_axis, angle_axis, tow_axis,
    break_axis, piece_axis;

/// Those of which a member alone knows how far they go.
inline constexpr std::array<const ArrayAxis*, 3> found_axes{&peak_axis, &break_axis, &piece_axis};

}  // namespace floes
