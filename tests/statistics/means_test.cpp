#include "statistics/load_statistics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace floes {
namespace means_test {

constexpr std::array values{1.0, 2.0, 6.0, 3.0, 100.0};

TEST(MeanOf, IsTheSumOverTheCount) {
    EXPECT_EQ(mean_of(values), 22.4);
    EXPECT_TRUE(std::isnan(mean_of({})));
}

TEST(BatchMeans, LeaveOutWhatIsLeftOver) {
    EXPECT_THAT(batch_means(values, 2), testing::ElementsAre(1.5, 4.5));
}

TEST(PartMeans, ShareTheValuesAcrossTheirEdges) {
    EXPECT_THAT(part_means(values, 2), testing::ElementsAre(testing::DoubleEq(6 / 2.5), testing::DoubleEq(106 / 2.5)));
    EXPECT_THAT(part_means(values, 5), testing::ElementsAreArray(values));
    EXPECT_THAT(part_means(std::array{1.0, 5.0}, 4), testing::ElementsAre(1, 1, 5, 5));
    std::vector<double> many(1000);
    for (std::size_t i = 0; i < many.size(); ++i) many[i] = std::sin(static_cast<double>(i * i));
    for (const std::size_t parts : {1u, 7u, 24u, 1001u})
        EXPECT_NEAR(mean_of(part_means(many, parts)), mean_of(many), 1e-15) << parts;
}

}  // namespace means_test
}  // namespace floes
