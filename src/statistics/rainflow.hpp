#pragma once
// Cycles of a load for fatigue.

#include <span>
#include <vector>

namespace floes {

struct LoadCycle {
    double range = 0;  ///< from trough to peak, in the unit of the load
    double mean = 0;   ///< of trough and peak
    double count = 1;  ///< 1, or 1/2 where the load does not come back
};

/// Rainflow counting by ASTM E1049-85 (2017), section 5.4.4: of the successive ranges X (the latest) and Y (before it),
/// Y is a cycle where X is not smaller; half a cycle if it begins where the history does, and so is what remains.
/// Plateaus have no ranges. In the order in which they are found; none for fewer than two different values.
std::vector<LoadCycle> rainflow(std::span<const double> values);

/// Σ count range^exponent: what a material whose S-N curve has that slope suffers, up to a factor (Palmgren and Miner).
double damage_sum(std::span<const LoadCycle> cycles, double exponent);

}  // namespace floes
