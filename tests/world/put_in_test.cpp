// Elements and joints that leave a world, and others that come under their ids.

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "world/scene.hpp"

namespace floes {
namespace put_in_test {

constexpr int steps = 40;

JointDefinition joint_of(BodyId a, BodyId b, double x) {
    return {.a = a, .b = b, .pivot = {x + 0.1, 0, 0}, .cfm = 0.016};
}

/// Two elements with a joint at x, of a piece, that fly towards the origin.
void throw_at_origin(World& world, BodyId a, BodyId b, double x) {
    const double speed = x < 0 ? 0.5 : -0.5;
    world.place(a, {.position = {x, 0, 0.03}, .velocity = {speed, 0, 0}});
    world.place(b, {.position = {x + 0.2, 0, 0.03}, .velocity = {speed, 0, 0}});
}

class PutIn : public ::testing::TestWithParam<SolverKind> {};

TEST_P(PutIn, GivesTheBitsOfAWorldThatHadNothingElse) {
    World fresh(test::weightless(GetParam()));
    World used(test::weightless(GetParam()));
    for (World* world : {&fresh, &used}) {
        const BodyId a = world->add_element(test::element_at({-0.5, 0, 0.03}, Quat::Identity(), 0));
        const BodyId b = world->add_element(test::element_at({-0.3, 0, 0.03}, Quat::Identity(), 0));
        world->add_joint(joint_of(a, b, -0.5));
    }
    const BodyId c(2), d(3);
    ElementDefinition first = test::element_at({-0.09, 0, 0.05}, Quat::Identity(), 2);
    first.mass *= 3;
    first.half_thickness *= 2;
    used.add_element(first);
    first.pose.position.x() += 0.2;
    used.add_element(first);
    const JointId joint = used.add_joint(joint_of(c, d, -0.09));
    throw_at_origin(used, BodyId(0), BodyId(1), -0.5);
    for (int i = 0; i < steps; ++i) used.step();
    EXPECT_FALSE(used.contact_force(c).isZero(0) && used.state(c).velocity.isZero(0)) << "it is to be struck";
    used.remove_joint(joint);
    used.take_out(c);
    used.take_out(d);
    used.step();

    const ElementDefinition second = test::element_at({0.3, 0, 0.03}, Quat::Identity(), 2);
    ElementDefinition third = second;
    third.pose.position.x() = 0.5;
    EXPECT_EQ(fresh.add_element(second), c);
    EXPECT_EQ(fresh.add_element(third), d);
    fresh.add_joint(joint_of(c, d, 0.3));
    used.put_in(c, second);
    used.put_in(d, third);
    used.put_in(joint, joint_of(c, d, 0.3));
    for (World* world : {&fresh, &used}) {
        throw_at_origin(*world, BodyId(0), BodyId(1), -0.5);
        throw_at_origin(*world, c, d, 0.3);
    }
    bool touched = false;
    for (int i = 0; i < steps; ++i) {
        for (World* world : {&fresh, &used}) world->step();
        touched = touched || !fresh.contact_force(c).isZero(0);
        for (const std::size_t body : {0U, 1U, 2U, 3U})
            ASSERT_TRUE(test::same_bits(fresh.state(BodyId(body)), used.state(BodyId(body)))) << i << ' ' << body;
        ASSERT_EQ(fresh.reaction(joint).axial, used.reaction(joint).axial) << i;
    }
    EXPECT_TRUE(touched) << "they are to collide";
}

/// A hexagon of ice, stretched along its x.
ElementDefinition hexagon_at(const Vec3& position, double stretched) {
    ElementDefinition prism{.corners = {}, .half_thickness = 0.05, .mass = 1, .pose = {position, Quat::Identity()}};
    for (const Corner& corner : {Corner{0.1, 0}, {0.05, 0.08}, {-0.05, 0.08}, {-0.1, 0}, {-0.05, -0.08}, {0.05, -0.08}})
        prism.corners.push_back({stretched * corner.x, corner.z});
    return prism;
}

TEST(PutInPrism, GivesTheBitsOfAWorldThatHadNothingElse) {
    World fresh(test::weightless(SolverKind::direct));
    World used(test::weightless(SolverKind::direct));
    const BodyId struck(0), striker(1);
    used.add_element(hexagon_at({0.02, 0, 0}, 1.6));
    used.add_element(hexagon_at({-0.5, 0, 0.03}, 1));
    used.place(striker, {.position = {-0.5, 0, 0.03}, .velocity = {0.5, 0, 0}});
    for (int i = 0; i < steps; ++i) used.step();
    EXPECT_FALSE(used.state(struck).velocity.isZero(0)) << "it is to be struck";
    for (const BodyId body : {struck, striker}) used.take_out(body);
    used.step();
    used.put_in(striker, hexagon_at({-0.4, 0, 0.05}, 1.2));  // in the hull of another
    used.put_in(struck, hexagon_at({0, 0, 0}, 1));
    fresh.add_element(hexagon_at({0, 0, 0}, 1));
    fresh.add_element(hexagon_at({-0.4, 0, 0.05}, 1.2));
    for (World* world : {&fresh, &used}) world->place(striker, {.position = {-0.4, 0, 0.05}, .velocity = {0.5, 0, 0}});
    bool touched = false;
    for (int i = 0; i < steps; ++i) {
        for (World* world : {&fresh, &used}) world->step();
        touched = touched || !fresh.contact_force(struck).isZero(0);
        for (const BodyId body : {struck, striker})
            ASSERT_TRUE(test::same_bits(fresh.state(body), used.state(body))) << i << ' ' << body.index();
    }
    EXPECT_TRUE(touched) << "they are to collide";
}

TEST_P(PutIn, WhatIsOutTouchesNothing) {
    World world(test::weightless(GetParam()));
    const BodyId striker = world.add_element(test::element_at({-0.4, 0, 0}));
    const BodyId struck = world.add_element(test::element_at({0, 0, 0}));
    world.take_out(struck);
    world.place(striker, {.position = {-0.4, 0, 0}, .velocity = {0.5, 0, 0}});
    for (int i = 0; i < 80; ++i) world.step();
    EXPECT_NEAR(world.state(striker).position.x(), -0.4 + 0.5 * 80 * 0.02, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(World, PutIn, ::testing::Values(SolverKind::lanes, SolverKind::direct));

TEST(TakeOut, TheStockSolverCannot) {
    World world(test::weightless(SolverKind::stock));
    const BodyId body = world.add_element(test::element_at({0, 0, 0}));
    EXPECT_THROW(world.take_out(body), InputError);
    EXPECT_THROW(world.put_in(body, test::element_at({0, 0, 0})), InputError);
}

}  // namespace put_in_test
}  // namespace floes
