#include "statistics/load_statistics.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace level_counts_test {

TEST(LevelCounts, AreOfStepsAboveAndOfRises) {
    const std::vector<double> load{5, 1, 2, 3, 2, 2, 5, 5, 1, 5};
    const std::vector<double> levels{0, 1, 2, 4, 5};
    const std::vector<LevelCount> expected{{10, 0}, {8, 2}, {5, 3}, {4, 2}, {0, 0}};
    EXPECT_EQ(count_levels(load, levels), expected);  // at a level is not above it; beginning above it is no rise
    EXPECT_TRUE(count_levels(load, {}).empty());
}

TEST(BatchMeans, LeaveOutWhatIsLeftOver) {
    const std::vector<double> values{1, 3, 5, 9, 100};
    EXPECT_EQ(batch_means(values, 2), (std::vector<double>{2, 7}));
    EXPECT_EQ(batch_means(values, 1), values);
    EXPECT_TRUE(batch_means(values, 6).empty());
}

}  // namespace level_counts_test
}  // namespace floes
