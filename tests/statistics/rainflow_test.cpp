// Rainflow cycles: the example of ASTM E1049, a sine, and what is no cycle.

#include "statistics/averaged_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace floes {
namespace rainflow_test {

std::map<double, double> counts(const std::vector<LoadCycle>& cycles) {
    std::map<double, double> by_range;
    for (const LoadCycle& one : cycles) by_range[one.range] += one.count;
    return by_range;
}

// ASTM E1049-85 (2017), Fig. 6 and its table.
TEST(Rainflow, CountsTheExampleOfTheStandard) {
    const std::vector<double> load{-2, 1, -3, 5, -1, 3, -4, 4, -2};
    const std::map<double, double> wanted{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}};
    EXPECT_EQ(counts(rainflow(load)), wanted);
    // The full cycle of range 4 is that from E to F, -1 to 3.
    double mean = 0;
    for (const LoadCycle& one : rainflow(load))
        if (one.count == 1) mean = one.mean;
    EXPECT_EQ(mean, 1);
}

TEST(Rainflow, SeesOnlyWhereTheLoadTurns) {
    EXPECT_EQ(counts(rainflow(std::vector<double>{-2, -1, 1, 1, 0, -3, -3, 2, 5, 2, -1, 3, -4, 4, 4, -2})),
              counts(rainflow(std::vector<double>{-2, 1, -3, 5, -1, 3, -4, 4, -2})));
}

TEST(Rainflow, OfASineHasItsRangeOnceAPeriod) {
    constexpr int periods = 50, steps = 200;
    std::vector<double> load;
    for (int k = 0; k <= periods * steps; ++k) load.push_back(10 + 3 * std::sin(2 * M_PI * k / steps));
    double whole = 0;
    for (const LoadCycle& one : rainflow(load))
        if (std::abs(one.range - 6) < 1e-6) whole += one.count;
    EXPECT_NEAR(whole, periods, 0.51);  // the history begins and ends at the mean
    EXPECT_NEAR(damage_sum(rainflow(load), 3) / (periods * std::pow(6, 3)), 1, 0.01);
    EXPECT_NEAR(damage_sum(rainflow(load), 5) / (periods * std::pow(6, 5)), 1, 0.01);
}

TEST(Rainflow, OfALoadThatStaysIsNone) {
    EXPECT_TRUE(rainflow({}).empty());
    EXPECT_TRUE(rainflow(std::vector<double>{3}).empty());
    EXPECT_TRUE(rainflow(std::vector<double>(10, 3.0)).empty());
    EXPECT_EQ(rainflow(std::vector<double>{3, 4}).size(), 1u);
}

}  // namespace rainflow_test
}  // namespace floes
