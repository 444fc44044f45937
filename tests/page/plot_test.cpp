// One diagram: positions of its ticks, and values drawn at the position given by the axis.

#include "page/section_html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace floes {
namespace plot_test {

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

// 64 from the left, 16 from the right, 28 from above and 46 from below: the middle of a 280 x 174 figure is (164, 78).
TEST(Plot, PutsAValueWhereTheAxesSay) {
    Figure figure{.description = "test", .x = {"m", 0, 10}, .y = {"N", 1, 100, true}, .size = {280, 174}};
    figure.dot(5, 10, "c0", 3);
    EXPECT_THAT(svg(figure), HasSubstr("<circle class=\"dot c0\" cx=\"164.0\" cy=\"78.0\" r=\"3.0\"/>"));
}

TEST(Plot, FillsCellsByTheirShare) {
    Figure figure{.description = "test", .x = {"m", 0, 10}, .y = {"N", 0, 10}, .size = {280, 174}};
    figure.cell(5, 2, 1, 4, 0.25, "heat");
    figure.cell(0, 0, 1, 1, 0, "cold");
    figure.cell(0, 0, 1, 1, nan, "cold");
    EXPECT_THAT(svg(figure), HasSubstr("<rect class=\"area heat\" x=\"164.0\" y=\"68.0\" width=\"20.0\" "
                                       "height=\"40.0\" fill-opacity=\"0.25\"/>"));
    EXPECT_THAT(svg(figure), Not(HasSubstr("cold")));
}

TEST(Plot, LeavesOutWhatIsNotFinite) {
    Figure figure{.description = "test", .x = {"m", 0, 10}, .y = {"N", 0, 10}};
    figure.dot(nan, 1, "c0");
    figure.line({{0, 0}, {1, nan}, {2, 2}, {3, 3}}, "c1");
    figure.text(1, std::numeric_limits<double>::infinity(), "far away", "start");
    EXPECT_THAT(svg(figure), Not(HasSubstr("nan")));
    EXPECT_THAT(svg(figure), Not(HasSubstr("inf")));
    EXPECT_THAT(svg(figure), Not(HasSubstr("far away")));
    EXPECT_THAT(svg(figure), HasSubstr("M192"));  // the line begins anew behind the gap
}

// Names of 100 letters take 700 of the 720 units, so each has a row; the figure grows by the rows above its own.
TEST(Plot, BreaksALegendIntoRows) {
    Figure figure{.description = "test", .x = {"m", 0, 10}, .y = {"N", 0, 10}, .size = {720, 300}};
    figure.legend = {{"c0", std::string(100, 'a')}, {"c1", std::string(100, 'b')}};
    EXPECT_THAT(svg(figure), HasSubstr("viewBox=\"0 0 720 318\""));
    EXPECT_THAT(svg(figure), HasSubstr("<g transform=\"translate(0 18)\">"));
    figure.legend.pop_back();
    EXPECT_THAT(svg(figure), HasSubstr("viewBox=\"0 0 720 300\""));
}

TEST(PlotAxis, HasTwosAndFivesWhereThereAreFewDecades) {
    EXPECT_THAT(
        ticks({"", 0.015, 0.6, true}, 8),
        ElementsAre(testing::DoubleNear(0.02, 1e-12), testing::DoubleNear(0.05, 1e-12), testing::DoubleNear(0.1, 1e-12),
                    testing::DoubleNear(0.2, 1e-12), testing::DoubleNear(0.5, 1e-12)));
}

TEST(Plot, EscapesWords) {
    const Figure figure{.description = "a < b & \"c\"", .x = {"<m>", 0, 1}, .y = {"N", 0, 1}};
    EXPECT_THAT(svg(figure), HasSubstr("aria-label=\"a &lt; b &amp; &quot;c&quot;\""));
    EXPECT_THAT(svg(figure), HasSubstr("&lt;m&gt;"));
}

}  // namespace plot_test
}  // namespace floes
