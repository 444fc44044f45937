#include "laws/brine.hpp"

#include <cmath>

namespace floes {

double brine_volume(double salinity, double temperature) {
    return salinity * (49.185 / std::abs(temperature) + 0.532);
}

double flexural_strength(double brine) {
    return 1.76e6 * std::exp(-5.88 * std::sqrt(brine));
}

double brine_modulus(double brine) {
    return 10e9 - 35.1e9 * brine;
}

}  // namespace floes
