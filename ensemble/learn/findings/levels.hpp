#pragma once
// How long and how often the load exceeds the levels that the members counted, over arrangements. Needs no histories.

#include <cstddef>
#include <vector>

#include "findings/summary.hpp"

namespace floes {

/// One level in one case.
struct LevelRow {
    std::size_t case_index = 0;
    double level = 0;        ///< N
    int runs = 0;            ///< done members that counted it
    Interval time_above{};   ///< share of the window's time steps with a surge load above it, 0-1
    Interval upcrossings{};  ///< upward crossings of the level, 1/s
};

/// Every level of every case with a done member that counted it, cases in file order, levels ascending.
std::vector<LevelRow> find_levels(const CampaignTable& table);

Section levels_section(const Summary& summary, const std::vector<LevelRow>& rows);

}  // namespace floes
