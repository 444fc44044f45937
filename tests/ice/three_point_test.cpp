// A strip on two supports that a stamp presses down: the stress of its moment and of the contacts, from the world's own
// contacts to the crack.

#include <gtest/gtest.h>

#include "ice_scene.hpp"

namespace floes::test {
namespace {

constexpr double side = 0.2;
constexpr double thick = 0.033;
constexpr double stamp = 0.05;

Scenario strip() {
    Scenario scenario;
    scenario.water.added_mass_from = WaterFrom::share;
    scenario.floe = {.length = 3 * side, .breadth = side, .element = side};
    scenario.joint.damping_ratio = 1;
    return scenario;
}

/// N at which the strip cracks in the middle, pressed in small steps.
double cracking_load(const Scenario& scenario) {
    WorldDefinition definition{.iterations = 50, .gravity = 0, .solver = SolverKind::direct};
    definition.contact = scenario.contact_law();
    World world(definition);
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
    const double middle = world.state(ice.elements()[1].body).position.y();
    for (const double x : {-side, side}) {
        world.add_fixed_box(
            {.half_extents = {stamp / 2, thick / 2, side / 2}, .pose = {{x, middle - thick, 0}, Quat::Identity()}});
    }
    const BodyId pressing = world.add_element({.half_extents = {stamp / 2, thick / 2, stamp / 2},
                                               .mass = 0.1,
                                               .pose = {{0, middle + thick, 0}, Quat::Identity()},
                                               .piece = 1000,
                                               .crushing_pressure = definition.contact.crushing_pressure});
    const double per_step = 0.01;
    for (int step = 1; step < 5000; ++step) {
        world.apply(pressing, {Vec3(0, -per_step * step, 0), Vec3::Zero()});
        world.step();
        if (ice.break_joints(world, 0.02 * step) > 0) return per_step * step;
    }
    return 0;
}

TEST(ThreePoints, CrackWhereMomentAndContactsReachTheStrength) {
    Scenario scenario = strip();
    const double by_moment = scenario.ice.bending_strength * side * thick * thick / 6;
    scenario.joint.failure = JointFailure::moment;
    // The strip sags, so it lies on the supports' inner edges: 0.075 m from the joints, less the couple of the friction
    // that holds it there.
    const double alone = cracking_load(scenario);
    const double arm = 2 * by_moment / alone;
    EXPECT_NEAR(arm, side / 2 - stamp / 2, 0.1 * arm);

    scenario.joint.failure = JointFailure::stress;
    // A quarter of the load at each corner of the stamp; no joint along z, so nothing bends across.
    const PressedElement element{side, thick, 0.3, scenario.contact_law().crushing_pressure,
                                 edge_plus_x | edge_minus_x};
    double expected = 20;
    for (int i = 0; i < 30; ++i) {
        const double local = contact_stress(element, {stamp / 2, stamp / 2, expected / 4})[0].stress / expected;
        const double bending = arm / 2 * 6 / (side * thick * thick);
        expected = scenario.ice.bending_strength / (bending + local);
    }
    EXPECT_LT(expected, 0.8 * alone);
    EXPECT_NEAR(cracking_load(scenario), expected, 0.05 * expected);
}

}  // namespace
}  // namespace floes::test
