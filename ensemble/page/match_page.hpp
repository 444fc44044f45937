#pragma once
// A matching as one self-contained HTML page, and what its pictures are made of: projections onto one or two inputs.

#include <string>
#include <vector>

#include "match/matching.hpp"
#include "tables/section.hpp"

namespace floes {

/// The square of two axes' coordinates, -1 to 1 each, in equal cells; cell (i, k) is at [k * side + i], i along the
/// first axis.
struct MatchCells {
    int side = 0;
    std::vector<double> least;  ///< smallest implausibility of the points there; NaN without points
    std::vector<double> depth;  ///< share of them that is not ruled out, 0-1; NaN without points

    double least_at(int i, int k) const { return least[static_cast<std::size_t>(k * side + i)]; }
    double depth_at(int i, int k) const { return depth[static_cast<std::size_t>(k * side + i)]; }
};

/// Cells along an axis: as many as have eight points each on average, at most 16 and at least 4.
int match_cell_count(const Matching& found);

MatchCells match_cells(const Matching& found, int first_axis, int second_axis, int side);

/// Share of the points in each of `count` slices along an axis that is not ruled out, 0-1; NaN without points.
std::vector<double> share_along(const Matching& found, int axis, int count);

// A matching as one self-contained HTML page: what measured loads leave of the unknown inputs, and whether the
// emulators that say so can be trusted.

/// What is left when only the waves up to this one count.
struct MatchTrail {
    std::string file;  ///< of the wave
    int points = 0;    ///< simulated so far
    double share = 0;  ///< not ruled out, 0-1; NaN where the targets cannot be matched without later waves
};

struct MatchPageData {
    MatchData data;
    std::vector<EmulatedTarget> targets;
    Matching found;
    std::vector<MatchTrail> trail;     ///< one a wave
    std::vector<Section> predictions;  ///< what follows from what is left
    std::string command;               ///< that makes the page
};

/// No scripts, no external resources, for light and dark screens and for print.
std::string match_page(const MatchPageData& told);

}  // namespace floes
