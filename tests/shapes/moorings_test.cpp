// Springs and lines against closed forms.

#include "shapes/moorings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "support/published_lines.hpp"

namespace floes {
namespace moorings_test {

constexpr double pi = std::numbers::pi;

/// Lines of 500 m on a circle of 30 m, leading straight outwards.
Moorings spread(int lines) {
    Moorings moorings{.mass = 1e7, .gyration = 20};
    for (int i = 0; i < lines; ++i) {
        const double azimuth = 2 * pi * i / lines;
        moorings.lines.push_back({.x = 30 * std::cos(azimuth),
                                  .z = 30 * std::sin(azimuth),
                                  .azimuth = azimuth,
                                  .distance = 500,
                                  .pretension = 2e5,
                                  .stiffness = 1e4});
    }
    return moorings;
}

TEST(Moorings, LinePullsTowardsItsAnchor) {
    const Moorings moorings = spread(4);
    const LinePull ahead = pull(moorings, moorings.lines[0], in_plane({-3, 0, 0}));
    EXPECT_DOUBLE_EQ(ahead.tension, 2e5 + 3e4);
    EXPECT_NEAR(ahead.force[0], 2.3e5, 1e-6);
    EXPECT_NEAR(ahead.force[1], 0, 1e-6);
    EXPECT_NEAR((ahead.anchor - Vec3(530, 0, 0)).norm(), 0, 1e-9);
    EXPECT_NEAR((ahead.fairlead - Vec3(27, 0, 0)).norm(), 0, 1e-12);
    EXPECT_EQ(tension(moorings, moorings.lines[0], -21), 0) << "a slack line does not push";
}

// n lines straight outwards: n/2 (k + T/s) in the plane, and by a turn ψ about the axis each line's pull turns back
// with T R (R + s)/s ψ.
TEST(Moorings, SpreadHasItsStiffness) {
    for (const int lines : {3, 4, 12}) {
        const Vec6 stiffness = spread(lines).stiffness().diagonal();
        EXPECT_NEAR(stiffness[0] / (0.5 * lines * (1e4 + 2e5 / 500)), 1, 1e-8) << lines;
        EXPECT_NEAR(stiffness[1] / stiffness[0], 1, 1e-8) << lines;
        EXPECT_NEAR(stiffness[2] / (lines * 2e5 * 30 * 530 / 500), 1, 1e-8) << lines;
    }
}

// An eccentric line turns the structure: M = r_z F_x - r_x F_z, positive where +z turns to +x.
TEST(Moorings, FairleadsTurnWithTheStructure) {
    Moorings moorings{.mass = 1e7};
    moorings.lines.push_back({.x = 0, .z = 10, .azimuth = 0, .distance = 1e6, .pretension = 1e5, .stiffness = 1e3});
    EXPECT_NEAR(pull(moorings, moorings.lines[0], Vec6::Zero()).force[2], 1e6, 1);
    EXPECT_NEAR(turned({0, 10}, pi / 2).x(), 10, 1e-12) << "+z turns to +x";
    const LinePull turned_back = pull(moorings, moorings.lines[0], in_plane({0, 0, pi / 2}));
    EXPECT_NEAR(turned_back.fairlead.x(), 10, 1e-12);
    EXPECT_NEAR(turned_back.force[2], 0, 200) << "it points at its anchor: at rest";
    EXPECT_NEAR(turned_back.tension, 1e5 - 1e3 * 10, 1);
}

TEST(Moorings, CurveBeginsAtThePretension) {
    Moorings moorings{.mass = 1e7};
    moorings.curve = {{0, 0}, {10, 1e5}, {12, 3e5}};
    const MooringLine line{.distance = 500, .pretension = 5e4};
    EXPECT_NEAR(tension(moorings, line, 0), 5e4, 1e-9);
    EXPECT_NEAR(tension(moorings, line, 5), 1e5, 1e-9);
    EXPECT_NEAR(tension(moorings, line, 6), 2e5, 1e-9);
    EXPECT_EQ(tension(moorings, line, -6), 0) << "slack";
    try {
        tension(moorings, line, 8);
        FAIL() << "nobody has said what it pulls there";
    } catch (const MemberFailure& failure) {
        EXPECT_STREQ(failure.what(), "moorings.line_curve has rows from 0 to 12 m, and the structure came to 13 m.");
    }
    MooringLine breaks = line;
    breaks.break_load = 2.5e5;
    EXPECT_NEAR(tension(moorings, breaks, 8), 4e5, 1e-9) << "in the step in which it breaks";
    breaks.break_load = 5e5;
    EXPECT_THROW(tension(moorings, breaks, 8), MemberFailure);
    moorings.curve.front().tension = 1e4;
    EXPECT_THROW(tension(moorings, line, -20), MemberFailure);
}

/// Eight of 300 m from a turret 40 m ahead, which pull each other straight at rest; hanging ones in 100 m of water.
Moorings turret_ship(bool hanging) {
    Moorings moorings{.mass = 1e7, .gyration = 30};
    moorings.turret = {.lines = true, .ahead = 40};
    for (int k = 0; k < 8; ++k) {
        const double azimuth = k * pi / 4;
        const double x = 5 * std::cos(azimuth);
        const double z = 5 * std::sin(azimuth);
        if (hanging)
            moorings.hanging.push_back({.fairlead = {x, -10, z},
                                        .azimuth = azimuth,
                                        .distance = 300,
                                        .depth = 100,
                                        .cable = {.length = 320, .weight = 1000, .stiffness = 5e8}});
        else
            moorings.lines.push_back(
                {.x = x, .z = z, .azimuth = azimuth, .distance = 300, .pretension = 2e5, .stiffness = 4e4});
    }
    return moorings;
}

/// Of all lines.
Vec6 pull_together(const Moorings& moorings, const Vec6& offset) {
    Vec6 sum = Vec6::Zero();
    for (std::size_t k = 0; k < moorings.line_count(); ++k) sum += pull(moorings, k, offset).force;
    return sum;
}

// Its lines know where the turret is and not how the hull lies: about the turret alone nothing changes, and what they
// pull acts at its axis.
TEST(Moorings, LinesOfATurretDoNotTurnWithTheHull) {
    for (const bool hanging : {false, true}) {
        const Moorings moorings = turret_ship(hanging);
        const Vec6 beside = pull_together(moorings, in_plane({3, -2, 0}));
        for (const double yaw : {0.3, -1.2, pi / 2, 3.0}) {
            const Vec2 arm = turned({40, 0}, yaw);
            const Vec2 axis = Vec2(40, 0) - arm;  // of the structure, while its turret is in its place
            const Vec6 about = pull_together(moorings, in_plane({axis.x() + 3, axis.y() - 2, yaw}));
            EXPECT_NEAR(about[0], beside[0], 1e-9 * beside.norm()) << yaw;
            EXPECT_NEAR(about[1], beside[1], 1e-9 * beside.norm()) << yaw;
            EXPECT_NEAR(about[3], beside[3], 1e-9 * beside.norm()) << yaw;
            EXPECT_NEAR(about[2], arm.y() * beside[0] - arm.x() * beside[1], 1e-7 * beside.norm()) << yaw;
        }
    }
}

// On a turret of stiffness k the hull swings with k/m in surge, with k (1/m + a²/I) in sway and yaw together, and turns
// about the turret with nothing to hold it but the load.
TEST(Moorings, AHullTurnsAboutItsTurretFreely) {
    const Moorings moorings = turret_ship(false);
    const double k = 4 * (4e4 + 2e5 / 300);
    const std::vector<NaturalMode> modes = natural_modes(moorings, Mat6::Zero());
    ASSERT_EQ(modes.size(), 3U);
    EXPECT_NEAR(modes[0].period, 2 * pi * std::sqrt(1e7 / k), 1e-6);
    std::vector<double> others{modes[1].period, modes[2].period};
    std::ranges::sort(others);
    EXPECT_NEAR(others[0], 2 * pi / std::sqrt(k * (1 / 1e7 + 1600 / 9e9)), 1e-6);
    EXPECT_TRUE(std::isinf(others[1]));
    EXPECT_EQ(std::ranges::count_if(modes, [&](const NaturalMode& mode) { return weathervanes(moorings, mode); }), 1);
    Moorings astern = moorings;
    astern.turret.ahead = -40;
    for (const NaturalMode& mode : natural_modes(astern, Mat6::Zero())) EXPECT_FALSE(weathervanes(astern, mode));
    for (const NaturalMode& mode : natural_modes(turret_ship(true), Mat6::Zero()))
        EXPECT_EQ(std::isinf(mode.period), weathervanes(moorings, mode));
}

// Towards where the turret would be by the distance from there, whatever the structure's heading; and about the axis
// by the turret's arm.
TEST(Moorings, TurretPullsByItsCurve) {
    Moorings moorings{.mass = 1e7, .gyration = 20};
    moorings.turret.curve = {{0, 0}, {10, 1e6}, {12, 3e6}};
    moorings.turret.ahead = 40;
    EXPECT_EQ(turret_pull(moorings, Vec6::Zero()), Vec6::Zero());
    const Vec6 aside = turret_pull(moorings, in_plane({-3, 4, 0}));
    EXPECT_NEAR((aside - in_plane({3e5, -4e5, 40 * 4e5})).norm(), 0, 1e-6);
    EXPECT_NEAR(turret_pull(moorings, in_plane({0, 11, 0}))[1], -2e6, 1e-6);
    EXPECT_THROW(turret_pull(moorings, in_plane({0, 13, 0})), MemberFailure);
    const Vec6 round = turret_pull(moorings, in_plane({40, 40, pi / 2}));
    EXPECT_NEAR(round.norm(), 0, 1e-6) << "the bow along -z, the turret in its place";
    const Vec6 stiffness = moorings.stiffness().diagonal();
    EXPECT_NEAR((stiffness - in_plane({1e5, 1e5, 1600e5})).norm(), 0, 1e-6);
}

TEST(Moorings, PeriodsAreThoseOfMassAndStiffness) {
    Moorings moorings{.mass = 28e6, .gyration = 25, .added = {14e6}, .surge = 2.6e6, .yaw = 1e9};
    EXPECT_NEAR(moorings.period(Motion::surge), 2 * pi * std::sqrt(42e6 / 2.6e6), 1e-9);
    EXPECT_TRUE(std::isinf(moorings.period(Motion::sway)));
    EXPECT_NEAR(moorings.period(Motion::yaw), 2 * pi * std::sqrt(28e6 * 625 / 1e9), 1e-9);
    std::vector<NaturalMode> modes = natural_modes(moorings, Mat6::Zero());
    ASSERT_EQ(modes.size(), 3);
    EXPECT_NEAR(modes[0].period, moorings.period(Motion::surge), 1e-9);
    EXPECT_TRUE(std::isinf(modes[1].period));
    EXPECT_NEAR(modes[2].period, moorings.period(Motion::yaw), 1e-9);
    moorings.thrusters.gain[1] = 1e6;
    EXPECT_NEAR(moorings.period(Motion::sway), 2 * pi * std::sqrt(28e6 / 1e6), 1e-9);
}

// Jonkman's OC3 spar (NREL/TP-500-47535): three lines from fairleads 70 m down, 5.2 m from the axis. Published: the
// matrix about the still water line (forums.nrel.gov/t/6095), in its own axes, which differ in the signs of pitch.
TEST(Moorings, HangingLinesOfTheOC3SparHaveThePublishedStiffness) {
    Moorings moorings{.free = {true, true, true, true, true, true}, .mass = 7.46633e6};
    moorings.hanging = test::oc3_lines();
    const Mat6 found = moorings.stiffness();
    const auto of = [&](Motion a, Motion b) { return found(static_cast<int>(a), static_cast<int>(b)); };
    EXPECT_NEAR(of(Motion::surge, Motion::surge) / 41180, 1, 1e-3);
    EXPECT_NEAR(of(Motion::sway, Motion::sway) / 41180, 1, 1e-3);
    EXPECT_NEAR(of(Motion::heave, Motion::heave) / 11940, 1, 1e-3);
    EXPECT_NEAR(of(Motion::surge, Motion::pitch) / 2.821e6, 1, 3e-3);
    EXPECT_NEAR(of(Motion::sway, Motion::roll) / -2.821e6, 1, 3e-3);
    EXPECT_NEAR(of(Motion::pitch, Motion::pitch) / 3.111e8, 1, 3e-3);
    EXPECT_NEAR(of(Motion::roll, Motion::roll) / 3.111e8, 1, 3e-3);
    EXPECT_NEAR(of(Motion::yaw, Motion::yaw) / 1.156e7, 1, 3e-3);
    Vec6 sunk = Vec6::Zero();
    sunk[3] = -250;
    EXPECT_THROW(pull(moorings.hanging[0], sunk), MemberFailure);
    double down = 0;
    for (const HangingLine& line : moorings.hanging) down -= pull(line, Vec6::Zero()).force[3];
    EXPECT_NEAR(down / 1607181, 1, 1e-4);
}

// A matrix of a program with x ahead, y to port and z up: a body whose centre is low couples surge with pitch there as
// m z_G, and here, where pitch lifts the bow, as -m z_G.
TEST(Moorings, MatricesOfProgramsChangeTheSignsOfSwayAndPitch) {
    std::vector<std::vector<double>> rows(6, std::vector<double>(6, 0.0));
    const double m = 1e6;
    const double z = -20;
    for (std::size_t k = 0; k < 3; ++k) rows[k][k] = m;
    rows[3][3] = rows[4][4] = m * z * z;
    rows[0][4] = rows[4][0] = m * z;
    rows[1][3] = rows[3][1] = -m * z;
    const Moorings own{.mass = m, .height = z};
    EXPECT_NEAR((from_hydrodynamic_axes(rows) - own.inertia()).norm(), 0, 1e-6);
    EXPECT_EQ(Moorings{.added_mass = rows}.inertia(), from_hydrodynamic_axes(rows));
}

}  // namespace moorings_test
}  // namespace floes
