#include "statistics/part_loads.hpp"

#include <algorithm>

#include "statistics/means.hpp"

namespace floes {

PartLoad part_load(const PartHistory& part, const Averaging& how) {
    PartLoad load{.mean = mean_of(part.surge),
                  .maximum = std::ranges::max(part.surge),
                  .mean_sway = mean_of(part.sway),
                  .mean_heave = mean_of(part.heave)};
    load.sd = population_sd(part.surge, load.mean);
    for (const AveragedLoad& one : averaged_load(part.surge, how)) load.mean_maximum.push_back(one.mean_maximum);
    for (const AveragedLoad& one : averaged_load(part.normal, how)) load.normal_maximum.push_back(one.mean_maximum);
    return load;
}

}  // namespace floes
