// Restitution 0, momentum, and which bodies collide at all.

#include <gtest/gtest.h>

#include "scene.hpp"

namespace floes::test {
namespace collision_test {

/// Two elements in line, the first pushed for one second so that it runs at `speed` before it meets the second, of
/// twice its mass.
struct Crash {
    Vec3 momentum_before;
    Vec3 momentum_after;
    Vec3 velocity_a;
    Vec3 velocity_b;
};

Crash crash(const WorldDefinition& definition, double speed) {
    World world(definition);
    ElementDefinition heavy = element_at({0.5, 0, 0});
    heavy.mass = 2 * element_mass;
    const BodyId a = world.add_element(element_at({0, 0, 0}));
    const BodyId b = world.add_element(heavy);
    world.apply(a, {Vec3(element_mass * speed / definition.time_step, 0, 0), Vec3::Zero()});
    world.step();
    const auto momentum = [&] {
        return Vec3(element_mass * world.state(a).velocity + 2 * element_mass * world.state(b).velocity);
    };
    const Vec3 before = momentum();
    for (int step = 0; step < 500; ++step) world.step();
    return {before, momentum(), world.state(a).velocity, world.state(b).velocity};
}

TEST(WorldCollision, KeepsMomentum) {
    const Crash result = crash(weightless(), 0.07);
    ASSERT_NEAR(result.momentum_before.x(), element_mass * 0.07, 1e-12);
    EXPECT_NEAR((result.momentum_after - result.momentum_before).norm(), 0, 1e-12);
    EXPECT_GT(result.velocity_b.x(), 0.02);
}

// With every penetration corrected outside the impulse the two go on together: restitution 0.
TEST(WorldCollision, DoesNotReboundWithSplitImpulse) {
    WorldDefinition definition = weightless();
    definition.contact.split_impulse = true;
    definition.contact.split_impulse_depth = 0;
    const Crash result = crash(definition, 0.07);
    EXPECT_NEAR(result.velocity_a.x(), 0.07 / 3, 1e-6);
    EXPECT_NEAR(result.velocity_b.x(), 0.07 / 3, 1e-6);
}

// Else the share Γ of the first penetration (at most speed * Δt) is thrown back as speed.
TEST(WorldCollision, ReboundsByNoMoreThanItsErp) {
    const Crash result = crash(weightless(), 0.07);
    const double rebound = result.velocity_b.x() - result.velocity_a.x();
    EXPECT_GE(rebound, 0);
    EXPECT_LE(rebound, weightless().contact.erp * 0.07);
}

TEST(WorldCollision, ActsOnBothBodiesAsNewtonSays) {
    World world(weightless());
    const BodyId a = world.add_element(element_at({0, 0, 0}));
    const BodyId b = world.add_element(element_at({0.201, 0.004, 0.05}, turned(0.1, Vec3::UnitY())));
    EXPECT_EQ(world.contact_force(a), Vec3(0, 0, 0));
    bool touched = false;
    for (int step = 0; step < 100; ++step) {
        const Vec3 push(2, 0.3, 0);
        const Vec3 before = world.state(a).velocity;
        world.apply(a, {push, Vec3::Zero()});
        world.step();
        const Vec3 rate = (world.state(a).velocity - before) / 0.02;
        EXPECT_NEAR((push + world.contact_force(a) - element_mass * rate).norm(), 0, 1e-9);
        EXPECT_EQ(world.contact_force(a), -world.contact_force(b));
        touched = touched || world.contact_force(a).norm() > 0;
    }
    EXPECT_TRUE(touched);
}

TEST(WorldContacts, AreThoseOfOneBodyOnRequest) {
    World world(weightless());
    const BodyId left = world.add_element(element_at({0, 0, 0}));
    const BodyId middle = world.add_element(element_at({0.199, 0, 0}));
    const BodyId right = world.add_element(element_at({0.398, 0, 0}));
    world.step();
    std::vector<ContactForce> all;
    std::vector<ContactForce> of_left;
    std::vector<ContactForce> of_middle;
    world.read_contacts(all);
    world.read_contacts(of_left, left);
    world.read_contacts(of_middle, middle);
    EXPECT_EQ(of_middle.size(), all.size());
    ASSERT_GT(of_left.size(), 0u);
    EXPECT_LT(of_left.size(), all.size());
    Vec3 force = Vec3::Zero();
    for (const ContactForce& one : of_left) {
        EXPECT_TRUE(one.a == left || one.b == left);
        EXPECT_FALSE(one.a == right || one.b == right);
        force += (one.a == left ? 1 : -1) * (one.normal + one.friction);
    }
    EXPECT_NEAR((force - world.contact_force(left)).norm(), 0, 1e-9);
}

TEST(WorldPiece, ElementsOfOnePieceDoNotTouchUntilItSplits) {
    World world(weightless());
    const BodyId a = world.add_element(element_at({0, 0, 0}, Quat::Identity(), 4));
    const BodyId b = world.add_element(element_at({0.19, 0, 0.19}, Quat::Identity(), 4));
    for (int step = 0; step < 10; ++step) world.step();
    EXPECT_EQ(world.contact_force(a), Vec3(0, 0, 0));
    EXPECT_EQ(world.state(a).velocity, Vec3(0, 0, 0));
    world.set_piece(b, 5);
    world.step();
    EXPECT_GT(world.contact_force(a).norm(), 0) << "the parts touch in the very next step";
    world.set_piece(b, 4);
    world.step();
    EXPECT_EQ(world.contact_force(a), Vec3(0, 0, 0)) << "an old contact does not act within a piece";
}

TEST(WorldPiece, BodiesOfNoPieceTouchEachOther) {
    World world(weightless());
    const BodyId a = world.add_element(element_at({0, 0, 0}));
    world.add_element(element_at({0.19, 0, 0}));
    world.step();
    EXPECT_GT(world.contact_force(a).norm(), 0);
}

}  // namespace collision_test
}  // namespace floes::test
