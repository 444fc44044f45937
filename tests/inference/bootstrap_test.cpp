// Bootstrap intervals: closed forms, coverage and repeatability.

#include "inference/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace floes {
namespace bootstrap_test {

// Of two rows each resample is one of four equally likely ones: the mean of 0 and 1 is 0, 1/2, 1/2, 1.
TEST(Bootstrap, DrawsEveryRowAsOften) {
    const std::vector<double> values{0.0, 1.0};
    const auto sum = [&](std::span<const std::uint32_t> rows) { return values[rows[0]] + values[rows[1]]; };
    const std::vector<double> found = bootstrap(2, sum, 40000);
    ASSERT_EQ(found.size(), 40000u);
    double ones = 0;
    double twos = 0;
    for (const double value : found) {
        ones += value == 1;
        twos += value == 2;
    }
    EXPECT_NEAR(ones / 40000, 0.5, 4 * std::sqrt(0.25 / 40000));
    EXPECT_NEAR(twos / 40000, 0.25, 4 * std::sqrt(0.1875 / 40000));
}

/// Of the mean of values.
Limits interval_of(const std::vector<double>& values, int resamples = 0) {
    const auto mean = [&](std::span<const std::uint32_t> rows) {
        double sum = 0;
        for (const std::uint32_t row : rows) sum += values[row];
        return sum / static_cast<double>(rows.size());
    };
    return bca_interval(values.size(), mean, resamples);
}

TEST(Bootstrap, GivesTheSameAgain) {
    const std::vector<double> values{3.14, 1.59, 4.65, 3.58, 9.79, 3.23, 8.46};
    EXPECT_EQ(interval_of(values), interval_of(values));
}

TEST(Bootstrap, IsUndefinedWithoutSpreadOrRows) {
    EXPECT_TRUE(std::isnan(interval_of({2, 2, 2, 2}).low));
    EXPECT_TRUE(std::isnan(interval_of({1, 2}).high));
}

// Skewed values (exponential, n = 40): both tails of BCa miss about as often, 2.5 %; plus what 40 values cost.
TEST(Bootstrap, CoversSkewedValues) {
    RandomStream random{5, 0, StreamId::monte_carlo, 0};
    int inside = 0;
    constexpr int trials = 1500;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<double> values(40);
        for (double& value : values) value = -std::log(1 - random.uniform());
        const Limits found = interval_of(values, 999);
        inside += found.low <= 1 && 1 <= found.high;
    }
    EXPECT_NEAR(inside / double{trials}, 0.935, 4 * std::sqrt(0.95 * 0.05 / trials));
}

TEST(Quantile, IsLinearBetweenSortedValues) {
    const std::vector<double> sorted{1, 2, 4};
    EXPECT_EQ(quantile_of_sorted(sorted, 0), 1);
    EXPECT_EQ(quantile_of_sorted(sorted, 0.25), 1.5);
    EXPECT_EQ(quantile_of_sorted(sorted, 0.75), 3);
    EXPECT_EQ(quantile_of_sorted(sorted, 1), 4);
    const Limits limits = percentile_interval({4, std::nan(""), 0});
    EXPECT_NEAR(limits.low, 0.1, 1e-12);
    EXPECT_NEAR(limits.high, 3.9, 1e-12);
}

}  // namespace bootstrap_test
}  // namespace floes
