#include "laws/size_law.hpp"

#include <cmath>

namespace floes {
namespace {

/// The integral of D^power from low to high.
double integral(double power, double low, double high) {
    if (std::abs(power + 1) < 1e-12) return std::log(high / low);
    return (std::pow(high, power + 1) - std::pow(low, power + 1)) / (power + 1);
}

}  // namespace

double power_law_at(double u, double exponent, const SizeBounds& bounds) {
    const double ratio = bounds.high / bounds.low;
    const double rest = 1 - exponent;
    if (std::abs(rest) < 1e-12) return bounds.low * std::pow(ratio, u);
    return bounds.low * std::pow(1 + u * (std::pow(ratio, rest) - 1), 1 / rest);
}

double power_law_moment(double power, double exponent, const SizeBounds& bounds) {
    return integral(power - exponent, bounds.low, bounds.high) / integral(-exponent, bounds.low, bounds.high);
}

LognormalSizes number_law(const LognormalSizes& of_area) {
    const double squared = 1 + of_area.cov * of_area.cov;  // exp(s²)
    return {of_area.mean / (squared * squared), of_area.cov};
}

Factors cut_off(const LognormalSizes& law, const SizeBounds& bounds) {
    return Factors({LawKind::lognormal, law.cov, bounds.low / law.mean, bounds.high / law.mean});
}

}  // namespace floes
