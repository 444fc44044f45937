// Laws of factors against their closed forms, whole and cut off.

#include "scenario/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

namespace floes {
namespace factor_law_test {

struct Moments {
    double mean = 0;
    double sd = 0;
};

/// By the middles of many equal shares.
Moments moments(const FactorLaw& law) {
    constexpr int shares = 200'000;
    const Factors factors(law);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < shares; ++i) {
        const double factor = factors.at((i + 0.5) / shares);
        sum += factor;
        squares += factor * factor;
    }
    const double mean = sum / shares;
    return {mean, std::sqrt(squares / shares - mean * mean)};
}

TEST(FactorLaw, WholeLawsHaveTheMeanAndDeviationThatAreStated) {
    for (const LawKind kind : {LawKind::lognormal, LawKind::weibull, LawKind::uniform, LawKind::normal}) {
        for (const double cov : {0.05, 0.2, 0.3}) {
            // No law of these reaches the bounds; the normal one, whose left end is at 0, with at most 4e-4 of it.
            const FactorLaw law{kind, cov, 1e-6, 50};
            const double lost = 1 - Factors(law).mass();
            EXPECT_LE(lost, kind == LawKind::normal ? 5e-4 : 1e-4);
            const Moments found = moments(law);
            EXPECT_NEAR(found.mean, 1, 2e-5 + 2 * lost);
            EXPECT_NEAR(found.sd, cov, 2e-4 * cov + 8 * lost);
        }
    }
}

TEST(FactorLaw, WeibullShapesHaveTheirClosedForms) {
    EXPECT_NEAR(weibull_shape(1), 1, 1e-12);                                       // exponential
    EXPECT_NEAR(weibull_shape(std::sqrt(4 / std::numbers::pi - 1)), 2, 1e-12);     // Rayleigh
    EXPECT_NEAR(weibull_shape(0.001), std::numbers::pi / std::sqrt(6) / 1e-3, 2);  // Gumbel's limit
}

TEST(FactorLaw, ACutNormalHasTheClosedFormsOfOne) {
    const double cov = 0.2;
    const double a = (0.8 - 1) / cov;
    const double b = (1.3 - 1) / cov;
    const auto density = [](double z) { return std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi); };
    const double mass = normal_share(b) - normal_share(a);
    const double shift = (density(a) - density(b)) / mass;
    const double variance = 1 + (a * density(a) - b * density(b)) / mass - shift * shift;
    const FactorLaw law{LawKind::normal, cov, 0.8, 1.3};
    EXPECT_NEAR(Factors(law).mass(), mass, 1e-14);
    EXPECT_NEAR(moments(law).mean, 1 + cov * shift, 1e-6);
    EXPECT_NEAR(moments(law).sd, cov * std::sqrt(variance), 1e-6);
}

TEST(FactorLaw, ACutLognormalHasTheClosedFormOfOne) {
    const double s = std::sqrt(std::log1p(0.3 * 0.3));
    const auto z = [s](double factor) { return (std::log(factor) + 0.5 * s * s) / s; };
    const double mass = normal_share(z(1.4)) - normal_share(z(0.7));
    const double mean = (normal_share(z(1.4) - s) - normal_share(z(0.7) - s)) / mass;
    EXPECT_NEAR(moments({LawKind::lognormal, 0.3, 0.7, 1.4}).mean, mean, 1e-6);
}

TEST(FactorLaw, ACutWeibullHasTheClosedFormOfOne) {
    const double k = weibull_shape(0.25);
    const double scale = 1 / std::tgamma(1 + 1 / k);
    const auto x = [&](double factor) { return std::pow(factor / scale, k); };
    const double mass = std::exp(-x(0.6)) - std::exp(-x(1.2));
    const double mean =
        scale * (boost::math::tgamma_lower(1 + 1 / k, x(1.2)) - boost::math::tgamma_lower(1 + 1 / k, x(0.6))) / mass;
    EXPECT_NEAR(moments({LawKind::weibull, 0.25, 0.6, 1.2}).mean, mean, 1e-6);
}

TEST(FactorLaw, AnEvenLawIsEvenBetweenWhatIsLeftOfIt) {
    const FactorLaw law{LawKind::uniform, 0.2, 0.9, 4};
    const double high = 1 + std::numbers::sqrt3 * 0.2;
    EXPECT_NEAR(moments(law).mean, 0.5 * (0.9 + high), 1e-6);
    EXPECT_DOUBLE_EQ(Factors(law).high(), high);
    EXPECT_DOUBLE_EQ(Factors(law).low(), 0.9);
}

TEST(FactorLaw, NothingLeavesTheBounds) {
    for (const LawKind kind : {LawKind::normal, LawKind::lognormal, LawKind::weibull, LawKind::uniform}) {
        const Factors factors({kind, 0.4, 0.5, 1.5});
        for (const double u : {0.0, 1e-300, 0.5, 1 - 0x1p-53}) {
            EXPECT_GE(factors.at(u), 0.5);
            EXPECT_LE(factors.at(u), 1.5);
        }
    }
    EXPECT_NEAR(Factors({LawKind::normal, 0.05, 2, 3}).mass(), 0, 1e-60);
}

// The figures of S 5 ‰ at -5 °C: 51.8 ‰ brine, 0.46 MPa, 8.2 GPa.
TEST(Brine, HasTheFiguresOfItsFormulas) {
    const double brine = brine_volume(5e-3, -5);
    EXPECT_NEAR(brine, 5e-3 * (9.837 + 0.532), 1e-15);
    EXPECT_NEAR(flexural_strength(brine), 0.46e6, 0.005e6);
    EXPECT_NEAR(brine_modulus(brine), 8.18e9, 0.005e9);
    EXPECT_DOUBLE_EQ(flexural_strength(0), 1.76e6);
}

}  // namespace factor_law_test
}  // namespace floes
