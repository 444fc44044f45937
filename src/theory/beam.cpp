#include "theory/beam.hpp"

#include <cmath>
#include <numbers>

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

double cantilever_deflection(double load, double distance, double stiffness) {
    return load * distance * distance * distance / (3 * stiffness);
}

double cantilever_frequency(double length, double stiffness, double mass_per_length) {
    constexpr double root = 1.8751040687119611;  // first of cos x cosh x = -1
    return root * root * std::sqrt(stiffness / mass_per_length) / (2 * std::numbers::pi * length * length);
}

}  // namespace floes
