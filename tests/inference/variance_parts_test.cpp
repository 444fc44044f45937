// Shares of the scatter of single runs, by hand and where the truth is known.

#include "inference/explained_variance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "inference/known_processes.hpp"

namespace floes {
namespace variance_parts_test {

// The example of Shrout and Fleiss, Table 2: six targets, four judges; ICC(3,1) = 0.71 in their Table 4.
TEST(ArrangementShare, IsThatOfItsSourcesExample) {
    const std::vector<std::vector<double>> judges{
        {9, 6, 8, 7, 10, 6}, {2, 1, 4, 1, 5, 2}, {5, 3, 6, 2, 6, 4}, {8, 2, 8, 6, 9, 7}};
    const ArrangementShare found = arrangement_share(judges);
    EXPECT_NEAR(found.share, 0.7148, 5e-5);
    EXPECT_NEAR(found.interval.low, 0.3425, 5e-4);
    EXPECT_NEAR(found.interval.high, 0.9459, 5e-4);
}

TEST(ArrangementShare, HoldsTheTruth) {
    const double truth = 0.3;
    int within = 0;
    double sum = 0;
    for (std::uint32_t trial = 0; trial < 400; ++trial) {
        RandomStream random{71, trial, StreamId::bootstrap, 0};
        std::vector<std::vector<double>> values(3);
        for (int arrangement = 0; arrangement < 12; ++arrangement) {
            const double common = known::normal(random);
            for (std::size_t k = 0; k < 3; ++k)
                values[k].push_back(30 * static_cast<double>(k) + std::sqrt(truth) * common +
                                    std::sqrt(1 - truth) * known::normal(random));
        }
        const ArrangementShare found = arrangement_share(values);
        within += found.interval.low <= truth && truth <= found.interval.high;
        sum += found.share / 400;
    }
    EXPECT_GE(within, 367);  // 95 % of 400: 367 or more with 99.8 %
    EXPECT_LE(within, 393);
    EXPECT_NEAR(sum, truth, 0.03);
}

TEST(ArrangementShare, OfTooLittleIsUndefined) {
    EXPECT_TRUE(std::isnan(arrangement_share({}).share));
    EXPECT_TRUE(std::isnan(arrangement_share(std::vector<std::vector<double>>{{1, 2, 3}}).share));
    EXPECT_TRUE(std::isnan(arrangement_share(std::vector<std::vector<double>>{{1, 2}, {2, 3}}).share));
    EXPECT_TRUE(std::isnan(arrangement_share(std::vector<std::vector<double>>{{1, 1, 1}, {2, 2, 2}}).share));
    EXPECT_EQ(arrangement_share(std::vector<std::vector<double>>{{1, 2, 3}, {2, 3, 4}}).share, 1);
    EXPECT_THROW(arrangement_share(std::vector<std::vector<double>>{{1, 2, 3}, {2, 3}}), InputError);
}

}  // namespace variance_parts_test
}  // namespace floes
