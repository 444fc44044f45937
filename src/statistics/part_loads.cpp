#include "statistics/part_loads.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/means.hpp"

namespace floes {

PartLoad part_load(std::span<const double> surge, std::span<const double> sway, std::span<const double> heave,
                   const Averaging& how) {
    PartLoad load{.mean = mean_of(surge),
                  .maximum = *std::ranges::max_element(surge),
                  .mean_sway = mean_of(sway),
                  .mean_heave = mean_of(heave)};
    load.sd = population_sd(surge, load.mean);
    for (const AveragedLoad& one : averaged_load(surge, how)) load.mean_maximum.push_back(one.mean_maximum);
    return load;
}

MomentStatistics moment_statistics(std::span<const double> window) {
    MomentStatistics found{.mean = mean_of(window)};
    found.sd = population_sd(window, found.mean);
    for (const double moment : window) found.largest = std::max(found.largest, std::abs(moment));
    return found;
}

}  // namespace floes
