#pragma once
// Closed forms of plates on water, beside which tests put what a run shows: the edge of a sheet that a slope lifts, and
// Westergaard's largest stress under a load.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "theory/plate.hpp"

namespace floes::test {

// The edge of a wide sheet on water that a slope lifts, until the sheet cracks along a line: a beam on an elastic
// foundation (Hetényi 1946) under a thrust. Per width, x from the edge into the sheet, w upwards:
//
//   D w⁗ + H w″ + k w = 0,   D w‴(0) + H w′(0) = V,   D w″(0) = -H e,   lower fibre 6 D w″/T² - H/T
//
// The slope pushes with V upwards and H = ξ V into the sheet, at e below its middle.

/// On the edge: V and H, N/m, and e, m.
struct EdgeLoad {
    double vertical = 0;
    double horizontal = 0;
    double below = 0;
};

/// H/V of a slope of the angle α (rad) from the horizontal on which ice slides up with a coefficient of friction:
/// (sin α + μ cos α) / (cos α - μ sin α). Throws InputError where ice jams: cos α <= μ sin α.
inline double push_over_lift(double angle, double friction) {
    const double down = std::cos(angle) - friction * std::sin(angle);
    if (!(down > 0))
        throw InputError(fmt::format("Ice does not slide up a slope of {:.4g} rad with a friction of {:.4g}: it jams.",
                                     angle, friction));
    return (std::sin(angle) + friction * std::cos(angle)) / down;
}

/// Thrust (N/m) at which a long sheet on water buckles at a free edge: √(k D). Far from edges, or where its edge is
/// clamped, it bears twice that.
inline double buckling_thrust(const FloatingPlate& plate, double elastic_modulus) {
    return std::sqrt(plate.foundation() * plate.flexural_rigidity(elastic_modulus));
}

/// w = exp(-αx) (A cos βx + B sin βx), and D w″ = exp(-αx) (C cos βx + S sin βx).
struct BentEdge {
    double alpha = 0;  ///< 1/m
    double beta = 0;
    double lift = 0;      ///< A, m
    double other = 0;     ///< B, m
    double distance = 0;  ///< of the largest moment, m
    double moment = 0;    ///< there, N
};

inline BentEdge bent_edge(double foundation, double rigidity, double vertical, double thrust, double end_moment) {
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

/// w (m) at x (m) from the edge. Throws InputError where the thrust is not below buckling_thrust().
inline double height_of_edge(const FloatingPlate& plate, double elastic_modulus, const EdgeLoad& load, double x) {
    if (!(load.horizontal < buckling_thrust(plate, elastic_modulus)))
        throw InputError(fmt::format("A sheet on water buckles at its edge under {:.4g} N/m.", load.horizontal));
    const BentEdge edge = bent_edge(plate.foundation(), plate.flexural_rigidity(elastic_modulus), load.vertical,
                                    load.horizontal, load.horizontal * load.below);
    return std::exp(-edge.alpha * x) * (edge.lift * std::cos(edge.beta * x) + edge.other * std::sin(edge.beta * x));
}

/// Where and at which load the lower fibre has the strength first.
struct LiftedEdge {
    double vertical = 0;    ///< V, N/m
    double horizontal = 0;  ///< H, N/m
    double distance = 0;    ///< of the crack from the edge, m
    double lift = 0;        ///< of the edge, m
};

/// `strength`: Pa; `below`: e, m. Throws InputError where the sheet buckles at its free edge before it cracks:
/// H >= buckling_thrust().
inline LiftedEdge lifted_edge(const FloatingPlate& plate, double elastic_modulus, double strength,
                              double push_over_lift, double below) {
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

// Westergaard's formulas (theory/plate.hpp): their singular parts over 4, times the decades to a circle of radius b
// (m).

/// log10(E T³ / (k b⁴))
inline double decades(const FloatingPlate& plate, double elastic_modulus, double b) {
    return std::log10(elastic_modulus * std::pow(plate.thickness, 3) / (plate.foundation() * std::pow(b, 4)));
}

/// Pa, for a load (N) that touches the edge of a half plate.
inline double edge_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b) {
    return edge_stress_per_decade(load, plate.thickness, plate.poisson_ratio) / 4 *
           (decades(plate, elastic_modulus, b) - 0.71);
}

/// Pa, for a load (N) far from edges.
inline double interior_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b) {
    return interior_stress_per_decade(load, plate.thickness, plate.poisson_ratio) / 4 *
           decades(plate, elastic_modulus, b);
}

}  // namespace floes::test
