#pragma once
// A matching as one self-contained HTML page: what measured loads leave of the unknown inputs, and whether the
// emulators that say so can be trusted.

#include <string>
#include <vector>

#include "match/matching.hpp"
#include "tables/section.hpp"

namespace floes {

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
