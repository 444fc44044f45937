#pragma once
// How long and how often a load exceeds given levels: a summary for members whose load history is not kept.

#include <span>
#include <vector>

namespace floes {

struct LevelCount {
    int steps_above = 0;  ///< steps with a load above the level
    int upcrossings = 0;  ///< steps above it whose predecessor in the window is not: the load rises through the level
    friend bool operator==(const LevelCount&, const LevelCount&) = default;
};

/// One count for each of `levels`, in their order and unit, by one pass over the load of every step of the window.
std::vector<LevelCount> count_levels(std::span<const double> window, std::span<const double> levels);

}  // namespace floes
