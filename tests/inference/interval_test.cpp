// Intervals over members, against closed form and against scipy.

#include "inference/interval.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"

namespace floes {
namespace interval_test {

// With two values ±d about the mean s = d √2 and Student's t has one degree of freedom, where it is Cauchy's:
// t = tan(π/2 · 0.95).
TEST(MeanInterval, OfTwoValuesIsClosedForm) {
    const std::vector<double> values{8.0, 12.0};
    const double t = std::tan(std::acos(-1.0) / 2 * 0.95);
    const Interval found = mean_interval(values);
    EXPECT_DOUBLE_EQ(found.estimate, 10.0);
    EXPECT_NEAR(found.low, 10.0 - 2.0 * t, 1e-9);
    EXPECT_NEAR(found.high, 10.0 + 2.0 * t, 1e-9);
    EXPECT_NEAR(found.prediction_low, 10.0 - 2.0 * std::sqrt(3.0) * t, 1e-9);
    EXPECT_NEAR(found.prediction_high, 10.0 + 2.0 * std::sqrt(3.0) * t, 1e-9);
}

// Three values have two degrees of freedom: t = (2p - 1) √(2 / (4 p (1 - p))) at p = 0.975.
TEST(MeanInterval, OfThreeValuesIsClosedForm) {
    const std::vector<double> values{-1.0, 0.0, 1.0};
    const double t = 0.95 * std::sqrt(2 / (4 * 0.975 * 0.025));
    const Interval found = mean_interval(values);
    EXPECT_NEAR(found.high, t / std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(found.prediction_high, t * std::sqrt(4.0 / 3.0), 1e-9);
}

// Logarithms of e, e³ are 1 and 3: mean 2, s = √2, and t as above.
TEST(PositiveInterval, PredictsOnALogarithmicScale) {
    const std::vector<double> values{std::exp(1.0), std::exp(3.0)};
    const double t = std::tan(std::acos(-1.0) / 2 * 0.95);
    const Interval found = positive_interval(values);
    const Interval plain = mean_interval(values);
    EXPECT_EQ(found.low, plain.low);
    EXPECT_EQ(found.high, plain.high);
    EXPECT_NEAR(std::log(found.prediction_low), 2 - std::sqrt(3.0) * t, 1e-9);
    EXPECT_NEAR(std::log(found.prediction_high), 2 + std::sqrt(3.0) * t, 1e-9);
    EXPECT_GT(found.prediction_low, 0);
    EXPECT_LT(plain.prediction_low, 0);
}

TEST(PositiveInterval, IsThePlainOneWhereAValueIsNotPositive) {
    const std::vector<double> values{0.0, 8.0, 12.0};
    EXPECT_EQ(positive_interval(values), mean_interval(values));
}

// The segment maxima of Table 3 at E = 30 MPa. At two degrees of freedom scipy 1.10 is 4e-11 off the closed form above.
// python3 -c "from scipy import stats; import numpy as np; x = np.array([106.58, 46.75, 126.84]);
// print(stats.t.interval(.95, 2, x.mean(), stats.sem(x)), stats.t.interval(.95, 2, x.mean(), x.std(ddof=1) * np.sqrt(1
// + 1/3)))"
TEST(MeanInterval, AgreesWithScipyOnThePapersMaxima) {
    const Interval found = mean_interval(std::vector<double>{106.58, 46.75, 126.84});
    EXPECT_NEAR(found.low, -10.055295848982425, 2e-8);
    EXPECT_NEAR(found.high, 196.8352958489824, 2e-8);
    EXPECT_NEAR(found.prediction_low, -113.50059169796484, 2e-8);
    EXPECT_NEAR(found.prediction_high, 300.28059169796484, 2e-8);
}

// The same with x = [26.1, 31.4, 28.0, 22.7, 35.2, 29.9, 27.3, 30.8, 25.5, 33.0, 28.6, 24.2], 11 degrees of freedom.
TEST(MeanInterval, AgreesWithScipyOnTwelveMembers) {
    const std::vector<double> values{26.1, 31.4, 28.0, 22.7, 35.2, 29.9, 27.3, 30.8, 25.5, 33.0, 28.6, 24.2};
    const Interval found = mean_interval(values);
    EXPECT_NEAR(found.low, 26.217170879096834, 1e-9);
    EXPECT_NEAR(found.high, 30.899495787569833, 1e-9);
    EXPECT_NEAR(found.prediction_low, 20.11715206039252, 1e-9);
    EXPECT_NEAR(found.prediction_high, 36.99951460627415, 1e-9);
}

TEST(MeanInterval, OfOneValueHasNoLimits) {
    const Interval found = mean_interval(std::vector<double>{30.0});
    EXPECT_EQ(found.estimate, 30.0);
    for (const double limit : {found.low, found.high, found.prediction_low, found.prediction_high}) {
        EXPECT_TRUE(std::isnan(limit));
    }
}

TEST(MeanInterval, OfNothingIsUndefined) {
    const Interval found = mean_interval({});
    for (const double part : {found.estimate, found.low, found.high, found.prediction_low, found.prediction_high}) {
        EXPECT_TRUE(std::isnan(part));
    }
}

TEST(MeanInterval, OfEqualValuesHasNoWidth) {
    const Interval found = mean_interval(std::vector<double>{7.0, 7.0, 7.0, 7.0});
    EXPECT_EQ(found, (Interval{7.0, 7.0, 7.0, 7.0, 7.0}));
}

TEST(MeanInterval, RefusesWhatIsNoValue) {
    EXPECT_THROW(mean_interval(std::vector<double>{1.0, std::numeric_limits<double>::quiet_NaN()}), InputError);
    EXPECT_THROW(mean_interval(std::vector<double>{1.0, std::numeric_limits<double>::infinity()}), InputError);
}

// 95 % means 95 %: of 20000 samples of six normal values, the mean and one further value fall inside as often as
// promised.
TEST(MeanInterval, CoversAsOftenAsItSays) {
    RandomStream random{2, 0, StreamId::monte_carlo, 0};
    const auto normal = [&] {
        const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
        return 50 + 10 * radius * std::cos(2 * std::acos(-1.0) * random.uniform());
    };
    constexpr int trials = 20000;
    int mean_inside = 0;
    int next_inside = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::array<double, 6> values{};
        for (double& value : values) value = normal();
        const Interval found = mean_interval(values);
        const double next = normal();
        mean_inside += found.low <= 50 && 50 <= found.high;
        next_inside += found.prediction_low <= next && next <= found.prediction_high;
    }
    const double four_errors = 4 * std::sqrt(0.95 * 0.05 / trials);
    EXPECT_NEAR(mean_inside / double{trials}, 0.95, four_errors);
    EXPECT_NEAR(next_inside / double{trials}, 0.95, four_errors);
}

TEST(Clipped, CutsTheRangesOfARatio) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(clipped({0.1, -0.05, 0.25, -0.4, 1.6}, 0, 1), (Interval{0.1, 0.0, 0.25, 0.0, 1.0}));
    const Interval one = clipped({0.1, nan, nan, nan, nan}, 0, 1);
    EXPECT_EQ(one.estimate, 0.1);
    EXPECT_TRUE(std::isnan(one.low) && std::isnan(one.high));
}

}  // namespace interval_test
}  // namespace floes
