// What every solver does, Bullet's own world and ours: one suite of scenes with answers in closed form.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene.hpp"

namespace floes::test {
namespace engines_test {

class EveryEngine : public testing::TestWithParam<SolverKind> {
  protected:
    static WorldDefinition definition() { return weightless(GetParam()); }
};

std::string name_of(const testing::TestParamInfo<SolverKind>& solver) {
    if (solver.param == SolverKind::stock) return "stock";
    return solver.param == SolverKind::lanes ? "lanes" : "direct";
}

INSTANTIATE_TEST_SUITE_P(Solvers, EveryEngine,
                         testing::Values(SolverKind::stock, SolverKind::lanes, SolverKind::direct), name_of);

TEST_P(EveryEngine, LetsABodyFall) {
    WorldDefinition definition = EveryEngine::definition();
    definition.gravity = 9.81;
    World world(definition);
    const BodyId body = world.add_element(hexagon_at({0, 5, 0}));
    for (int step = 0; step < 50; ++step) world.step();
    EXPECT_NEAR(world.state(body).velocity.y(), -9.81, 1e-9);
    EXPECT_NEAR(world.state(body).position.y(), 5 - 0.5 * 9.81 * (1 + 0.02), 1e-9) << "velocities first";
}

TEST_P(EveryEngine, KeepsMomentumOfPrismsAndBoxes) {
    for (const bool box : {false, true}) {
        World world(definition());
        const BodyId a = world.add_element(hexagon_at({0, 0, 0}));
        const BodyId b = world.add_element(box ? element_at({0.3, 0, 0.02}) : hexagon_at({0.3, 0, 0.02}, 0.2));
        const double mass_b = box ? element_mass : 1.2;
        world.apply(a, {Vec3(1.2 * 0.2 / 0.02, 0, 0), Vec3::Zero()});
        double largest = 0;
        for (int step = 0; step < 150; ++step) {
            world.step();
            largest = std::max(largest, world.contact_force(b).x());
        }
        EXPECT_GT(largest, 1);
        EXPECT_NEAR((1.2 * world.state(a).velocity + mass_b * world.state(b).velocity - Vec3(0.24, 0, 0)).norm(), 0,
                    1e-9);
        EXPECT_GT(world.state(b).velocity.x(), 0.05);
    }
}

/// Two elements that a joint holds, pulled apart: it bears half of the difference, whoever solves it.
TEST_P(EveryEngine, BearsForcesInJoints) {
    World world(definition());
    const BodyId a = world.add_element(element_at({-0.1, 0, 0}, Quat::Identity(), 0));
    const BodyId b = world.add_element(element_at({0.1, 0, 0}, Quat::Identity(), 0));
    const JointId joint = world.add_joint({.a = a, .b = b, .cfm = 1e-6});
    for (int step = 0; step < 400; ++step) {
        world.apply(a, {Vec3(-3, 0, 0), Vec3::Zero()});
        world.apply(b, {Vec3(3, 0, 0), Vec3::Zero()});
        world.step();
    }
    EXPECT_NEAR(world.reaction(joint).axial, 3, 0.01);
    world.remove_joint(joint);
    world.step();
    EXPECT_EQ(world.reaction(joint).axial, 0);
}

const std::vector<ConvexSolid> drum{Frustum{-0.5, 0.3, 0.5, 0.3}};

TEST_P(EveryEngine, PushesWithTheStructure) {
    for (const bool box : {false, true}) {
        World world(definition());
        world.add_structure(drum, {});
        const BodyId body = world.add_element(box ? element_at({0.45, 0, 0}) : hexagon_at({0.45, 0, 0}));
        for (int step = 1; step <= 200; ++step) {
            world.move_structure({{0.1 * 0.02 * step, 0, 0}});
            world.step();
        }
        EXPECT_NEAR(world.state(body).velocity.x(), 0.1, 0.02);
    }
}

/// In any of six degrees of freedom: what lies on the structure's flat top goes with it, and a structure that pitches
/// lifts what is far from its reference point.
TEST_P(EveryEngine, CarriesWhatLiesOnAStructureThatHeavesAndPitches) {
    for (const double pitching : {0.0, 0.05}) {
        WorldDefinition definition = EveryEngine::definition();
        definition.gravity = 9.81;
        definition.time_step = 0.005;
        definition.contact.ice_structure_friction = 0.5;
        World world(definition);
        const ConvexSolid table(convex_hull(std::vector<Vec3>{
            {2, 0, 1}, {2, 0, -1}, {-2, 0, 1}, {-2, 0, -1}, {2, -1, 1}, {2, -1, -1}, {-2, -1, 1}, {-2, -1, -1}}));
        const BodyId structure = world.add_structure(std::vector<ConvexSolid>{table}, {});
        const BodyId body = world.add_element(element_at({1, 0.5 * element_thickness, 0}));
        const double heaving = pitching > 0 ? 0 : 0.05;
        double borne = 0;
        for (int step = 1; step <= 200; ++step) {
            const double time = step * definition.time_step;
            world.move_structure({{0, heaving * time, 0}, turned(pitching * time, Vec3::UnitZ())});
            world.step();
            if (step > 100) borne -= world.contact_force(structure).y() / 100;
        }
        EXPECT_NEAR(world.state(body).velocity.y(), 0.05, 0.005);
        EXPECT_NEAR(borne / (9.81 * element_mass), 1, 0.05);
    }
}

}  // namespace engines_test
}  // namespace floes::test
