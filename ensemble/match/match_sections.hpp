#pragma once
// Figures of a matching. For this module only.

#include <string>
#include <vector>

#include "match/matching.hpp"
#include "tables/figure.hpp"
#include "tables/section.hpp"

namespace floes {

/// Each left-out point of a target that is emulated: simulated against predicted, with bars of two standard deviations.
Figure left_out_figure(const EmulatedTarget& target);

/// For each used target, the share that it rules out and the part of it that no other does. Some target is used.
Figure ruled_out_figure(const std::vector<EmulatedTarget>& targets, const Matching& found);

/// For each input, its range and what of it is left.
Figure inputs_figure(const MatchData& data, const Matching& found);

/// The largest implausibility over the only input.
Figure along_figure(const MatchData& data, const Matching& found);

// What a matching found, as tables for people and records for programs.

/// The verdict in sentences, the targets, the inputs before and after, and of several inputs the correlations in
/// what is left.
std::vector<Section> match_sections(const MatchData& data, const std::vector<EmulatedTarget>& targets,
                                    const Matching& found);

/// The left-out points of each emulator, and why one is not used; in figures, for a page.
Section check_section(const std::vector<EmulatedTarget>& targets);

/// What the emulators predict at one point, and whether a target rules it out.
Section point_section(const MatchData& data, const std::vector<EmulatedTarget>& targets, const Eigen::VectorXd& at);

}  // namespace floes
