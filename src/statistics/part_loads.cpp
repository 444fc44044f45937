#include "statistics/part_loads.hpp"

#include <algorithm>

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

}  // namespace floes
