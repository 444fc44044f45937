#include "draw/replay_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace floes {
namespace thinned_history_test {

TEST(ThinnedHistory, KeepsEveryPeakInFewPoints) {
    std::vector<double> history;
    for (int i = 0; i < 13'500; ++i) history.push_back(100 * std::sin(0.01 * i));
    history[4321] = 900;
    history[9876] = -500;
    const ThinnedHistory kept = thinned(history, 0, 13'500, 400);
    EXPECT_LE(kept.steps.size(), 400U);
    EXPECT_GT(kept.steps.size(), 300U);
    EXPECT_TRUE(std::ranges::is_sorted(kept.steps));
    for (const int peak : {4321, 9876}) EXPECT_TRUE(std::ranges::binary_search(kept.steps, peak)) << peak;
    for (std::size_t i = 0; i < kept.steps.size(); ++i)
        EXPECT_EQ(kept.values[i], static_cast<float>(history[static_cast<std::size_t>(kept.steps[i])]));
}

TEST(ThinnedHistory, KeepsFewValuesAsTheyAre) {
    const std::vector<double> history{5, 4, 3, 2, 1, 0};
    const ThinnedHistory kept = thinned(history, 1, 5, 4);
    EXPECT_EQ(kept.steps, (std::vector<int>{1, 2, 3, 4}));
    EXPECT_EQ(kept.values, (std::vector<float>{4, 3, 2, 1}));
    EXPECT_TRUE(thinned({}, 0, 0, 4).steps.empty());
}

}  // namespace thinned_history_test
}  // namespace floes
