// The walk draws from what it is given, and its evidence is the integral.

#include "inference/numerics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace floes {
namespace random_walk_test {

/// Two correlated normal values, SD 1 and 10, correlation 0.8; times e^5.
double correlated(std::span<const double> at) {
    const double x = at[0] - 3;
    const double y = at[1] / 10;
    return 5 - (x * x - 1.6 * x * y + y * y) / (2 * (1 - 0.64));
}

TEST(RandomWalk, HasMeansScatterAndIntegralOfTheDensity) {
    const Walk walk = walk_at_random(correlated, std::vector{0.0, 0.0}, std::vector{0.1, 0.1}, {20000, 5000, 1});
    ASSERT_EQ(walk.draws.size(), 5000u);
    double mean = 0, squares = 0, product = 0;
    for (const std::vector<double>& at : walk.draws) {
        mean += at[0] / 5000;
        squares += at[1] * at[1] / 5000;
        product += (at[0] - 3) * at[1] / 5000;
    }
    EXPECT_NEAR(mean, 3, 0.15);
    EXPECT_NEAR(std::sqrt(squares), 10, 1);
    EXPECT_NEAR(product, 8, 1.5);
    EXPECT_NEAR(walk.log_evidence, 5 + std::log(2 * M_PI * 10 * 0.6), 0.2);
}

TEST(RandomWalk, StaysWhereTheDensityIs) {
    const auto positive = [](std::span<const double> at) {
        return at[0] < 0 ? -std::numeric_limits<double>::infinity() : -at[0];
    };
    double mean = 0;
    const Walk walk = walk_at_random(positive, std::vector{1.0}, std::vector{0.5}, {20000, 5000, 2});
    for (const std::vector<double>& at : walk.draws) {
        EXPECT_GE(at[0], 0);
        mean += at[0] / 5000;
    }
    EXPECT_NEAR(mean, 1, 0.1);
    EXPECT_TRUE(walk_at_random(positive, std::vector{-1.0}, std::vector{0.5}).draws.empty());
}

TEST(RandomWalk, IsTheSameAgainAndAnotherWithAnotherNumber) {
    const auto draws = [](std::uint32_t number) {
        return walk_at_random(correlated, std::vector{0.0, 0.0}, std::vector{0.1, 0.1}, {300, 100, number}).draws;
    };
    EXPECT_EQ(draws(1), draws(1));
    EXPECT_NE(draws(1), draws(2));
}

}  // namespace random_walk_test
}  // namespace floes
