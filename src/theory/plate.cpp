#include "theory/plate.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <boost/math/tools/roots.hpp>

#include "core/contract.hpp"
#include "core/error.hpp"

namespace floes {

double nominal_flexural_strength(double load, double length, double breadth, double thickness) {
    FLOES_EXPECTS(breadth > 0 && thickness > 0);
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
    FLOES_EXPECTS(length > 0 && stiffness > 0 && mass_per_length > 0);
    constexpr double root = 1.8751040687119611;  // first of cos x cosh x = -1
    return root * root * std::sqrt(stiffness / mass_per_length) / (2 * std::numbers::pi * length * length);
}

double FloatingPlate::flexural_rigidity(double elastic_modulus) const {
    FLOES_EXPECTS(elastic_modulus > 0);
    return elastic_modulus * std::pow(thickness, 3) / (12 * (1 - poisson_ratio * poisson_ratio));
}

double FloatingPlate::characteristic_length(double elastic_modulus) const {
    return std::pow(flexural_rigidity(elastic_modulus) / foundation(), 0.25);
}

double patch_load_slope(const FloatingPlate& plate, double elastic_modulus, double radius) {
    const double x = radius / plate.characteristic_length(elastic_modulus);
    return std::numbers::pi * radius * radius * plate.foundation() / (1 + x * kelvin_ker_prime(x));
}

double modulus_from_point_slope(const FloatingPlate& plate, double slope) {
    FLOES_EXPECTS(slope > 0);
    const double nu = plate.poisson_ratio;
    return 3.0 / 16.0 * (1 - nu * nu) / (plate.foundation() * std::pow(plate.thickness, 3)) * slope * slope;
}

double modulus_from_patch_slope(const FloatingPlate& plate, double slope, double radius) {
    // E grows with the slope; the softest plate that the Kelvin series reaches has l = a/limit.
    const double nu = plate.poisson_ratio;
    const double softest_length = radius / kelvin_series_limit * (1 + 1e-12);
    const double softest =
        std::pow(softest_length, 4) * plate.foundation() * 12 * (1 - nu * nu) / std::pow(plate.thickness, 3);
    const double stiffest = 4 * modulus_from_point_slope(plate, slope) + 2 * softest;
    const auto excess = [&](double modulus) { return patch_load_slope(plate, modulus, radius) - slope; };
    if (!(excess(softest) < 0))
        throw InputError(
            fmt::format("a slope of {} N/m on a load circle of {} m is too soft for a plate; the water alone "
                        "gives {:.6g} N/m",
                        slope, radius, std::numbers::pi * radius * radius * plate.foundation()));
    std::uintmax_t iterations = 200;
    const auto bracket = boost::math::tools::toms748_solve(excess, softest, stiffest,
                                                           boost::math::tools::eps_tolerance<double>(48), iterations);
    return (bracket.first + bracket.second) / 2;
}

namespace {

// ber, bei and the digamma-weighted sum of ker are power series in t = (x²/4). Term n belongs to t^n/(n!)² with the
// sign of i^n, and weight ψ(n + 1) = -γ + H_n. Even n make ber and ker, odd n bei.
struct KelvinSums {
    double ber = 0, ber_prime = 0, bei_prime = 0, ker_sum_prime = 0;
};

KelvinSums kelvin_sums(double x) {
    KelvinSums sums;
    const double t = x * x / 4;
    double power = 1;  // t^n/(n!)²
    double digamma = -std::numbers::egamma;
    for (int n = 0; n < 80; ++n) {
        const double sign = (n % 4 < 2) ? 1 : -1;
        const double value = sign * power;
        const double slope = value * 2 * n / x;  // d/dx t^n = 2 n t^n/x
        if (n % 2 == 0) {
            sums.ber += value;
            sums.ber_prime += slope;
            sums.ker_sum_prime += digamma * slope;
        } else {
            sums.bei_prime += slope;
        }
        power *= t / ((n + 1.0) * (n + 1.0));
        digamma += 1.0 / (n + 1);
        if (power < 1e-40) break;
    }
    return sums;
}

}  // namespace

double kelvin_ker_prime(double x) {
    if (!(x > 0 && x <= kelvin_series_limit))
        throw InputError(fmt::format("the Kelvin functions are evaluated at x = {}; allowed is above 0 to {}", x,
                                     kelvin_series_limit));
    const KelvinSums s = kelvin_sums(x);
    // ker = -ln(x/2) ber + (π/4) bei + Σ ψ ..., differentiated term by term
    return -s.ber / x - std::log(x / 2) * s.ber_prime + std::numbers::pi / 4 * s.bei_prime + s.ker_sum_prime;
}

double edge_stress_per_decade(double load, double thickness, double poisson_ratio) {
    return 4 * 0.529 * (1 + 0.54 * poisson_ratio) * load / (thickness * thickness);
}

double interior_stress_per_decade(double load, double thickness, double poisson_ratio) {
    return 4 * 0.275 * (1 + poisson_ratio) * load / (thickness * thickness);
}

double felt_radius(double a, double thickness) {
    FLOES_EXPECTS(a >= 0 && thickness > 0);
    constexpr double thick_plate = 1.724;
    if (a >= thick_plate * thickness) return a;
    return std::sqrt(1.6 * a * a + thickness * thickness) - 0.675 * thickness;
}

}  // namespace floes
