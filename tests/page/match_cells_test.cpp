// A matching seen along one or two of its inputs, from points given by hand, and the page made of a formula's results.

#include "page/match_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace floes {
namespace match_cells_test {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;
using testing::Not;

/// Three axes. In halves of the first and the third: two points at the lower left, one of them ruled out, one exactly
/// at the level at the lower right, one ruled out at the upper right, none at the upper left.
Matching four_points() {
    Matching found;
    found.sampled = 4;
    found.left = 2;
    found.points.resize(4, 3);
    found.points << -0.5, 0.9, -0.5,  //
        -1, -0.9, -0.1,               //
        0.5, 0, -1,                   //
        1, 0, 1;
    found.implausibility = Eigen::Vector4d(1.5, 7, 3, 4);
    found.best = found.points.row(0).transpose();
    return found;
}

TEST(MatchCells, HaveTheLeastImplausibilityAndTheShareLeft) {
    const MatchCells cells = match_cells(four_points(), 0, 2, 2);
    EXPECT_THAT(cells.least, ElementsAre(1.5, 3, IsNan(), 4));
    EXPECT_THAT(cells.depth, ElementsAre(0.5, 1, IsNan(), 0));
    EXPECT_EQ(cells.least_at(1, 0), 3);
    EXPECT_EQ(cells.depth_at(0, 0), 0.5);
}

TEST(MatchCells, LieAlongTheAxesAsked) {
    const MatchCells cells = match_cells(four_points(), 2, 0, 2);
    EXPECT_THAT(cells.least, ElementsAre(1.5, IsNan(), 3, 4));
}

TEST(MatchCells, ShareAlongOneAxis) {
    EXPECT_THAT(share_along(four_points(), 0, 2), ElementsAre(0.5, 0.5));
    EXPECT_THAT(share_along(four_points(), 2, 2), ElementsAre(DoubleEq(2.0 / 3), 0));
    EXPECT_THAT(share_along(four_points(), 1, 4), ElementsAre(0, IsNan(), 0.5, 1));
}

TEST(MatchCells, AreAsFineAsThePointsFill) {
    Matching found;
    for (const auto& [sampled, count] : {std::pair(64, 4), std::pair(1024, 11), std::pair(8192, 16)}) {
        found.sampled = sampled;
        EXPECT_EQ(match_cell_count(found), count);
    }
}

/// Twelve points on two axes, the second of them logarithmic; the load rises with the first by 10 N.
MatchPageData told(double measured, bool held_out) {
    MatchPageData made;
    made.data.axes = {{"structure.keel_radius_m", 0.4, 0.5}, {"joint.cfm", 0.001, 0.1, AxisScale::log}};
    TargetData target;
    target.target.quantity = *any_quantity("mean_load");
    target.target.value = measured;
    target.target.held_out = held_out;
    for (int k = 0; k < 12; ++k) {
        const double x = -1 + 2 * k / 11.0;
        made.data.points.push_back({{x, std::sin(5.0 * k)}, 0, k});
        target.point.push_back(k);
        target.mean.push_back(30 + 5 * x + 0.1 * std::sin(9.0 * k));
        target.sample_variance.push_back(0.04);
        target.variance.push_back(0.04);
        target.runs.push_back(4);
    }
    made.data.targets = {target};
    made.targets = emulate(made.data);
    made.found = match(made.data, made.targets, 1024, 1);
    made.trail = {{"first.h5", 12, made.found.share()}};
    made.command = "floes match first.h5";
    return made;
}

TEST(MatchPage, ShowsWhatIsLeftInTheKeysUnits) {
    const std::string page = match_page(told(30, false));
    EXPECT_THAT(page, HasSubstr("What is not ruled out, for each pair of inputs"));
    EXPECT_THAT(page, HasSubstr(">0.45</text>"));  // the middle of the linear axis
    EXPECT_THAT(page, HasSubstr(">0.01</text>"));  // of the logarithmic one
    EXPECT_THAT(page, HasSubstr("(log)"));
    EXPECT_THAT(page, HasSubstr("Predictions of left-out points of mean_load"));
    EXPECT_THAT(page, HasSubstr("What each target rules out"));
    EXPECT_THAT(page, Not(HasSubstr("nothing left")));
    EXPECT_THAT(page, Not(HasSubstr("Wave by wave")));
    EXPECT_THAT(page, Not(HasSubstr("nan")));
    EXPECT_THAT(page, Not(HasSubstr("inf\"")));
}

// One input has no pairs: its page has a curve and no empty squares.
TEST(MatchPage, OfOneInputDrawsTheImplausibilityAlongIt) {
    MatchPageData made = told(30, false);
    made.data.axes.pop_back();
    for (MatchPoint& point : made.data.points) point.coordinates.pop_back();
    made.targets = emulate(made.data);
    made.found = match(made.data, made.targets, 256, 1);
    const std::string page = match_page(made);
    EXPECT_THAT(page, HasSubstr("Implausibility along the input"));
    EXPECT_THAT(page, Not(HasSubstr("pair")));
    EXPECT_THAT(page, Not(HasSubstr("Correlations")));
}

TEST(MatchPage, SaysThatNothingIsLeft) {
    const std::string page = match_page(told(60, false));
    EXPECT_THAT(page, HasSubstr("No combination of the inputs meets all of them"));
    EXPECT_THAT(page, HasSubstr(">nothing left</text>"));
    EXPECT_THAT(page, Not(HasSubstr("nan")));
}

TEST(MatchPage, SaysWhichTargetIsNotUsed) {
    const std::string page = match_page(told(60, true));
    EXPECT_THAT(page, HasSubstr("<li>Not used: mean_load: held out</li>"));
    EXPECT_THAT(page, Not(HasSubstr("aria-label=\"What each target rules out\"")));
}

TEST(MatchPage, FollowsTheWaves) {
    MatchPageData data = told(30, false);
    data.trail = {{"first.h5", 12, 0.25}, {"second.h5", 30, 0.031}};
    EXPECT_THAT(match_page(data), HasSubstr("<td>second.h5</td><td>30</td><td>3.1</td>"));
    data.trail.front().share = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(match_page(data), HasSubstr("<td>first.h5</td><td>12</td><td>–</td>"));
}

}  // namespace match_cells_test
}  // namespace floes
