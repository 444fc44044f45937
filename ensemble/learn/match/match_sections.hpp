#pragma once
// What a matching found, as tables for people and records for programs.

#include <string>
#include <vector>

#include "match/matching.hpp"
#include "tables/section.hpp"

namespace floes {

/// The verdict in sentences, the targets, the inputs before and after, and their correlations in what is left.
std::vector<Section> match_sections(const MatchData& data, const std::vector<EmulatedTarget>& targets,
                                    const Matching& found);

/// The left-out points of each emulator, and why one is not used; in figures, for a page.
Section check_section(const std::vector<EmulatedTarget>& targets);

/// What the emulators predict at one point, and whether a target rules it out.
Section point_section(const MatchData& data, const std::vector<EmulatedTarget>& targets, const Eigen::VectorXd& at);

}  // namespace floes
