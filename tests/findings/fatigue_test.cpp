// Cycles and duration: sines of known range, over members.

#include "findings/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace floes {
namespace fatigue_test {

constexpr double step = 0.01;  // s

/// Mean 10 N, range 6 N times `times`, one period a second, for 100 s.
LoadWindow sine(std::size_t of_case, double times, double averaging = 0) {
    LoadWindow window{of_case, step, averaging, {}};
    for (int k = 0; k < 10000; ++k) window.loads.push_back(10 + 3 * times * std::cos(2 * M_PI * step * k));
    return window;
}

TEST(Fatigue, OfASineIsItsRangeOnceASecond) {
    const Fatigue found = find_fatigue(std::vector{sine(2, 1), sine(2, 1), sine(2, 1)});
    ASSERT_EQ(found.cases.size(), 1u);
    const CaseFatigue& one = found.cases.front();
    EXPECT_EQ(one.case_index, 2u);
    EXPECT_EQ(one.runs, 3);
    EXPECT_NEAR(one.cycles, 3600, 40);
    EXPECT_NEAR(one.equivalent[0].estimate, 6, 0.03);
    EXPECT_NEAR(one.equivalent[1].estimate, 6, 0.03);
    EXPECT_NEAR(one.equivalent[1].low, one.equivalent[1].high, 1e-9);
    for (std::size_t k = 0; k < found.edges.size(); ++k) {
        if (std::abs(found.edges[k] - 6) > 1e-6) {  // which rounding decides
            EXPECT_NEAR(one.cycles_above[k], found.edges[k] < 6 ? 3600 : 0, 40) << found.edges[k];
        }
        const double height = (found.edges[k] - 10) / 3;
        const double above = height <= -1 ? 1 : height >= 1 ? 0 : std::acos(height) / M_PI;
        EXPECT_NEAR(one.time_above[k], above, 0.01) << found.edges[k];
    }
}

// Half of the time at twice the range: the damage of the whole is the mean of both.
TEST(Fatigue, AddsUpTheDamageOfMembers) {
    const CaseFatigue one = find_fatigue(std::vector{sine(0, 1), sine(0, 2)}).cases.at(0);
    EXPECT_NEAR(one.equivalent[0].estimate, 6 * std::cbrt((1 + 8) / 2.0), 0.05);
    EXPECT_NEAR(one.equivalent[1].estimate, 6 * std::pow((1 + 32) / 2.0, 0.2), 0.05);
    EXPECT_LT(one.equivalent[0].low, one.equivalent[0].estimate);
}

// A running mean over half a period has 2/π of the range.
TEST(Fatigue, IsOfTheAveragedLoad) {
    const CaseFatigue one = find_fatigue(std::vector{sine(0, 1, 0.5)}).cases.at(0);
    EXPECT_NEAR(one.equivalent[0].estimate, 6 * 2 / M_PI, 0.05);
    EXPECT_EQ(one.averaging, 0.5);
}

TEST(Fatigue, OfNoHistoriesIsNone) {
    EXPECT_TRUE(find_fatigue({}).cases.empty());
}

}  // namespace fatigue_test
}  // namespace floes
