// Coulomb friction: a slope holds an element up to its angle of friction, beyond it the element slides with g (sin α -
// f cos α).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "scene.hpp"
#include "world/engine.hpp"

namespace floes::test {
namespace friction_test {

/// Distance and speed down the slope after some steps from rest.
struct Slide {
    double distance;
    double speed;
};

// With gravity in place of water an element that is pushed out of a plane by a hair falls back by g Δt² = 4 mm. Left
// to overlap by 0.1 mm it never loses contact.
WorldDefinition lasting_contact(double coefficient) {
    return {.contact = {.erp = 0, .ice_ice_friction = coefficient}};
}

Slide slide(double coefficient, double angle, int steps) {
    World world(lasting_contact(coefficient));
    const Quat tilt = turned(-angle, Vec3::UnitZ());  // +x points down the slope
    world.add_fixed_box({Vec3(20, 0.5, 1), {tilt * Vec3(0, -0.5, 0), tilt}});
    const Vec3 start = tilt * Vec3(0, element_thickness / 2 - 1e-4, 0);
    const BodyId body = world.add_element(element_at(start, tilt));
    for (int step = 0; step < steps; ++step) world.step();
    const Vec3 down = tilt * Vec3::UnitX();
    return {(world.state(body).position - start).dot(down), world.state(body).velocity.dot(down)};
}

class FrictionTest : public testing::TestWithParam<double> {};

TEST_P(FrictionTest, HoldsBelowTheAngleOfFriction) {
    const double angle = std::atan(0.99 * GetParam());
    EXPECT_LT(std::abs(slide(GetParam(), angle, 250).distance), 1e-6);
}

// Up to 0.12 m/s: faster elements outrun their contact points, which last over 2.85 mm, and begin to rock.
TEST_P(FrictionTest, SlidesAboveTheAngleOfFriction) {
    for (const double excess : {1.01, 1.1, 1.5}) {
        const double angle = std::atan(excess * GetParam());
        const double acceleration = 9.81 * (std::sin(angle) - GetParam() * std::cos(angle));
        const double time_step = lasting_contact(GetParam()).time_step;
        const int steps = static_cast<int>(0.12 / acceleration / time_step);
        const double speed = acceleration * steps * time_step;
        EXPECT_NEAR(slide(GetParam(), angle, steps).speed, speed, 1e-6) << "slope " << angle;
    }
}

INSTANTIATE_TEST_SUITE_P(World, FrictionTest, testing::Values(ContactLaw{}.ice_ice_friction, 0.2));

// Pressed against an upright drum by 5 N an element holds 0.5 N along the wall, and 1 N when it is pulled by more.
TEST(WorldFriction, ActsOnTheStructureToo) {
    for (const double pull : {0.5, 3.0}) {
        World world(weightless());
        const BodyId structure =
            world.add_structure(std::vector<ConvexSolid>{Frustum{-9, 0.6, 9, 0.6}}, {Vec3::Zero()});
        const BodyId body = world.add_element(element_at({0.7, 0, 0}));
        Vec3 sum = Vec3::Zero();
        for (int step = 0; step < 100; ++step) {
            const Vec3 force(-5, pull, 0);
            world.apply(body, {force, Vec3(-element_side / 2, 0, 0).cross(Vec3(0, std::min(pull, 1.0), 0))});
            world.step();
            if (step >= 20) sum += world.contact_force(structure) / 80;
        }
        EXPECT_NEAR(sum.x(), -5, 0.01);
        EXPECT_NEAR(sum.y(), std::min(pull, 0.2 * 5), 0.01);
    }
}

ContactLaw friction_of(double ice_ice, double ice_structure) {
    return {.ice_ice_friction = ice_ice, .ice_structure_friction = ice_structure};
}

TEST(MaterialFrictionTest, GivesBothCoefficientsAsProducts) {
    for (const double ice_ice : {0.02, 0.3, 0.7}) {
        for (const double ice_structure : {0.0, 0.05, 0.2, 0.7}) {
            const MaterialFriction material = material_friction(friction_of(ice_ice, ice_structure));
            EXPECT_NEAR(material.ice * material.ice, ice_ice, 1e-15);
            EXPECT_NEAR(material.ice * material.structure, ice_structure, 1e-15);
        }
    }
    const MaterialFriction friction = material_friction({});
    EXPECT_DOUBLE_EQ(friction.ice * friction.ice, 0.3);
    EXPECT_DOUBLE_EQ(friction.ice * friction.structure, 0.2);
}

TEST(MaterialFrictionTest, OfTheIceIsNoneWithoutFriction) {
    EXPECT_EQ(material_friction(friction_of(0, 0)).ice, 0);
    EXPECT_EQ(material_friction(friction_of(0, 0)).structure, 0);
}

TEST(World, RefusesFrictionThatNoProductGives) {
    EXPECT_NO_THROW(World({.contact = friction_of(0, 0)}));
    EXPECT_THROW(World({.contact = friction_of(0, 0.2)}), InputError);
    EXPECT_THROW(World({.contact = friction_of(-0.1, 0.2)}), InputError);
    EXPECT_THROW(World({.contact = friction_of(0.3, 11)}), InputError);
}

}  // namespace friction_test
}  // namespace floes::test
