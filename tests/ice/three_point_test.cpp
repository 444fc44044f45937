// A strip on two supports that one stamp or two press down: the stress of its moment and of the contacts, from the
// world's own contacts to the crack.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ice_scene.hpp"

namespace floes::test {
namespace three_point_test {

constexpr double side = 0.2;
constexpr double thick = 0.033;
constexpr double stamp = 0.05;

/// Where the strip rests and where it is pressed: m from its middle.
struct Set {
    int elements;
    double support;              ///< on either side
    std::vector<double> stamps;  ///< they share the load
};

Scenario strip(const Set& set) {
    Scenario scenario;
    scenario.water.added_mass_from = WaterFrom::share;
    scenario.floe = {.length = set.elements * side, .breadth = side, .element = side};
    scenario.joint.damping_ratio = 1;
    return scenario;
}

FloeSet floe_of(const Scenario& scenario) {
    return floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}});
}

/// N of all stamps at which the strip cracks, pressed in small steps.
double cracking_load(const Scenario& scenario, const Set& set) {
    WorldDefinition definition{.iterations = 50, .gravity = 0, .solver = SolverKind::direct};
    definition.contact = scenario.contact_law();
    World world(definition);
    IceField ice(world, scenario, floe_of(scenario));
    const double middle = world.state(ice.elements()[0].body).position.y();
    for (const double x : {-set.support, set.support}) {
        world.add_fixed_box(
            {.half_extents = {stamp / 2, thick / 2, side / 2}, .pose = {{x, middle - thick, 0}, Quat::Identity()}});
    }
    std::vector<BodyId> pressing;
    for (const double x : set.stamps) {
        pressing.push_back(world.add_element({.corners = corners_of(stamp / 2, stamp / 2),
                                              .half_thickness = thick / 2,
                                              .mass = 0.1,
                                              .pose = {{x, middle + thick, 0}, Quat::Identity()},
                                              .piece = 1000 + static_cast<int>(pressing.size()),
                                              .crushing_pressure = definition.contact.crushing_pressure}));
    }
    const double per_step = 0.01;
    for (int step = 1; step < 5000; ++step) {
        const double each = per_step * step / static_cast<double>(pressing.size());
        for (const BodyId body : pressing) world.apply(body, {Vec3(0, -each, 0), Vec3::Zero()});
        world.step();
        if (ice.break_joints(world, 0.02 * step) > 0) return per_step * step;
    }
    return 0;
}

/// An element with joints at both ends and nothing beside it.
PressedElement middle_of(const Scenario& scenario) {
    PressedElement element{.corners = corners_of(side / 2, side / 2),
                           .area = side * side,
                           .patch = square_patch,
                           .poisson_ratio = 0.3,
                           .crushing_pressure = scenario.contact_law().crushing_pressure};
    for (const auto& [outward, edge] : {std::pair(Corner{1, 0}, edge_plus_x), {Corner{-1, 0}, edge_minus_x}})
        element.joints.push_back({outward, side / 2 * outward, side, side, thick, edge});
    return element;
}

/// N by moment and stamp together, for a joint with the moment arm · load: a quarter of a stamp's load at each of its
/// corners. No joint along z, so nothing bends across.
double expected_load(const Scenario& scenario, const Set& set, double arm) {
    const PressedElement element = middle_of(scenario);
    const double corner = 0.25 / static_cast<double>(set.stamps.size());
    double load = 20;
    for (int i = 0; i < 30; ++i) {
        const double local = contact_stress(element, {stamp / 2, stamp / 2, corner * load}, 0).value().along / load;
        load = scenario.ice.bending_strength / (arm * 6 / (side * thick * thick) + local);
    }
    return load;
}

/// By moment alone the load has an arm; with it and the stamps' contacts the load by stress follows.
void expect_cracks(const Set& set, double arm) {
    Scenario scenario = strip(set);
    scenario.joint.failure = JointFailure::moment;
    // The strip sags, so it lies on the supports' inner edges, less the couple of the friction that holds it there.
    const double alone = cracking_load(scenario, set);
    const double measured = scenario.ice.bending_strength * side * thick * thick / 6 / alone;
    EXPECT_NEAR(measured, arm, 0.1 * arm);
    scenario.joint.failure = JointFailure::stress;
    const double expected = expected_load(scenario, set, measured);
    EXPECT_LT(expected, 0.94 * alone) << "or moment alone would pass";
    EXPECT_NEAR(cracking_load(scenario, set), expected, 0.05 * expected);
}

TEST(ThreePoints, CrackWhereMomentAndContactsReachTheStrength) {
    // From the supports' inner edges to the joints at half an element from the middle.
    expect_cracks({.elements = 3, .support = side, .stamps = {0}}, (side / 2 - stamp / 2) / 2);
}

TEST(FourPoints, CrackBelowAStampThoughTheMomentIsTheSameBetweenThem) {
    // From the supports' inner edges to the stamps; between the stamps the moment is constant.
    expect_cracks({.elements = 7, .support = 3 * side, .stamps = {-2 * side, 2 * side}}, (side - stamp / 2) / 2);
}

/// N at which the strip cracks across a knife above its middle, as its ends are lifted with half of it each: the knife
/// presses at two points, with half of it each.
double cracking_over_a_knife(const Scenario& scenario) {
    WorldDefinition definition{.iterations = 50, .gravity = 0, .solver = SolverKind::direct};
    definition.contact = scenario.contact_law();
    World world(definition);
    IceField ice(world, scenario, floe_of(scenario));
    const double top = world.state(ice.elements()[0].body).position.y() + thick / 2;
    const double half = 0.01;
    world.add_fixed_box({.half_extents = {half, half, stamp / 2},
                         .pose = {{0, top + half * std::numbers::sqrt2, 0},
                                  Quat(std::cos(std::numbers::pi / 8), 0, 0, std::sin(std::numbers::pi / 8))}});
    const double per_step = 0.01;
    for (int step = 1; step < 5000; ++step) {
        for (const IceElement* end : {&ice.elements().front(), &ice.elements().back()}) {
            const BodyState state = world.state(end->body);
            const double force = per_step * step / 2 - 20 * state.velocity.y();  // or it would tip over
            world.apply(end->body, {Vec3(0, force, 0), Vec3(state.position.z() * force, 0, 0)});  // on the middle line
        }
        world.step();
        if (ice.break_joints(world, 0.02 * step) > 0) return per_step * step;
    }
    return 0;
}

/// The moment of half the load on its lever, from the centroid of an end to the joint halfway to the middle, and what
/// the knife's points add.
TEST(Knife, CracksAStripAsABeam) {
    const Scenario scenario = strip({.elements = 3, .support = 0, .stamps = {}});
    const double lever = side / 2;
    const PressedElement element = middle_of(scenario);
    double expected = 20;
    for (int i = 0; i < 30; ++i) {
        const double local = contact_stress(element, {0, stamp / 2, expected / 2}, 0).value().along / expected;
        expected = scenario.ice.bending_strength / (lever / 2 * 6 / (side * thick * thick) + local);
    }
    EXPECT_NEAR(cracking_over_a_knife(scenario), expected, 0.02 * expected);
}

}  // namespace three_point_test
}  // namespace floes::test
