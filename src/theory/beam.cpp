#include "theory/beam.hpp"

#include <cmath>

namespace floes {

double nominal_flexural_strength(double load, double length, double breadth, double thickness) {
    return 6 * load * length / (breadth * thickness * thickness);
}

double floating_cantilever_factor(double elastic_modulus, double length, double thickness, double foundation) {
    const double lambda = std::pow(3 * foundation / (elastic_modulus * std::pow(thickness, 3)), 0.25);
    const double x = lambda * length;
    const double root = std::sinh(x) * std::cos(x) + std::cosh(x) * std::sin(x);
    return x * (std::cosh(x) * std::cosh(x) + std::cos(x) * std::cos(x)) / root;
}

}  // namespace floes
