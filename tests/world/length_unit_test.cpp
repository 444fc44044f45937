// Whatever unit a World computes in, it is spoken to and answers in SI.

#include <gtest/gtest.h>

#include <vector>

#include "core/error.hpp"
#include "world/scene.hpp"

namespace floes {
namespace length_unit_test {

using test::element_at;
using test::element_mass;
using test::element_side;

class LengthUnit : public testing::TestWithParam<SolverKind> {
  protected:
    static WorldDefinition definition(double unit) { return {.solver = GetParam(), .length_unit = unit}; }
};

/// The last of three joined elements that a fixed box holds at one end, after some steps under forces and a moment.
struct Swing {
    BodyState state;
    JointReaction reaction;  // of the last joint
    Vec3 force() const { return {reaction.axial, reaction.shear_vertical, reaction.shear_in_plane}; }
    Vec3 moment() const { return {reaction.torsion, reaction.in_plane_bending, reaction.bending}; }
};

Swing swing(const WorldDefinition& definition) {
    World world(definition);
    BodyId last = world.add_fixed_box({.half_extents = {0.1, 0.0165, 0.1}, .pose = {.position = {-2, 0, 0}}});
    JointId joint(0);
    for (int i = 0; i < 3; ++i) {
        const BodyId next = world.add_element(element_at({element_side * (i + 0.5), 0, 0}, Quat::Identity(), 0));
        joint = world.add_joint({.a = last, .b = next, .pivot = {element_side * i, 0, 0}, .cfm = 0.016});
        last = next;
    }
    world.place(
        last,
        {.position = {element_side * 2.5, 0.01, 0}, .velocity = {0, 0.1, 0.2}, .angular_velocity = {0.3, 0, 0.1}});
    for (int step = 0; step < 20; ++step) {
        world.apply(last, {.force = {3, 0, -2}, .moment = {0.1, 0.2, 0.3}});
        world.step();
    }
    return {world.state(last), world.reaction(joint)};
}

// From a unit of 22 m on Bullet leaves out the gyroscopic moment of elements as light as these, with the stock solver.
TEST_P(LengthUnit, DoesNotShowInMotionAndReactions) {
    constexpr double tolerance = 1e-8;
    const Swing expected = swing(definition(1));
    for (const double unit : {0.03, 2.0, 20.0}) {
        const Swing found = swing(definition(unit));
        const auto error = [](const Vec3& one, const Vec3& other) { return (one - other).norm() / one.norm(); };
        EXPECT_LT(error(found.state.position, expected.state.position), tolerance) << unit;
        EXPECT_LT(error(found.state.velocity, expected.state.velocity), tolerance) << unit;
        EXPECT_LT(error(found.state.angular_velocity, expected.state.angular_velocity), tolerance) << unit;
        EXPECT_LT((found.state.rotation - expected.state.rotation).norm(), tolerance) << unit;
        EXPECT_LT(error(found.force(), expected.force()), tolerance) << unit;
        EXPECT_LT(error(found.moment(), expected.moment()), tolerance) << unit;
    }
}

TEST_P(LengthUnit, AContactCarriesTheWeight) {
    for (const double unit : {0.25, 1.0, 30.0}) {
        World world(definition(unit));
        const BodyId floor = world.add_fixed_box({.half_extents = {1, 0.5, 1}, .pose = {.position = {0, -0.5165, 0}}});
        world.add_element(element_at({0, 0, 0}));
        for (int step = 0; step < 50; ++step) world.step();
        EXPECT_NEAR(world.contact_force(floor).y(), -element_mass * 9.81, 1e-6) << unit;
    }
}

// With another unit the margins are others, and so is the overlap that is pushed out at the first touch.
TEST_P(LengthUnit, TheStructurePushesAtItsSpeed) {
    for (const double unit : {0.25, 1.0, 30.0}) {
        World world(definition(unit));
        const std::vector<ConvexSolid> solids{Frustum{-0.5, 0.5, 0.5, 0.5}};
        world.add_structure(solids, {{0, 0, 0}});
        const BodyId pushed = world.add_element(element_at({0.62, 0, 0}));
        for (int step = 1; step <= 50; ++step) {
            world.apply(pushed, {.force = {0, element_mass * 9.81, 0}});
            world.move_structure({{0.07 * 0.02 * step, 0, 0}});
            world.step();
        }
        EXPECT_NEAR(world.state(pushed).velocity.x(), 0.07, 0.015) << unit;
    }
}

TEST(LengthUnitOfAWorld, IsRefusedUnlessAboveZero) {
    EXPECT_THROW(World({.length_unit = 0}), InputError);
    EXPECT_THROW(World({.length_unit = -1}), InputError);
}

INSTANTIATE_TEST_SUITE_P(Solvers, LengthUnit, testing::Values(SolverKind::stock, SolverKind::lanes),
                         [](const auto& given) { return given.param == SolverKind::stock ? "stock" : "lanes"; });

}  // namespace length_unit_test
}  // namespace floes
