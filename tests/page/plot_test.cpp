// One diagram: positions of its ticks, and values drawn at the position given by the axis.

#include "page/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace floes {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(PlotAxis, HasRoundTicks) {
    EXPECT_THAT(ticks({"", 0, 10}, 5), ElementsAre(0, 2, 4, 6, 8, 10));
    EXPECT_THAT(ticks({"", -3, 12}, 4), ElementsAre(0, 5, 10));
    EXPECT_THAT(ticks({"", 1, 1000, true}, 5), ElementsAre(testing::DoubleEq(1), testing::DoubleEq(10),
                                                           testing::DoubleEq(100), testing::DoubleEq(1000)));
    EXPECT_THAT(ticks({"", -50, 120, false, {}, 30}, 2), ElementsAre(-30, 0, 30, 60, 90, 120));
    EXPECT_THAT(ticks({"", 1e-4, 1, true}, 2),
                ElementsAre(testing::DoubleNear(1e-4, 1e-12), testing::DoubleNear(1e-2, 1e-12), testing::DoubleEq(1)));
}

TEST(PlotAxis, LiesAroundItsValues) {
    const Axis free = axis_around("N", std::vector<double>{10, 20, nan}, false);
    EXPECT_DOUBLE_EQ(free.low, 9.5);
    EXPECT_DOUBLE_EQ(free.high, 20.5);
    const Axis from_zero = axis_around("N", std::vector<double>{10, 20}, true);
    EXPECT_DOUBLE_EQ(from_zero.low, 0);
    EXPECT_DOUBLE_EQ(from_zero.high, 21);
    const Axis empty = axis_around("N", std::vector<double>{nan}, true);
    EXPECT_LT(empty.low, empty.high);
}

// 64 from the left, 16 from the right, 28 from above and 46 from below: the middle of a 280 x 174 figure is (164, 78).
TEST(Plot, PutsAValueWhereTheAxesSay) {
    Plot plot("test", {"m", 0, 10}, {"N", 1, 100, true}, {280, 174});
    plot.dot(5, 10, "c0", 3);
    EXPECT_THAT(plot.svg(), HasSubstr("<circle class=\"dot c0\" cx=\"164.0\" cy=\"78.0\" r=\"3.0\"/>"));
}

TEST(Plot, FillsCellsByTheirShare) {
    Plot plot("test", {"m", 0, 10}, {"N", 0, 10}, {280, 174});
    plot.cell(5, 2, 1, 4, 0.25, "heat");
    plot.cell(0, 0, 1, 1, 0, "cold");
    plot.cell(0, 0, 1, 1, nan, "cold");
    EXPECT_THAT(plot.svg(), HasSubstr("<rect class=\"area heat\" x=\"164.0\" y=\"68.0\" width=\"20.0\" height=\"40.0\" "
                                      "fill-opacity=\"0.25\"/>"));
    EXPECT_THAT(plot.svg(), Not(HasSubstr("cold")));
}

TEST(Plot, LeavesOutWhatIsNotFinite) {
    Plot plot("test", {"m", 0, 10}, {"N", 0, 10});
    plot.dot(nan, 1, "c0");
    plot.line({{0, 0}, {1, nan}, {2, 2}, {3, 3}}, "c1");
    plot.text(1, std::numeric_limits<double>::infinity(), "far away", "start");
    EXPECT_THAT(plot.svg(), Not(HasSubstr("nan")));
    EXPECT_THAT(plot.svg(), Not(HasSubstr("inf")));
    EXPECT_THAT(plot.svg(), Not(HasSubstr("far away")));
    EXPECT_THAT(plot.svg(), HasSubstr("M192"));  // the line begins anew behind the gap
}

TEST(Plot, EscapesWords) {
    Plot plot("a < b & \"c\"", {"<m>", 0, 1}, {"N", 0, 1});
    EXPECT_THAT(plot.svg(), HasSubstr("aria-label=\"a &lt; b &amp; &quot;c&quot;\""));
    EXPECT_THAT(plot.svg(), HasSubstr("&lt;m&gt;"));
}

}  // namespace
}  // namespace floes
