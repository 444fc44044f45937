// Which value stands for a quantile, and between which ranks the quantile lies: the tables of order statistics.

#include "inference/order_quantile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace floes {
namespace order_quantile_test {

/// 10, 20, ... from the largest down.
std::vector<double> falling(int count) {
    std::vector<double> values;
    for (int k = count; k > 0; --k) values.push_back(10.0 * k);
    return values;
}

// P(B <= 1) = 11 / 1024 for ten throws of a coin: the median lies between ranks 2 and 9 with 97.9 %, 3 and 8 with 89 %.
TEST(OrderQuantile, OfTheMedianOfTenLiesBetweenTheSecondAndTheNinth) {
    const OrderQuantile found = order_quantile(falling(10), 0.5);
    EXPECT_EQ(found.rank, 5);
    EXPECT_EQ(found.place, 5u);
    EXPECT_EQ(found.value, 50);
    EXPECT_EQ(found.low_rank, 2);
    EXPECT_EQ(found.high_rank, 9);
    EXPECT_EQ(found.low, 20);
    EXPECT_EQ(found.high, 90);
}

// 0.9^35 = 0.0250315 and 0.9^36 = 0.0225: 36 values are the first that bound it from above.
TEST(OrderQuantile, OfFewValuesHasNoUpperEnd) {
    const OrderQuantile few = order_quantile(falling(35), 0.9);
    EXPECT_EQ(few.high_rank, 36);
    EXPECT_EQ(few.high, std::numeric_limits<double>::infinity());
    EXPECT_EQ(order_quantile(falling(36), 0.9).high_rank, 36);
    const OrderQuantile twenty = order_quantile(falling(20), 0.9);
    EXPECT_EQ(twenty.rank, 18);
    EXPECT_EQ(twenty.low_rank, 15);  // P(B <= 14) = 0.0113, P(B <= 15) = 0.0432
    EXPECT_EQ(order_quantile(falling(3), 0.5).low_rank, 0);
    EXPECT_EQ(order_quantile(falling(3), 0.5).low, -std::numeric_limits<double>::infinity());
}

TEST(OrderQuantile, LeavesOutWhatIsNoNumber) {
    const double none = std::nan("");
    const OrderQuantile found = order_quantile(std::vector<double>{none, 3, none, 1, 2}, 0.99);
    EXPECT_EQ(found.count, 3);
    EXPECT_EQ(found.rank, 3);
    EXPECT_EQ(found.place, 1u);
    EXPECT_EQ(order_quantile(std::vector<double>{3, 1, 2}, 1.0 / 3).place, 1u);  // exactly one third: the least
}

}  // namespace order_quantile_test
}  // namespace floes
