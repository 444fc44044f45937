// Laws of sizes against their closed forms, and shares by number against shares by area.

#include "scenario/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace floes {
namespace size_law_test {

constexpr int shares = 200'000;
constexpr SizeBounds bounds{0.5, 4};

/// Mean of D^power of the power law, m^power.
double power_law_moment(double power, double exponent) {
    const auto integral = [](double n) {  // of D^n
        return std::abs(n + 1) < 1e-12 ? std::log(bounds.high / bounds.low)
                                       : (std::pow(bounds.high, n + 1) - std::pow(bounds.low, n + 1)) / (n + 1);
    };
    return integral(power - exponent) / integral(-exponent);
}

/// Share of the area of floes below a diameter, for floes spread evenly over a law of numbers.
double area_below(const std::function<double(double)>& at, double diameter) {
    double below = 0;
    double all = 0;
    for (int i = 0; i < shares; ++i) {
        const double d = at((i + 0.5) / shares);
        all += d * d;
        if (d < diameter) below += d * d;
    }
    return below / all;
}

/// The u at which a law reaches a diameter.
double share_below(const std::function<double(double)>& at, double diameter) {
    double low = 0;
    double high = 1;
    for (int halving = 0; halving < 50; ++halving)
        (at(0.5 * (low + high)) < diameter ? low : high) = 0.5 * (low + high);
    return low;
}

TEST(SizeLaw, PowerLawsHaveTheirMoments) {
    for (const double exponent : {0.0, 1.0, 1.7, 2.5, 3.0, 3.1}) {
        double mean = 0;
        double square = 0;
        for (int i = 0; i < shares; ++i) {
            const double d = power_law_at((i + 0.5) / shares, exponent, bounds);
            mean += d / shares;
            square += d * d / shares;
        }
        EXPECT_NEAR(mean, power_law_moment(1, exponent), 1e-6) << exponent;
        EXPECT_NEAR(square, power_law_moment(2, exponent), 1e-5) << exponent;
        EXPECT_DOUBLE_EQ(power_law_at(0, exponent, bounds), bounds.low);
        EXPECT_NEAR(power_law_at(1, exponent, bounds), bounds.high, 1e-12);
    }
    // D^-3 from 0.5 to 4: mean (1/0.5 - 1/4) / ((1/0.25 - 1/16) / 2).
    EXPECT_NEAR(power_law_moment(1, 3), 1.75 / 1.96875, 1e-12);
}

TEST(SizeLaw, AreaSharesOfAPowerLawAreThoseOfAnExponentSmallerByTwo) {
    for (const double exponent : {2.3, 3.1}) {
        const auto numbers = [&](double u) { return power_law_at(u, exponent, bounds); };
        const auto areas = [&](double u) { return power_law_at(u, exponent - 2, bounds); };
        for (const double d : {0.7, 1.3, 2.9}) EXPECT_NEAR(area_below(numbers, d), share_below(areas, d), 2e-5);
    }
}

TEST(SizeLaw, AreaSharesOfALognormalLawAreThoseThatWereStated) {
    const LognormalSizes stated{1.2, 0.5};
    const Factors of_numbers = cut_off(number_law(stated), bounds);
    const Factors of_area = cut_off(stated, bounds);
    const double mean = number_law(stated).mean;
    const auto numbers = [&](double u) { return mean * of_numbers.at(u); };
    const auto areas = [&](double u) { return stated.mean * of_area.at(u); };
    EXPECT_NEAR(mean, 1.2 * std::exp(-2 * std::log1p(0.25)), 1e-12);
    for (const double d : {0.7, 1.3, 2.9}) EXPECT_NEAR(area_below(numbers, d), share_below(areas, d), 2e-5);
}

}  // namespace size_law_test
}  // namespace floes
