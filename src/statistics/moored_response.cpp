#include "statistics/moored_response.hpp"

#include <cmath>

namespace floes {

double rms_rate(std::span<const double> values, double step) {
    double squares = 0;
    for (std::size_t k = 1; k < values.size(); ++k) {
        const double rate = (values[k] - values[k - 1]) / step;
        squares += rate * rate;
    }
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace floes
