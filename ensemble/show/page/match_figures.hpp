#pragma once
// The smaller figures of a matching's page, each as SVG. For this room only.

#include <string>
#include <vector>

#include "match/matching.hpp"

namespace floes {

/// Each left-out point of a target that is emulated: simulated against predicted, with bars of two standard deviations.
std::string left_out_figure(const EmulatedTarget& target);

/// Of each used target, the share that it rules out and the part of it that no other does; empty without used targets.
std::string ruled_out_figure(const std::vector<EmulatedTarget>& targets, const Matching& found);

/// Of each input, its range and what of it is left.
std::string inputs_figure(const MatchData& data, const Matching& found);

}  // namespace floes
