#pragma once
// Where a field lies, how wide and how long it is, and when it is measured: what a text leaves open of that follows
// from hull, floes, path and moorings. Stated values count; the paper's stand for a hull of the paper's size.

#include <array>
#include <bitset>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "scenario/scenario.hpp"

namespace floes {

/// The keys that can be left open, and their paths.
enum class LaidKey { sheet_width, half_width, begin, start, steady_start, window, segments, floes, ahead, behind };
inline constexpr std::array<std::string_view, 10> laid_paths{
    "field.sheet_width_m", "field.half_width_m", "field.begin_m", "structure.start_m", "analysis.steady_start_s",
    "analysis.window_s",   "analysis.segments",  "field.floes",   "field.ahead_m",     "field.behind_m"};

/// By LaidKey: which of them a text does not state.
using OpenKeys = std::bitset<laid_paths.size()>;

/// Why keys have the values that they got: "the diagonal of the largest floe, 63.6 m".
using LaidReasons = std::map<LaidKey, std::string>;

/// One case of a campaign, before and after.
struct Unlaid {
    Scenario* scenario = nullptr;  ///< not owned; its open keys get their values
    OpenKeys open;
    LaidReasons laid{};
};

/// Whether the hull is of another breadth at the waterline than the paper's, by more than 1 %, so that the paper's
/// field does not suit it.
bool lays_itself(const Scenario& scenario);

/// Gives the open keys of the cases their values. Deterministic. With B the hull's breadth, L the largest side of a
/// floe, T the longest natural period:
///
/// * sheet_width: the diagonal of the largest floe.
/// * begin, start: x = 0, and the bow L/2 before it; either from the other where one is stated.
/// * steady_start: until ice lies along the hull and 2 L more, and 5 T or 3/(ζω) have passed since the bow met it.
/// * window: 10 T, and in each segment 2 B and 5 floes of mean size; of a path until it ends, of stated floes likewise.
/// * segments: 3, or fewer that cut the window into whole steps.
/// * half_width: as far as hull and path reach, and the larger of B and 2 L beside them.
/// * ahead: as far as the hull reaches, and the larger of 2 B and 3 L.
/// * behind: so far that nothing is taken out that can touch the hull, L, and what a path comes back by.
/// * floes: as the way of the run needs, with room ahead as above; of a field without end, as fill what is computed.
///
/// Fields are alike in all cases: each length is the largest that one of them needs. Scenarios that lays_itself() says
/// no to, or whose floes, hull or path have a fault of their own, which find_contradictions() tells, stay as they are.
void lay(std::span<Unlaid> cases);

}  // namespace floes
