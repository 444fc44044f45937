#include "statistics/moored_response.hpp"

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

double rms_rate(std::span<const double> values, double step) {
    double squares = 0;
    for (std::size_t k = 1; k < values.size(); ++k) {
        const double rate = (values[k] - values[k - 1]) / step;
        squares += rate * rate;
    }
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace floes
