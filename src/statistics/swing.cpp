#include "statistics/swing.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/means.hpp"

namespace floes {

Swing swing_of(std::span<const double> values) {
    const double mean = mean_of(values);
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return {mean, population_sd(values, mean), largest};
}

}  // namespace floes
