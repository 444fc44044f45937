// Figures as data.

#include "tables/figure.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace floes {
namespace figure_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Axes, LieAroundItsValues) {
    const Axis free = axis_around("N", std::vector<double>{10, 20, nan}, false);
    EXPECT_DOUBLE_EQ(free.low, 9.5);
    EXPECT_DOUBLE_EQ(free.high, 20.5);
    const Axis from_zero = axis_around("N", std::vector<double>{10, 20}, true);
    EXPECT_DOUBLE_EQ(from_zero.low, 0);
    EXPECT_DOUBLE_EQ(from_zero.high, 21);
    const Axis empty = axis_around("N", std::vector<double>{nan}, true);
    EXPECT_LT(empty.low, empty.high);
}

TEST(Figures, HaveOneScaleForBothAxesWhereAsked) {
    const Figure::Size size = to_scale(4, 2, 480);  // 100 for a metre, and room for axes and labels
    EXPECT_EQ(size.width, 80 + 400);
    EXPECT_EQ(size.height, 74 + 200);
    EXPECT_EQ(to_scale(1, 10, 480).height, 74 + 420);
}

TEST(Figures, CloseABandOnItsWayBack) {
    Figure figure;
    figure.band({{0, 1}, {1, 2}}, {{0, 3}, {1, 4}}, "veil");
    const Figure::Points outline{{0, 1}, {1, 2}, {1, 4}, {0, 3}};
    EXPECT_EQ(std::get<Figure::Area>(figure.marks.front()).outline, outline);
}

}  // namespace figure_test
}  // namespace floes
