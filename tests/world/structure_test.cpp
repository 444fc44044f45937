// The structure: its load, its shape, its motion.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "scene.hpp"

namespace floes::test {
namespace structure_test {

constexpr double speed = 0.07;
constexpr double time_step = 0.02;
const std::vector<ConvexSolid> drum{Frustum{-0.5, 0.6, 0.5, 0.6}};
const std::vector<ConvexSolid> cone{Frustum{-0.443, 0.171, 0.122, 0.736}};

// An upright drum runs into an element that is held against it by 5 N: in the mean over steps the load on the drum is
// the 5 N, for the element moves at the drum's steady speed.
TEST(WorldStructure, CarriesTheAppliedForce) {
    World world(weightless());
    const BodyId structure = world.add_structure(drum, {Vec3(2, 0, 0)});
    const BodyId body = world.add_element(element_at({2.75, 0, 0}));
    Vec3 sum = Vec3::Zero();
    const int count = 1000;
    for (int step = 0; step < 2 * count; ++step) {
        world.move_structure({{2 + speed * time_step * (step + 1), 0, 0}});
        world.apply(body, {Vec3(-5, 0, 0), Vec3::Zero()});
        world.step();
        if (step >= count) sum += world.contact_force(structure);
    }
    EXPECT_NEAR(sum.x() / count, -5, 1e-3);
    EXPECT_NEAR(sum.y() / count, 0, 1e-3);
    EXPECT_NEAR(sum.z() / count, 0, 1e-3);
    EXPECT_NEAR(world.state(body).velocity.x(), speed, 1e-3);
}

TEST(WorldStructure, MovesAsItIsTold) {
    World world(weightless());
    const BodyId structure = world.add_structure(drum, {Vec3(2, 0, 0)});
    for (int step = 0; step < 10; ++step) {
        world.move_structure({{2 + speed * time_step * (step + 1), 0, 0}});
        world.step();
        EXPECT_NEAR(world.state(structure).velocity.x(), speed, 1e-12);
    }
    EXPECT_DOUBLE_EQ(world.state(structure).position.x(), 2 + speed * time_step * 10);
    world.step();
    EXPECT_EQ(world.state(structure).velocity, Vec3(0, 0, 0)) << "not told, it stands";
}

// A drum that turns rubs an element that is pressed against it along: by 0.2 of the 5 N, the way its wall goes, until
// the element goes as fast as the wall.
TEST(WorldStructure, WallThatTurnsRubs) {
    for (const SolverKind solver : {SolverKind::stock, SolverKind::lanes}) {
        for (const double turning : {0.02, -0.02}) {
            World world(weightless(solver));
            const BodyId structure = world.add_structure(drum, {Vec3::Zero()});
            const BodyId body = world.add_element(element_at({0.7, 0, 0}));
            for (int step = 1; step <= 5; ++step) {
                world.move_structure({Vec3::Zero(), turned_about_y(turning * time_step * step)});
                world.apply(body, {Vec3(-5, 0, 0), Vec3::Zero()});
                world.step();
                EXPECT_NEAR(world.state(structure).angular_velocity.y(), turning, 1e-6);
            }
            // v = ω × r: a positive turn takes +x to -z.
            const double there = world.state(body).velocity.z() + 0.1 * world.state(body).angular_velocity.y();
            EXPECT_NEAR(there, -turning * 0.6, 0.05 * 0.02 * 0.6) << turning;
            EXPECT_NEAR(world.state(structure).rotation(0, 2), std::sin(0.1 * turning), 1e-9);
        }
    }
}

/// An element driven level into the 45° cone from the direction `azimuth`, with its corner or its edge ahead.
Vec3 force_on_cone(double azimuth, double turn, double structure_friction) {
    WorldDefinition definition = weightless();
    definition.contact.ice_structure_friction = structure_friction;
    World world(definition);
    const BodyId structure = world.add_structure(cone, {Vec3::Zero()});
    const Vec3 outward(std::cos(azimuth), 0, std::sin(azimuth));
    const double reach = turn == 0 ? element_side / 2 : element_side / std::sqrt(2.0);
    const BodyId body =
        world.add_element(element_at(outward * (0.614 + reach + 0.02), turned(turn - azimuth, Vec3::UnitY())));
    world.apply(body, {outward * (-element_mass * speed / time_step), Vec3::Zero()});
    Vec3 force = Vec3::Zero();
    for (int step = 0; step < 60 && force.norm() == 0; ++step) {
        world.step();
        force = world.contact_force(structure);
    }
    return force;
}

// Without friction the first contact pushes along the wall's normal, which has a closed form; the wall widens upwards,
// so the element is pressed out and down and the structure in and up.
TEST(WorldStructure, PushesAlongTheTrueNormalOfTheCone) {
    for (const double turn : {0.0, std::numbers::pi / 4}) {
        for (int i = 0; i < 24; ++i) {
            const double azimuth = 0.1 + i * std::numbers::pi / 12;
            const Vec3 force = force_on_cone(azimuth, turn, 0);
            ASSERT_GT(force.norm(), 0);
            const Vec3 expected = Vec3(-std::cos(azimuth), 1, -std::sin(azimuth)) / std::sqrt(2.0);
            EXPECT_NEAR((force.normalized() - expected).norm(), 0, 2e-3) << "azimuth " << azimuth << ", turn " << turn;
        }
    }
}

// A level element that is driven on slides down the wall: friction is the full 0.2 of the normal force, up along it.
TEST(WorldStructure, RubsWithItsCoefficient) {
    const Vec3 force = force_on_cone(0, 0, ContactLaw{}.ice_structure_friction);
    const Vec3 normal = Vec3(-1, 1, 0) / std::sqrt(2.0);
    const Vec3 tangent = force - force.dot(normal) * normal;
    EXPECT_NEAR(tangent.norm() / force.dot(normal), 0.2, 2e-3);
}

// An element at rest 0.2 mm off the wall feels nothing, 0.2 mm into it something; on a drum and, at the height of its
// upper edge, where the wall has come out by as much, on a 45° cone.
TEST(WorldStructure, HasItsWallWhereTheProfileSays) {
    const double half = element_thickness / 2;
    for (const bool is_cone : {false, true}) {
        for (const double gap : {2e-4, -2e-4}) {
            World world(weightless());
            const BodyId structure = world.add_structure(is_cone ? cone : drum, {Vec3::Zero()});
            // The element's edge is rounded by its margin, a tenth of its half thickness: a corner of 90° met from its
            // middle stands back by (sqrt(2) - 1) of that, sqrt(2) times as much along x.
            const double radius = is_cone ? 0.614 + half - 0.1 * half * (2 - std::sqrt(2.0)) : 0.6;
            world.add_element(element_at({radius + gap + element_side / 2, 0, 0}));
            world.step();
            EXPECT_EQ(world.contact_force(structure).norm() > 0, gap < 0) << (is_cone ? "cone " : "drum ") << gap;
        }
    }
}

// An hourglass of radius 0.3 at the waist and 0.6 at its ends; its convex hull would be a drum of radius 0.6.
class WaistTest : public testing::Test {
  protected:
    /// Load on the hourglass after ten steps with an element at rest at the height of the waist.
    double load(double gap) {
        World world(weightless());
        const std::vector<ConvexSolid> hourglass{Frustum{-0.4, 0.6, 0, 0.3}, Frustum{0, 0.3, 0.4, 0.6}};
        const BodyId structure = world.add_structure(hourglass, {Vec3::Zero()});
        world.add_element(element_at({0.3 + gap + element_side / 2, 0, 0}));
        double largest = 0;
        for (int step = 0; step < 10; ++step) {
            world.step();
            largest = std::max(largest, world.contact_force(structure).norm());
        }
        return largest;
    }
};

TEST_F(WaistTest, IsNotFilledIn) {
    // The wall leaves the axis at 45°·0.75: at the edge of the element it has come out by 12.4 mm.
    EXPECT_EQ(load(0.02), 0);
}

TEST_F(WaistTest, IsSolid) {
    EXPECT_GT(load(0.005), 0);
}

TEST(WorldStructure, RefusesWhatHasNoVolume) {
    World world(weightless());
    EXPECT_THROW(world.add_structure(std::vector<ConvexSolid>{}, {Vec3::Zero()}), InputError);
    EXPECT_THROW(world.add_structure(std::vector<ConvexSolid>{Frustum{0, 1, 0, 1}}, {Vec3::Zero()}), InputError);
    EXPECT_THROW(world.add_structure(std::vector<ConvexSolid>{Frustum{0, -1, 1, 1}}, {Vec3::Zero()}), InputError);
    world.add_structure(std::vector<ConvexSolid>{Frustum{0, 0, 1, 1}}, {Vec3::Zero()});
    EXPECT_THROW(world.add_structure(std::vector<ConvexSolid>{Frustum{0, 0, 1, 1}}, {Vec3::Zero()}), InputError);
}

}  // namespace structure_test
}  // namespace floes::test
