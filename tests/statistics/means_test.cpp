#include "statistics/means.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace floes {
namespace {

constexpr std::array values{1.0, 2.0, 6.0, 3.0, 100.0};

TEST(MeanOf, IsTheSumOverTheCount) {
    EXPECT_EQ(mean_of(values), 22.4);
    EXPECT_TRUE(std::isnan(mean_of({})));
}

TEST(BatchMeans, LeaveOutWhatIsLeftOver) {
    EXPECT_THAT(batch_means(values, 2), testing::ElementsAre(1.5, 4.5));
}

}  // namespace
}  // namespace floes
