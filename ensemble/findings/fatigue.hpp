#pragma once
// What fatigue and operation ask of a load: its cycles, and how long it lasts above a level.

#include <cstddef>
#include <span>
#include <vector>

#include "findings/evidence.hpp"
#include "statistics/rainflow.hpp"
#include "tables/section.hpp"

namespace floes {

/// Slopes of S-N curves: 3, of welded steel, and 5, of its part for many cycles and of other details.
inline constexpr double fatigue_slopes[]{3, 5};

/// For one case, over its members with a stored history.
struct CaseFatigue {
    std::size_t case_index = 0;
    int runs = 0;
    double averaging = 0;  ///< s, that the load is averaged over
    double cycles = 0;     ///< per hour, of any range
    /// The range that, met once a second, does the damage of all cycles: (Σ count range^m / s)^(1/m), N, one of each
    /// slope. Damage adds up over a long exposure, so it is that of the mean damage over members, with its 95 %
    /// interval (t).
    std::vector<Interval> equivalent;
    std::vector<double> cycles_above;  ///< per hour, with a range of at least each of Fatigue::edges
    std::vector<double> time_above;    ///< share of the time with a load above each of them
};

struct Fatigue {
    std::vector<double> edges;  ///< N, rising from 0
    std::vector<CaseFatigue> cases;
};

/// The load of one member in its window.
struct LoadWindow {
    std::size_t case_index = 0;
    double step = 0;            ///< s
    double averaging = 0;       ///< s; a step or less: as it is
    std::vector<double> loads;  ///< N
};

/// Twelve edges of a round width up to the largest load or range.
Fatigue find_fatigue(std::span<const LoadWindow> windows);

/// For the stored histories, averaged over the shortest of analysis.averaging_s; of the mooring force that they make,
/// where Evidence::moored has a hull. Reads the file.
std::vector<Section> fatigue_sections(Evidence& evidence);

}  // namespace floes
