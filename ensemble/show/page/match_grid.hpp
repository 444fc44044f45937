#pragma once
// All pairs of a matching's inputs in one picture. For this room only.

#include <string>

#include "match/matching.hpp"

namespace floes {

/// A square of panels, inputs in the order of the axes from left to right and from top to bottom. Below the diagonal
/// the least implausibility of each cell, a line round what is not ruled out, and the simulated points; above it the
/// optical depth; on it the share left along the input. Scales and names stand at the edges only.
std::string match_grid(const MatchData& data, const Matching& found);

}  // namespace floes
