#include "scenario/laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <boost/math/distributions/weibull.hpp>
#include <boost/math/special_functions/gamma.hpp>

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

namespace {

using AnyLaw = std::variant<boost::math::normal, boost::math::lognormal, boost::math::weibull, boost::math::uniform>;

AnyLaw law_of(const FactorLaw& law) {
    switch (law.kind) {
        case LawKind::lognormal: {
            const double variance = std::log1p(law.cov * law.cov);  // of the logarithm
            return boost::math::lognormal(-0.5 * variance, std::sqrt(variance));
        }
        case LawKind::weibull: {
            const double shape = weibull_shape(law.cov);
            return boost::math::weibull(shape, 1 / std::tgamma(1 + 1 / shape));
        }
        case LawKind::uniform: {
            const double half = std::numbers::sqrt3 * law.cov;
            return boost::math::uniform(1 - half, 1 + half);
        }
        default:
            return boost::math::normal(1, law.cov);
    }
}

double share_below(const AnyLaw& law, double factor) {
    return std::visit([&](const auto& one) { return boost::math::cdf(one, factor); }, law);
}

/// Away from 0 and 1, where quantiles are infinite.
double inside(double share) {
    return std::clamp(share, std::numeric_limits<double>::min(), 1 - std::numeric_limits<double>::epsilon() / 2);
}

}  // namespace

struct Factors::Law {
    AnyLaw any;
};

double weibull_shape(double cov) {
    const double wanted = cov * cov;
    const auto squared = [](double k) {
        return std::expm1(boost::math::lgamma(1 + 2 / k) - 2 * boost::math::lgamma(1 + 1 / k));
    };
    double low = std::log(0.5);  // k 0.5 has the CoV 2.2, and 1e5 has 1.3e-5
    double high = std::log(1e5);
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (squared(std::exp(middle)) > wanted ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

double normal_share(double z) {
    return boost::math::cdf(boost::math::normal(), z);
}

double normal_at(double u) {
    return boost::math::quantile(boost::math::normal(), inside(u));
}

Factors::Factors(const FactorLaw& law)
    : law_(std::make_shared<const Law>(Law{law_of(law)})),
      low_(law.low),
      high_(law.high),
      below_low_(share_below(law_->any, law.low)),
      above_low_(share_below(law_->any, law.high)) {
    if (const auto* even = std::get_if<boost::math::uniform>(&law_->any)) {
        low_ = std::max(low_, even->lower());
        high_ = std::min(high_, even->upper());
    }
}

double Factors::at(double u) const {
    const double share = inside(below_low_ + u * mass());
    const double factor = std::visit([&](const auto& one) { return boost::math::quantile(one, share); }, law_->any);
    return static_cast<float>(std::clamp(factor, low_, high_));
}

double power_law_at(double u, double exponent, const SizeBounds& bounds) {
    const double ratio = bounds.high / bounds.low;
    const double rest = 1 - exponent;
    if (std::abs(rest) < 1e-12) return bounds.low * std::pow(ratio, u);
    return bounds.low * std::pow(1 + u * (std::pow(ratio, rest) - 1), 1 / rest);
}

LognormalSizes number_law(const LognormalSizes& of_area) {
    const double squared = 1 + of_area.cov * of_area.cov;  // exp(s²)
    return {of_area.mean / (squared * squared), of_area.cov};
}

Factors cut_off(const LognormalSizes& law, const SizeBounds& bounds) {
    return Factors({LawKind::lognormal, law.cov, bounds.low / law.mean, bounds.high / law.mean});
}

}  // namespace floes
