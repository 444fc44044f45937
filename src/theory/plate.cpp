#include "theory/plate.hpp"

#include <algorithm>
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

namespace {

/// log10(E T³ / (k b⁴))
double decades(const FloatingPlate& plate, double elastic_modulus, double b) {
    return std::log10(elastic_modulus * std::pow(plate.thickness, 3) / (plate.foundation() * std::pow(b, 4)));
}

}  // namespace

double edge_stress_per_decade(double load, double thickness, double poisson_ratio) {
    return 4 * 0.529 * (1 + 0.54 * poisson_ratio) * load / (thickness * thickness);
}

double interior_stress_per_decade(double load, double thickness, double poisson_ratio) {
    return 4 * 0.275 * (1 + poisson_ratio) * load / (thickness * thickness);
}

double edge_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b) {
    return edge_stress_per_decade(load, plate.thickness, plate.poisson_ratio) / 4 *
           (decades(plate, elastic_modulus, b) - 0.71);
}

double interior_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b) {
    return interior_stress_per_decade(load, plate.thickness, plate.poisson_ratio) / 4 *
           decades(plate, elastic_modulus, b);
}

double felt_radius(double a, double thickness) {
    FLOES_EXPECTS(a >= 0 && thickness > 0);
    constexpr double thick_plate = 1.724;
    if (a >= thick_plate * thickness) return a;
    return std::sqrt(1.6 * a * a + thickness * thickness) - 0.675 * thickness;
}

double push_over_lift(double angle, double friction) {
    const double down = std::cos(angle) - friction * std::sin(angle);
    if (!(down > 0))
        throw InputError(fmt::format("Ice does not slide up a slope of {:.4g} rad with a friction of {:.4g}: it jams.",
                                     angle, friction));
    return (std::sin(angle) + friction * std::cos(angle)) / down;
}

double buckling_thrust(const FloatingPlate& plate, double elastic_modulus) {
    return std::sqrt(plate.foundation() * plate.flexural_rigidity(elastic_modulus));
}

namespace {

/// w = exp(-αx) (A cos βx + B sin βx), and D w″ = exp(-αx) (C cos βx + S sin βx).
struct BentEdge {
    double alpha = 0;  ///< 1/m
    double beta = 0;
    double lift = 0;      ///< A, m
    double other = 0;     ///< B, m
    double distance = 0;  ///< of the largest moment, m
    double moment = 0;    ///< there, N
};

BentEdge bent_edge(double foundation, double rigidity, double vertical, double thrust, double end_moment) {
    const double root = std::sqrt(foundation / (4 * rigidity));
    const double alpha = std::sqrt(root - thrust / (4 * rigidity));
    const double beta = std::sqrt(root + thrust / (4 * rigidity));
    const double real = alpha * alpha - beta * beta;
    const double imaginary = 2 * alpha * beta;
    // Both conditions at the edge: -end_moment = m_a A + m_b B, vertical = v_a A + v_b B.
    const double m_a = rigidity * real;
    const double m_b = -rigidity * imaginary;
    const double v_a = rigidity * (-alpha * real + beta * imaginary) - thrust * alpha;
    const double v_b = rigidity * (alpha * imaginary + beta * real) + thrust * beta;
    const double determinant = m_a * v_b - m_b * v_a;
    const double a = (-end_moment * v_b - m_b * vertical) / determinant;
    const double b = (m_a * vertical + end_moment * v_a) / determinant;
    const double c = rigidity * (a * real - b * imaginary);
    const double s = rigidity * (b * real + a * imaginary);
    double turn = std::atan2(beta * s - alpha * c, alpha * s + beta * c);
    if (turn < 0) turn += std::numbers::pi;
    const double x = turn / beta;
    return {alpha, beta, a, b, x, std::exp(-alpha * x) * (c * std::cos(turn) + s * std::sin(turn))};
}

}  // namespace

double height_of_edge(const FloatingPlate& plate, double elastic_modulus, const EdgeLoad& load, double x) {
    if (!(load.horizontal < buckling_thrust(plate, elastic_modulus)))
        throw InputError(fmt::format("A sheet on water buckles at its edge under {:.4g} N/m.", load.horizontal));
    const BentEdge edge = bent_edge(plate.foundation(), plate.flexural_rigidity(elastic_modulus), load.vertical,
                                    load.horizontal, load.horizontal * load.below);
    return std::exp(-edge.alpha * x) * (edge.lift * std::cos(edge.beta * x) + edge.other * std::sin(edge.beta * x));
}

LiftedEdge lifted_edge(const FloatingPlate& plate, double elastic_modulus, double strength, double push_over_lift,
                       double below) {
    const double k = plate.foundation();
    const double rigidity = plate.flexural_rigidity(elastic_modulus);
    const double t = plate.thickness;
    const auto bent = [&](double v) {
        return bent_edge(k, rigidity, v, push_over_lift * v, push_over_lift * v * below);
    };
    const auto over = [&](double v) { return 6 * bent(v).moment / (t * t) - push_over_lift * v / t - strength; };
    constexpr double nearly = 0.9999;
    const double most = nearly * buckling_thrust(plate, elastic_modulus) / std::max(push_over_lift, 1e-12);
    double high = strength * t * t * std::sqrt(std::sqrt(k / (4 * rigidity)));
    while (high < most && over(high) < 0) high *= 2;
    high = std::min(high, most);
    if (over(high) < 0) throw InputError("The sheet buckles at its free edge before its lower fibre cracks.");
    double low = 0;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (over(middle) < 0 ? low : high) = middle;
    }
    const BentEdge cracked = bent(high);
    return {high, push_over_lift * high, cracked.distance, cracked.lift};
}

}  // namespace floes
