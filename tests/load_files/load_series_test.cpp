// The load in other programs' axes and over other steps: closed forms, and impulses that stay.

#include "load_files/load_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/vector.hpp"

namespace floes {
namespace load_series_test {

constexpr double right_angle = std::numbers::pi / 2;

/// Cells of 1 s with a force along X only.
LoadSeries along_x(std::vector<double> values) {
    const std::vector<double> none(values.size(), 0.0);
    return {.step = 1, .force = {std::move(values), none, none}, .moment = {}};
}

TEST(LoadSeries, OfAStraightTowPushesAgainstIt) {
    const std::vector<double> surge{5}, sway{3}, heave{-2};
    const LoadSeries made = load_series({0.5, surge, sway, heave, {}, {}}, LoadAxes::earth);
    EXPECT_EQ(made.force[0][0], -5);  // ice ahead
    EXPECT_EQ(made.force[1][0], -3);  // sway is to starboard, Y to port
    EXPECT_EQ(made.force[2][0], -2);
    EXPECT_TRUE(made.moment.empty());
    EXPECT_EQ(made.length(), 0.5);
}

// docs/campaign_file.md: F_x = -surge cos ψ + sway sin ψ, F_z = surge sin ψ + sway cos ψ, and Y = -z.
TEST(LoadSeries, OfATurnedHullIsThatOfTheFilesPage) {
    const double yaw_angle = 0.3;
    const std::vector<double> surge{5}, sway{3}, heave{-2}, yaw{yaw_angle}, yaw_load{7};
    const HullHistories stored{0.5, surge, sway, heave, yaw, yaw_load};
    const LoadSeries earth = load_series(stored, LoadAxes::earth);
    EXPECT_NEAR(earth.force[0][0], -5 * std::cos(yaw_angle) + 3 * std::sin(yaw_angle), 1e-12);
    EXPECT_NEAR(earth.force[1][0], -(5 * std::sin(yaw_angle) + 3 * std::cos(yaw_angle)), 1e-12);
    EXPECT_EQ(earth.moment[0], 7);  // it turns the bow to port, which is from X towards Y
    const LoadSeries own = load_series(stored, LoadAxes::hull);
    EXPECT_EQ(own.force[0][0], -5);
    EXPECT_EQ(own.force[1][0], -3);
}

// Ice ahead pushes level on a bow that is lifted by φ: along the hull's own axes F cos φ aft and F sin φ up. Starboard
// down by φ, up leans to starboard, and a push to port is F cos φ against sway and F sin φ down.
TEST(LoadSeries, OfAHullThatPitchesOrRollsIsLevel) {
    const double angle = 0.1;
    const std::vector<double> along{4 * std::cos(angle)}, against{-4 * std::cos(angle)}, up{4 * std::sin(angle)},
        down{-4 * std::sin(angle)};
    const std::vector<double> none{0}, tilt{angle}, yaw{right_angle}, yaw_load{7};
    const HullHistories pitched{1, along, none, up, none, yaw_load, tilt, none};
    const HullHistories rolled{1, none, against, down, none, yaw_load, none, tilt};
    for (const LoadAxes axes : {LoadAxes::earth, LoadAxes::hull}) {
        const LoadSeries from_ahead = load_series(pitched, axes);
        EXPECT_NEAR(from_ahead.force[0][0], -4, 1e-12);
        EXPECT_NEAR(from_ahead.force[1][0], 0, 1e-12);
        EXPECT_NEAR(from_ahead.force[2][0], 0, 1e-12);
        EXPECT_EQ(from_ahead.moment[0], 7) << "it is about the vertical already";
        const LoadSeries from_starboard = load_series(rolled, axes);
        EXPECT_NEAR(from_starboard.force[0][0], 0, 1e-12);
        EXPECT_NEAR(from_starboard.force[1][0], 4, 1e-12);
        EXPECT_NEAR(from_starboard.force[2][0], 0, 1e-12);
    }
    const HullHistories turned{1, along, none, up, yaw, yaw_load, tilt, none};
    EXPECT_NEAR(load_series(turned, LoadAxes::earth).force[1][0], -4, 1e-12);
    EXPECT_NEAR(load_series(turned, LoadAxes::hull).force[0][0], -4, 1e-12);
}

// As a run records it: yaw, then pitch, then roll.
TEST(LoadSeries, UndoesTheTurnsInTheirOrder) {
    const StructurePose pose{.yaw = 0.7, .pitch = 0.2, .roll = -0.3};
    const Vec3 load(-5, 1, 2);
    const Vec3 own = pose.in_own_axes(load);
    const std::vector<double> surge{-own.x()}, sway{own.z()}, heave{own.y()};
    const std::vector<double> yaw{pose.yaw}, pitch{pose.pitch}, roll{pose.roll};
    const LoadSeries earth = load_series({1, surge, sway, heave, yaw, {}, pitch, roll}, LoadAxes::earth);
    EXPECT_NEAR(earth.force[0][0], load.x(), 1e-12);
    EXPECT_NEAR(earth.force[1][0], -load.z(), 1e-12);
    EXPECT_NEAR(earth.force[2][0], load.y(), 1e-12);
}

// A bow that has turned a quarter to port lies along Y: ice ahead of it pushes along -Y.
TEST(LoadSeries, OfABowToPortComesFromPort) {
    const std::vector<double> surge{5}, none{0}, yaw{right_angle}, yaw_load{0};
    const LoadSeries made = load_series({1, surge, none, none, yaw, yaw_load}, LoadAxes::earth);
    EXPECT_NEAR(made.force[0][0], 0, 1e-12);
    EXPECT_NEAR(made.force[1][0], -5, 1e-12);
}

TEST(LoadSeries, OfATowAnotherWayTurnsWithIt) {
    const std::vector<double> surge{5}, sway{3}, none{0};
    const LoadSeries back = load_series({1, surge, sway, none, {}, {}}, LoadAxes::earth, 2 * right_angle);
    EXPECT_NEAR(back.force[0][0], 5, 1e-12);
    EXPECT_NEAR(back.force[1][0], 3, 1e-12);
    const LoadSeries left = load_series({1, surge, sway, none, {}, {}}, LoadAxes::earth, right_angle);
    EXPECT_NEAR(left.force[0][0], 3, 1e-12);
    EXPECT_NEAR(left.force[1][0], -5, 1e-12);
}

TEST(LoadSeries, GrowsByFroude) {
    LoadSeries small = along_x({2});
    small.moment = {3};
    const LoadSeries large = scaled(small, 4);
    EXPECT_EQ(large.step, 2);
    EXPECT_EQ(large.force[0][0], 2 * 64);
    EXPECT_EQ(large.moment[0], 3 * 256);
}

TEST(Resampled, HasTheMeansOfWhatItCovers) {
    const LoadSeries made = resampled(along_x({1, 2, 4, 8, 16, 32}), 0, 6, 1.5);
    ASSERT_EQ(made.cells(), 4u);
    EXPECT_NEAR(made.force[0][0], (1 + 2 * 0.5) / 1.5, 1e-12);
    EXPECT_NEAR(made.force[0][1], (2 * 0.5 + 4) / 1.5, 1e-12);
    EXPECT_NEAR(made.force[0][2], (8 + 16 * 0.5) / 1.5, 1e-12);
    EXPECT_NEAR(made.force[0][3], (16 * 0.5 + 32) / 1.5, 1e-12);
}

TEST(Resampled, KeepsTheImpulse) {
    LoadSeries series{.step = 0.02, .force = {}, .moment = {}};
    for (int k = 0; k < 6000; ++k) {
        series.force[0].push_back(k % 7 == 0 ? 1000 * std::sin(0.1 * k) : 0);
        series.force[1].push_back(std::cos(0.3 * k));
        series.force[2].push_back(k);
        series.moment.push_back(-k % 11);
    }
    for (const double step : {0.02, 0.05, 0.1, 0.13, 0.75, 12.0}) {
        const double length = step * static_cast<double>(whole_steps(0, 120, step));
        const LoadSeries made = resampled(series, 0, 120, step);
        // Of as much of the old one: its last cell in part.
        std::array<double, 4> expected{};
        for (std::size_t k = 0; k < series.cells(); ++k) {
            const double share = std::clamp(length - 0.02 * static_cast<double>(k), 0.0, 0.02);
            for (std::size_t axis = 0; axis < 3; ++axis) expected[axis] += share * series.force[axis][k];
            expected[3] += share * series.moment[k];
        }
        for (std::size_t axis = 0; axis < 4; ++axis)
            EXPECT_NEAR(impulse(made)[axis], expected[axis], 1e-8 * (1 + std::abs(expected[axis]))) << step;
    }
}

TEST(Resampled, BeginsWhereItIsAsked) {
    const LoadSeries made = resampled(along_x({1, 2, 4, 8}), 1, 4, 1);
    EXPECT_EQ(made.force[0], (std::vector<double>{2, 4, 8}));
    EXPECT_EQ(whole_steps(0, 0.3, 0.1), 3u);
    EXPECT_EQ(whole_steps(0, 0.29, 0.1), 2u);
    EXPECT_EQ(whole_steps(2, 1, 0.1), 0u);
}

}  // namespace load_series_test
}  // namespace floes
