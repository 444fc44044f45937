// Lines that hang, against values that others published and against what a cable must do.

#include "shapes/catenary.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
