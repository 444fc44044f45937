#include "statistics/load_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace floes {
namespace load_map_test {

constexpr double degree = std::numbers::pi / 180;

TEST(AngleBin, IsThatOfTheAngle) {
    for (int k = -1799; k < 1800; ++k) {
        const double angle = 0.1 * k + 0.05;
        const auto bin = static_cast<std::size_t>(std::floor((angle + 180) / 10));
        for (const double radius : {1e-9, 0.6, 1e9})
            EXPECT_EQ(angle_bin(radius * std::cos(angle * degree), radius * std::sin(angle * degree)), bin) << angle;
        EXPECT_LT(std::abs(middle_angle(bin) - angle), 5);
    }
}

TEST(AngleBin, PutsEveryEdgeSomewhere) {
    EXPECT_EQ(angle_bin(1, 0), 18u);
    EXPECT_EQ(angle_bin(0, 1), 27u);
    EXPECT_EQ(angle_bin(0, -1), 8u);
    EXPECT_EQ(angle_bin(-1, 0), 35u);
    EXPECT_EQ(angle_bin(-1, -1e-300), 0u);
    EXPECT_LT(angle_bin(0, 0), LoadMap::angles);
}

TEST(ContactBins, AreMeansByHeightAndAngle) {
    ContactBins bins(-0.4, 0.2);  // 5 cm each
    bins.add(1, -0.399, 0.1, 8, 10);
    bins.add(1, -0.352, 0.1, 4, 5);
    bins.add(1, -0.348, 0.1, 2, 3);
    bins.add(-1, -7, -0.01, -1, 1);  // below the keel
    bins.add(0.01, 7, 1, 6, 7);      // above the top
    const LoadMap map = bins.means(4);
    EXPECT_EQ(map.surge[18], 3);
    EXPECT_EQ(map.normal[18], 3.75);
    EXPECT_EQ(map.surge[36 + 18], 0.5);
    EXPECT_EQ(map.surge[0], -0.25);
    EXPECT_EQ(map.normal[11 * 36 + 26], 1.75);
    EXPECT_EQ(std::accumulate(map.surge.begin(), map.surge.end(), 0.0), 19 / 4.0);
    EXPECT_NEAR(middle_height(0), 1 / 24.0, 1e-15);
}

}  // namespace load_map_test
}  // namespace floes
