// Two elements, one joint: the reaction is the load that the pair is given, whatever the yaw of the pair.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "scene.hpp"

namespace floes::test {
namespace joint_reaction_test {

struct Load {
    const char* name;
    Vec3 force;   // of the joint on a, in the joint's frame
    Vec3 moment;  // about the pivot
};

class JointReactionTest : public testing::TestWithParam<Load> {};

// With a reaction (f, m) on a at the pivot, a is at rest under (-f, -m) and b under (f, m) applied at the pivot.
TEST_P(JointReactionTest, EqualsTheAppliedLoad) {
    for (const double cfm : {1e-10, 0.016}) {
        World world(weightless());
        const Quat yaw = turned(0.5, Vec3::UnitY());
        const Vec3 along = yaw * Vec3::UnitX();
        const Vec3 origin(7, 0.4, -1);
        const BodyId a = world.add_element(element_at(origin - along * element_side / 2, yaw, 0));
        const BodyId b = world.add_element(element_at(origin + along * element_side / 2, yaw, 0));
        const JointId joint = world.add_joint({a, b, origin, yaw, cfm, 0.8});
        for (int step = 0; step < 400; ++step) {
            const BodyState state_a = world.state(a);
            const BodyState state_b = world.state(b);
            const Vec3 force = state_a.rotation * GetParam().force;
            const Vec3 moment = state_a.rotation * GetParam().moment;
            const Vec3 arm(element_side / 2, 0, 0);  // each element's own end of the joint: under load they part
            world.apply(a, {-force, -moment - (state_a.rotation * arm).cross(force)});
            world.apply(b, {force, moment - (state_b.rotation * arm).cross(force)});
            world.step();
        }
        const JointReaction reaction = world.reaction(joint);
        EXPECT_NEAR(reaction.axial, GetParam().force.x(), 1e-3);
        EXPECT_NEAR(reaction.shear_vertical, GetParam().force.y(), 1e-3);
        EXPECT_NEAR(reaction.shear_in_plane, GetParam().force.z(), 1e-3);
        EXPECT_NEAR(reaction.torsion, GetParam().moment.x(), 1e-4);
        EXPECT_NEAR(reaction.in_plane_bending, GetParam().moment.y(), 1e-4);
        EXPECT_NEAR(reaction.bending, GetParam().moment.z(), 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(
    World, JointReactionTest,
    testing::Values(Load{"compression", {-10, 0, 0}, {0, 0, 0}}, Load{"tension", {10, 0, 0}, {0, 0, 0}},
                    Load{"shear_up", {0, 10, 0}, {0, 0, 0}}, Load{"shear_down", {0, -10, 0}, {0, 0, 0}},
                    Load{"shear_in_plane", {0, 0, 10}, {0, 0, 0}}, Load{"sagging", {0, 0, 0}, {0, 0, 0.5}},
                    Load{"hogging", {0, 0, 0}, {0, 0, -0.5}}, Load{"in_plane_bending", {0, 0, 0}, {0, 0.5, 0}},
                    Load{"torsion", {0, 0, 0}, {0.5, 0, 0}}, Load{"all_at_once", {-8, 5, 3}, {0.2, 0.3, -0.4}}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(WorldJoint, SaggingMeansEndsPushedUp) {
    World world(weightless());
    const BodyId a = world.add_element(element_at({-0.1, 0, 0}, Quat::Identity(), 0));
    const BodyId b = world.add_element(element_at({0.1, 0, 0}, Quat::Identity(), 0));
    const JointId joint = world.add_joint({a, b, Vec3::Zero(), Quat::Identity(), 0.016, 0.8});
    for (int step = 0; step < 100; ++step) {
        // 1 N up at both outer ends, 1 N down on either side of the joint: 0.2 N m at mid-span.
        world.apply(a, {Vec3::Zero(), Vec3(0, 0, -0.2)});
        world.apply(b, {Vec3::Zero(), Vec3(0, 0, 0.2)});
        world.step();
    }
    EXPECT_NEAR(world.reaction(joint).bending, 0.2, 1e-6);
    EXPECT_GT(world.state(b).rotation(1, 0), 0) << "the far end of b is up";
    EXPECT_LT(world.state(a).rotation(1, 0), 0) << "the far end of a is up";
}

// K = Γ / (Δt² Σ A) with A = 2/m for the axial row and 2/I for the bending row.
TEST(WorldJoint, IsTheSpringThatItsCfmStates) {
    const double cfm = 0.016;
    const double erp = 0.8;
    const WorldDefinition definition = weightless();
    const auto deform = [&](const Vec3& force, const Vec3& moment) {
        World world(definition);
        const BodyId a = world.add_element(element_at({-0.1, 0, 0}, Quat::Identity(), 0));
        const BodyId b = world.add_element(element_at({0.1, 0, 0}, Quat::Identity(), 0));
        world.add_joint({a, b, Vec3::Zero(), Quat::Identity(), cfm, erp});
        for (int step = 0; step < 400; ++step) {
            world.apply(a, {-force, -moment});
            world.apply(b, {force, moment});
            world.step();
        }
        return std::pair{world.state(a), world.state(b)};
    };
    const double scale = erp / (2 * definition.time_step * definition.time_step * cfm);
    const auto [left, right] = deform({10, 0, 0}, Vec3::Zero());
    const double opening = right.position.x() - left.position.x() - element_side;
    EXPECT_NEAR(opening, 10 / (scale * element_mass), 1e-9);
    const double inertia = element_mass * (element_side * element_side + element_thickness * element_thickness) / 12;
    const auto [down, up] = deform(Vec3::Zero(), {0, 0, 0.1});
    const double angle = std::asin((down.rotation.transpose() * up.rotation)(1, 0));
    EXPECT_NEAR(angle, 0.1 / (scale * inertia), 1e-9);
}

TEST(WorldJoint, IsGoneOnceRemoved) {
    World world(weightless());
    const BodyId a = world.add_element(element_at({-0.1, 0, 0}, Quat::Identity(), 0));
    const BodyId b = world.add_element(element_at({0.1, 0, 0}, Quat::Identity(), 0));
    const JointId joint = world.add_joint({a, b, Vec3::Zero(), Quat::Identity(), 0.016, 0.8});
    const auto pull = [&] {
        world.apply(a, {Vec3(-1, 0, 0), Vec3::Zero()});
        world.apply(b, {Vec3(1, 0, 0), Vec3::Zero()});
        world.step();
    };
    for (int step = 0; step < 50; ++step) pull();
    ASSERT_NEAR(world.reaction(joint).axial, 1, 1e-6);
    const double speed = world.state(b).velocity.x();
    world.remove_joint(joint);
    world.remove_joint(joint);
    EXPECT_EQ(world.reaction(joint).axial, 0);
    for (int step = 0; step < 10; ++step) pull();
    EXPECT_NEAR(world.state(b).velocity.x() - speed, 10 * 0.02 / element_mass, 1e-9);
}

// A row of five elements with joints 0 to 3. Had the removal of joint 1 moved joint 3 into its place, the sweeps would
// run in another order and give other bits.
TEST(WorldJoint, RemovalKeepsTheOrderOfTheOthers) {
    const auto run = [](bool build_and_remove) {
        World world(weightless());
        std::vector<BodyId> bodies;
        for (int i = 0; i < 5; ++i)
            bodies.push_back(world.add_element(element_at({0.2 * i, 0, 0}, Quat::Identity(), 0)));
        std::vector<JointId> joints;
        for (int i = 0; i < 4; ++i) {
            if (i == 1 && !build_and_remove) continue;
            joints.push_back(
                world.add_joint({bodies[i], bodies[i + 1], {0.2 * i + 0.1, 0, 0}, Quat::Identity(), 1e-10, 0.8}));
        }
        if (build_and_remove) world.remove_joint(joints[1]);
        for (int step = 0; step < 20; ++step) {
            world.apply(bodies[2], {Vec3(0.3, 2, 0.1), Vec3(0.1, 0.2, 0.3)});
            world.step();
        }
        std::vector<BodyState> states;
        for (const BodyId body : bodies) states.push_back(world.state(body));
        return states;
    };
    const auto removed = run(true);
    const auto never = run(false);
    for (std::size_t i = 0; i < removed.size(); ++i) EXPECT_TRUE(same_bits(removed[i], never[i])) << "element " << i;
}

TEST(WorldJoint, RefusesWhatItCannotSolve) {
    World world(weightless());
    const BodyId a = world.add_element(element_at({-0.1, 0, 0}));
    const BodyId b = world.add_element(element_at({0.1, 0, 0}));
    EXPECT_THROW(world.add_joint({a, b, Vec3::Zero(), Quat::Identity(), 1.0, 0.8}), InputError);
    EXPECT_THROW(world.add_joint({a, b, Vec3::Zero(), Quat::Identity(), 0.1, 1.1}), InputError);
    EXPECT_THROW(world.add_joint({a, a, Vec3::Zero(), Quat::Identity(), 0.1, 0.8}), InputError);
    EXPECT_THROW(world.add_joint({a, BodyId(7), Vec3::Zero(), Quat::Identity(), 0.1, 0.8}), InputError);
}

}  // namespace joint_reaction_test
}  // namespace floes::test
