// Lines that hang, against values that others published and against what a cable must do.

#include "shapes/moorings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace catenary_test {

// MAP++ for the OC3 spar (OpenFAST r-test, 5MW_OC3Spar: summary of its moorings).
TEST(Catenary, OfTheOC3SparIsThePublishedOne) {
    const Cable line{.length = 902.2, .weight = 698.09, .stiffness = 3.84243e8, .friction = 0.001};
    const CablePull found = hang(line, 853.87 - 5.2, 320.0 - 70.0);
    EXPECT_NEAR(found.along / 736939.3, 1, 1e-4);
    EXPECT_NEAR(found.down / 535728.0, 1, 1e-4);
    EXPECT_NEAR(found.tension() / 911089.5, 1, 1e-4);
    EXPECT_NEAR(found.resting, 134.785, 0.02);
}

// MoorPy, tests/test_catenary.py.
TEST(Catenary, OfMoorPysTestIsThePublishedOne) {
    const CablePull found = hang({.length = 500, .weight = 800, .stiffness = 7.51e12, .friction = 0.1}, 400, 200);
    EXPECT_NEAR(found.along, 96643.4, 0.1);
    EXPECT_NEAR(found.down, 237751.8, 0.1);
    EXPECT_NEAR(found.anchor, 80418.6, 0.1);
    EXPECT_NEAR(found.resting, 202.81, 0.01);
}

// MoorDyn's chains (tests/Mooring/WD0050_Chain.txt and so on; static tensions of quasi_static_chain.cpp), from one that
// mostly lies to one that mostly hangs. They rest without friction there, on a bottom that gives way, which takes from
// the pull of the shallow one.
TEST(Catenary, OfMoorDynsChainsIsThePublishedOne) {
    struct Chain {
        double depth, away, length, fairlead, anchor, within;  // m, N, a share
    };
    const double weight = (390 - 1025 * std::numbers::pi / 4 * 0.252 * 0.252) * 9.80665;
    for (const Chain& chain :
         {Chain{50, 400, 410, 991.6e3, 826.2e3, 0.012}, Chain{200, 700, 760, 2065.4e3, 1402.2e3, 0.003},
          Chain{600, 1500, 1700, 5232.6e3, 3244.2e3, 0.0015}}) {
        const CablePull found =
            hang({.length = chain.length, .weight = weight, .stiffness = 1.674e9}, chain.away, chain.depth);
        EXPECT_NEAR(found.tension() / chain.fairlead, 1, chain.within) << chain.depth;
        EXPECT_NEAR(found.anchor / chain.anchor, 1, chain.within) << chain.depth;
    }
}

TEST(Catenary, HangsStraightDownWhereItIsLong) {
    const Cable line{.length = 300, .weight = 1000, .stiffness = 1e9};
    const CablePull found = hang(line, 150, 100);
    EXPECT_EQ(found.along, 0);
    EXPECT_NEAR(found.down, 1000 * 100, 10) << "the weight of what hangs, stretched a little";
    EXPECT_NEAR(found.down / 1000 + found.down * found.down / (2 * 1e9 * 1000), 100, 1e-9);
    EXPECT_LT(hang(line, 200.1, 100).along, 1e-3 * found.down) << "and goes over into a bow without a jump";
}

// A taut line is a rod: its stretch gives its tension.
TEST(Catenary, IsARodWhereItIsTaut) {
    const double chord = std::hypot(300, 400);
    const CablePull found = hang({.length = 0.99 * chord, .weight = 1, .stiffness = 1e8}, 300, 400);
    const double tension = 1e8 * (1 / 0.99 - 1);
    EXPECT_NEAR(found.tension() / tension, 1, 1e-3);
    EXPECT_NEAR(found.down / found.along, 400.0 / 300, 1e-3);
    EXPECT_EQ(found.resting, 0);
}

// It begins and ends where it is held, is as steep at its top as it pulls, and as long as the cable with its stretch.
TEST(Catenary, RunsFromItsEndToItsEnd) {
    for (const double x : {100.0, 360.0, 470.0, 477.0}) {
        const Cable line{.length = 500, .weight = 800, .stiffness = 3e8, .friction = x < 400 ? 0.0 : 0.5};
        constexpr int parts = 2000;
        const std::vector<Vec2> points = course(line, x, 150, parts);
        ASSERT_EQ(points.size(), parts + 1);
        EXPECT_NEAR((points.front() - Vec2(x, 150)).norm(), 0, 1e-6) << x;
        EXPECT_NEAR(points.back().norm(), 0, 1e-6) << x;
        const CablePull pull = hang(line, x, 150);
        const Vec2 top = points[0] - points[1];
        EXPECT_NEAR(std::atan2(top.y(), top.x()), std::atan2(pull.down, pull.along), 2e-3) << x;
        double length = 0;
        for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
        if (x == 100.0)
            EXPECT_LT(length, 500.0) << "of one that is slack what lies is drawn shorter";
        else
            EXPECT_NEAR(length, 500, 500 * pull.tension() / line.stiffness + 1e-3) << x;
    }
}

// The published equations are those of its shape: what comes out goes in again, on both sides of lying and hanging.
TEST(Catenary, PullsMoreTheFartherItIs) {
    const Cable line{.length = 500, .weight = 800, .stiffness = 3e8, .friction = 0.5};
    double before = -1;
    for (double x = 250; x < 480; x += 0.5) {
        const CablePull found = hang(line, x, 150);
        EXPECT_GE(found.along, before) << x;
        if (found.resting > 0) {
            EXPECT_NEAR(found.down, 800 * (500 - found.resting), 1e-3) << x;
        }
        before = found.along;
    }
    EXPECT_EQ(hang(line, 479, 150).resting, 0);
}

}  // namespace catenary_test
}  // namespace floes
