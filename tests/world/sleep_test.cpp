#include <gtest/gtest.h>

#include <vector>

#include "core/error.hpp"
#include "world/scene.hpp"

namespace floes {
namespace sleep_test {

void join(World& world, BodyId a, BodyId b, const Vec3& pivot) {
    world.add_joint({.a = a, .b = b, .pivot = pivot, .cfm = 0.016});
}

TEST(Sleep, NeitherWeightNorForceNorJointsMoveASleeper) {
    World world(test::solved_by(SolverKind::lanes));
    const BodyId a = world.add_element(test::element_at({0, 0, 0}, test::turned(0.3, {1, 2, 3}), 0));
    const BodyId b = world.add_element(test::element_at({0.2, 0.001, 0}, test::turned(0.2, {1, 2, 3}), 0));
    join(world, a, b, {0.1, 0, 0});
    for (const BodyId body : {a, b}) world.set_asleep(body, true);
    const BodyState before[] = {world.state(a), world.state(b)};
    for (int i = 0; i < 20; ++i) {
        world.apply(a, {{1, 2, 3}, {1, 2, 3}});
        world.step();
    }
    EXPECT_TRUE(test::same_bits(world.state(a), before[0]));
    EXPECT_TRUE(test::same_bits(world.state(b), before[1]));
    EXPECT_EQ(world.reaction(JointId(0)).axial, 0);
    EXPECT_TRUE(world.touched_asleep().empty());
}

TEST(Sleep, AWokenBodyMovesAsIfItHadNotSlept) {
    World slept(test::solved_by(SolverKind::lanes));
    World waked(test::solved_by(SolverKind::lanes));
    for (World* world : {&slept, &waked}) {
        for (const double x : {0.0, 0.2, 5.0}) world->add_element(test::element_at({x, 0, 0}, Quat::Identity(), 0));
        join(*world, BodyId(0), BodyId(1), {0.1, 0, 0});
    }
    slept.set_asleep(BodyId(0), true);
    slept.set_asleep(BodyId(1), true);
    for (int i = 0; i < 5; ++i) slept.step();
    slept.set_asleep(BodyId(0), false);
    slept.set_asleep(BodyId(1), false);
    for (int i = 0; i < 5; ++i) {
        for (World* world : {&slept, &waked}) {
            world->apply(BodyId(0), {{0, 0, 0}, {0, 0, 0.1}});
            world->step();
        }
        EXPECT_TRUE(test::same_bits(slept.state(BodyId(1)), waked.state(BodyId(1)))) << i;
        EXPECT_EQ(slept.reaction(JointId(0)).bending, waked.reaction(JointId(0)).bending) << i;
        EXPECT_NE(slept.reaction(JointId(0)).bending, 0) << i;
    }
}

TEST(Sleep, WhoWakesDoesNotDisturbTheJointsOfOthers) {
    World quiet(test::weightless(SolverKind::direct));
    World waking(test::weightless(SolverKind::direct));
    for (World* world : {&quiet, &waking}) {
        for (const double x : {0.0, 0.2, 5.0})
            world->add_element(test::element_at({x, 0, 0}, Quat::Identity(), x > 1 ? 2 : 0));
        world->add_joint({.a = BodyId(0),
                          .b = BodyId(1),
                          .pivot = {0.1, 0, 0},
                          .spring = JointSpring{{2e5, 2e3, 1e5}, {20, 20, 20}, 0.05}});
        world->set_asleep(BodyId(2), true);
    }
    for (int i = 0; i < 40; ++i) {
        if (i >= 20) waking.set_asleep(BodyId(2), i % 2 == 0);
        for (World* world : {&quiet, &waking}) {
            world->apply(BodyId(0), {{-10, 5, 3}, {0.1, 0.2, -0.3}});
            world->apply(BodyId(1), {{10, -5, -3}, {-0.1, -0.2, 0.3}});
            world->step();
        }
        for (const BodyId body : {BodyId(0), BodyId(1)})
            EXPECT_TRUE(test::same_bits(quiet.state(body), waking.state(body))) << i;
        EXPECT_EQ(quiet.reaction(JointId(0)).bending, waking.reaction(JointId(0)).bending) << i;
    }
}

TEST(Sleep, AMovingElementLandsOnASleeperAndIsReported) {
    World world(test::solved_by(SolverKind::lanes));
    const BodyId below = world.add_element(test::element_at({0, 0, 0}));
    const BodyId aside = world.add_element(test::element_at({0.201, 0, 0}));  // at rest beside it, nearly touching
    const BodyId above = world.add_element(test::element_at({0, 0.05, 0}));
    world.set_asleep(below, true);
    world.set_asleep(aside, true);
    const BodyState before = world.state(below);
    std::vector<BodyId> touched;
    for (int i = 0; i < 50; ++i) {
        world.step();
        if (touched.empty()) touched = world.touched_asleep();
    }
    EXPECT_TRUE(test::same_bits(world.state(below), before));
    EXPECT_NEAR(world.state(above).position.y(), test::element_thickness, 1e-3);
    EXPECT_NEAR(world.contact_force(below).y(), -test::element_mass * 9.81, 1e-3);
    ASSERT_EQ(touched.size(), 1u);
    EXPECT_EQ(touched.front(), below);
}

TEST(Sleep, IsNotForTheStockSolver) {
    World world{WorldDefinition{}};
    const BodyId body = world.add_element(test::element_at({0, 0, 0}));
    EXPECT_THROW(world.set_asleep(body, true), InputError);
}

}  // namespace sleep_test
}  // namespace floes
