#include "inference/joint_inputs.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "statistics/distributions.hpp"

namespace floes {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Probability that a standard normal variable is above u.
double above(double u) {
    return 0.5 * std::erfc(u / std::numbers::sqrt2);
}

/// The score that is exceeded with this probability.
double score_exceeded(double probability) {
    if (probability <= 0) return infinite;
    if (probability >= 1) return -infinite;
    return normal_quantile_above(probability);
}

/// -log of the probability above u, exact also where that is nearly 1.
double hazard_at(double u) {
    return u < 0 ? -std::log1p(-above(-u)) : -std::log(above(u));
}

double score_of_hazard(double hazard) {
    return hazard > 0.5 ? score_exceeded(std::exp(-hazard)) : -score_exceeded(-std::expm1(-hazard));
}

}  // namespace

double SmoothParameter::at(double x) const {
    return constant() ? a : a + b * std::pow(x, c);
}

std::string_view name_of(InputLaw law) {
    switch (law) {
        case InputLaw::normal:
            return "normal";
        case InputLaw::lognormal:
            return "lognormal";
        case InputLaw::weibull:
            return "weibull";
        case InputLaw::exponential:
            break;
    }
    return "exponential";
}

bool InputDistribution::valid(double given) const {
    const double one = first.at(given);
    const double two = second.at(given);
    if (!std::isfinite(one)) return false;
    if (law == InputLaw::exponential) return one > 0;
    return std::isfinite(two) && two > 0 && (law == InputLaw::normal || one > 0);
}

double InputDistribution::value(double score, double given) const {
    const double one = first.at(given);
    const double two = second.at(given);
    switch (law) {
        case InputLaw::normal:
            return one + two * score;
        case InputLaw::lognormal:
            return one * std::exp(two * score);
        case InputLaw::weibull:
            return one * std::pow(hazard_at(score), 1 / two);
        case InputLaw::exponential:
            break;
    }
    return one * hazard_at(score);
}

double InputDistribution::score(double x, double given) const {
    const double one = first.at(given);
    const double two = second.at(given);
    if (law == InputLaw::normal) return (x - one) / two;
    if (x <= 0) return -infinite;
    if (law == InputLaw::lognormal) return std::log(x / one) / two;
    return score_of_hazard(law == InputLaw::weibull ? std::pow(x / one, two) : x / one);
}

double InputDistribution::between(double low, double high, double given) const {
    const double from = score(low, given);
    const double to = score(high, given);
    return from > 0 ? above(from) - above(to) : above(-to) - above(-from);
}

std::array<double, 2> JointInputs::at(double one_score, double other_score) const {
    const double first = one.value(one_score, 0);
    return {first, other.value(other_score, first)};
}

double contour_radius(double per_year, double states) {
    return score_exceeded(-std::expm1(std::log1p(-per_year) / states));
}

std::vector<ContourPoint> contour(const JointInputs& inputs, double radius, int count) {
    std::vector<ContourPoint> points;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        points.push_back({360.0 * k / count, inputs.at(radius * std::cos(angle), radius * std::sin(angle))});
    }
    return points;
}

}  // namespace floes
