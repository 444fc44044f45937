#pragma once
// Figures of a matching. For this room only.

#include <vector>

#include "match/matching.hpp"
#include "tables/figure.hpp"

namespace floes {

/// Each left-out point of a target that is emulated: simulated against predicted, with bars of two standard deviations.
Figure left_out_figure(const EmulatedTarget& target);

/// Of each used target, the share that it rules out and the part of it that no other does. Some target is used.
Figure ruled_out_figure(const std::vector<EmulatedTarget>& targets, const Matching& found);

/// Of each input, its range and what of it is left.
Figure inputs_figure(const MatchData& data, const Matching& found);

}  // namespace floes
