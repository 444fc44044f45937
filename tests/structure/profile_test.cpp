#include "structure/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"
#include "structure/tow.hpp"

namespace floes {
namespace {

TEST(Profile, DefaultIsTheConeOfTable2) {
    const Profile cone{Structure{}.profile};
    EXPECT_NEAR(2 * cone.waterline_radius(), 1.228, 1e-12);
    EXPECT_NEAR(2 * cone.maximum_radius(), 1.472, 1e-12);
    EXPECT_NEAR(cone.draught(), 0.443, 1e-12);
    EXPECT_NEAR(cone.top() - cone.bottom(), 0.565, 1e-12);
    ASSERT_EQ(cone.wall_angles().size(), 2u);
    EXPECT_NEAR(cone.wall_angles()[0], std::atan2(0.443, 0.614 - 0.499), 1e-12);
    EXPECT_NEAR(cone.wall_angles()[1], 45 * unit::degree, 1e-12);
}

TEST(Profile, RadiusIsLinearBetweenPointsAndZeroOutside) {
    const Profile profile{{{-1, 2}, {1, 4}}};
    EXPECT_DOUBLE_EQ(profile.radius_at(-1), 2);
    EXPECT_DOUBLE_EQ(profile.radius_at(-0.5), 2.5);
    EXPECT_DOUBLE_EQ(profile.radius_at(1), 4);
    EXPECT_EQ(profile.radius_at(-1.01), 0);
    EXPECT_EQ(profile.radius_at(1.01), 0);
}

TEST(Profile, ANarrowWaistIsNotFilledIn) {
    const Profile waist{{{-1, 1}, {-0.2, 0.3}, {0.5, 1}}};
    EXPECT_DOUBLE_EQ(waist.radius_at(-0.2), 0.3);
    const std::vector<Frustum> expected{{-1, 1, -0.2, 0.3}, {-0.2, 0.3, 0.5, 1}};
    EXPECT_EQ(waist.frusta(), expected);
    EXPECT_GT(waist.wall_angles()[0], 90 * unit::degree);
    EXPECT_LT(waist.wall_angles()[1], 90 * unit::degree);
}

TEST(Profile, AFlatRingHasAnAngleButNoFrustum) {
    const Profile stepped{{{-1, 0.5}, {-0.3, 0.5}, {-0.3, 1}, {0.2, 1}}};
    const std::vector<Frustum> expected{{-1, 0.5, -0.3, 0.5}, {-0.3, 1, 0.2, 1}};
    EXPECT_EQ(stepped.frusta(), expected);
    EXPECT_DOUBLE_EQ(stepped.radius_at(-0.3), 1);
    const auto angles = stepped.wall_angles();
    ASSERT_EQ(angles.size(), 3u);
    EXPECT_NEAR(angles[0], 90 * unit::degree, 1e-15);
    EXPECT_EQ(angles[1], 0);
}

TEST(Profile, ALineOnTheAxisHasNoFrustum) {
    const Profile pointed{{{-1, 0}, {-0.5, 0}, {0.5, 1}}};
    const std::vector<Frustum> expected{{-0.5, 0, 0.5, 1}};
    EXPECT_EQ(pointed.frusta(), expected);
}

TEST(Profile, RefusesWhatIsNoBody) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Profile({}), InputError);
    EXPECT_THROW(Profile({{-1, 1}}), InputError);
    EXPECT_THROW(Profile({{1, 1}, {-1, 1}}), InputError);
    EXPECT_THROW(Profile({{-1, 1}, {1, -0.1}}), InputError);
    EXPECT_THROW(Profile({{-1, nan}, {1, 1}}), InputError);
    EXPECT_THROW(Profile({{-1, 1}, {-0.1, 1}}), InputError);
    EXPECT_THROW(Profile({{0.1, 1}, {1, 1}}), InputError);
    EXPECT_THROW(Profile({{-1, 0}, {0, 0}, {1, 1}}), InputError);
}

TEST(Tow, MovesAtConstantSpeedFromItsStart) {
    const Tow tow{2.0, 0.07};
    EXPECT_EQ(tow.x(0), 2.0);
    EXPECT_DOUBLE_EQ(tow.x(100), 9.0);
}

}  // namespace
}  // namespace floes
