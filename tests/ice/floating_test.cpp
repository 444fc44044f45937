// Newly placed floes: where they float, that they stay at rest, that their elements do not touch each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "ice/ice_field.hpp"
#include "ice_scene.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes::test {
namespace floating_test {

constexpr double gravity = 9.81;

/// Buoyancy of an element that is neither dry nor under water, for small tilts: ρ_w g L² times the draught, and the
/// righting moment of its waterplane, ρ_w g L⁴ / 12 times the tilt.
Wrench buoyancy(const Scenario& scenario, const BodyState& state) {
    const double side = scenario.floe.element;
    const double stiffness = scenario.water.density * gravity * side * side;
    const double draught = scenario.floe.thickness / 2 - state.position.y();
    const Vec3 tilt = Vec3::UnitY().cross(state.rotation.col(1));
    return {Vec3(0, stiffness * draught, 0), -stiffness * side * side / 12 * tilt};
}

TEST(IceFloating, BeginsAtTheDraughtOfArchimedes) {
    const Scenario scenario = sweeping_scenario();
    World world{WorldDefinition{}};
    const IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{5, 1, 0.3}}));
    for (const IceElement& element : ice.elements()) {
        const double lower_face = world.state(element.body).position.y() - scenario.floe.thickness / 2;
        EXPECT_NEAR(lower_face, -0.93 * 0.033, 1e-12);
    }
}

TEST(IceFloating, LaysElementsWhereThePoseSays) {
    Scenario scenario = sweeping_scenario();
    scenario.floe.length = 0.4;  // 2 x 3 elements
    World world{WorldDefinition{}};
    const double yaw = 0.4;
    const IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}, {5, 1, yaw}}));
    ASSERT_EQ(ice.elements().size(), 12u);
    EXPECT_EQ(ice.live_joints(), 2 * 7);
    const Vec3 along(std::cos(yaw), 0, -std::sin(yaw));  // +z turns to +x
    const Vec3 across(std::sin(yaw), 0, std::cos(yaw));
    const Vec3 corner = world.state(ice.elements()[6].body).position;
    EXPECT_NEAR((corner - Vec3(5, corner.y(), 1) + 0.1 * along + 0.2 * across).norm(), 0, 1e-12);
    const Vec3 next = world.state(ice.elements()[7].body).position;
    EXPECT_NEAR((next - corner - 0.2 * along).norm(), 0, 1e-12);
    EXPECT_NEAR((world.state(ice.elements()[7].body).rotation.col(0) - along).norm(), 0, 1e-12);
    const Vec3 beside = world.state(ice.elements()[8].body).position;
    EXPECT_NEAR((beside - corner - 0.2 * across).norm(), 0, 1e-12);
}

TEST(IceFloating, StaysAtRestForAMinute) {
    const Scenario scenario = sweeping_scenario();
    World world{WorldDefinition{}};
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{5, 1, 0.3}}));
    std::vector<Vec3> start;
    for (const IceElement& element : ice.elements()) start.push_back(world.state(element.body).position);
    for (int step = 0; step < 3000; ++step) {
        for (const IceElement& element : ice.elements()) {
            world.apply(element.body, buoyancy(scenario, world.state(element.body)));
        }
        world.step();
        ice.break_joints(world, (step + 1) * 0.02);
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
        const BodyState state = world.state(ice.elements()[i].body);
        EXPECT_LT((state.position - start[i]).norm(), 1e-9);
        EXPECT_LT(state.velocity.norm(), 1e-9);
        EXPECT_LT(state.angular_velocity.norm(), 1e-9);
    }
    EXPECT_EQ(ice.broken_floes(), 0);
    EXPECT_LT(ice.peaks().bending, 1e-6);
}

// Added mass has inertia and no weight: a floe with it floats at the same height, and the water lifts it as
// ρ_w g L² δ / (m (1 + added_mass)).
TEST(IceFloating, CarriesItsAddedMassAlong) {
    Scenario scenario = scenario_of(1, 1);
    scenario.water.added_mass = 4.4;
    const double depth = 1e-3;
    const double step = scenario.general.time_step;
    const auto speed_after_a_step = [&](double sunk) {
        World world = scenario_world(scenario);
        const IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
        const BodyId element = ice.elements()[0].body;
        BodyState state = world.state(element);
        state.position.y() -= sunk;
        world.apply(element, buoyancy(scenario, state));
        world.step();
        return world.state(element).velocity.y();
    };
    EXPECT_NEAR(speed_after_a_step(0), 0, 1e-15);
    const double mass = 930 * 0.2 * 0.2 * 0.033;
    EXPECT_NEAR(speed_after_a_step(depth), 1000 * gravity * 0.04 * depth / (mass * 5.4) * step, 1e-15);
}

TEST(IceFloating, ShowsTheWaterTheOutlineOfAFloeOrEveryElement) {
    for (const auto& [on, faces] : {std::pair{FormDragOn::outline, 12}, std::pair{FormDragOn::every_element, 36}}) {
        Scenario scenario = sweeping_scenario();
        scenario.water.form_drag_on = on;
        World world{WorldDefinition{}};
        const IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
        int found = 0;
        for (const IceElement& element : ice.elements()) found += std::popcount(element.exposed_edges);
        EXPECT_EQ(found, faces);
    }
}

// Bent, sheared and squeezed at once, neighbours and diagonal neighbours overlap; they are one piece and do not touch.
TEST(IceFloating, DoesNotTouchItself) {
    Scenario scenario = sweeping_scenario();
    scenario.joint.cfm = 0.1;  // soft
    scenario.ice.bending_strength = scenario.ice.compressive_strength = scenario.ice.shear_strength = 1e9;
    World world = weightless_world();
    IceField ice(world, scenario, floes_at(scenario, std::vector<PlanarPose>{{0, 0, 0}}));
    double closest = 1;
    for (int step = 0; step < 200; ++step) {
        for (const IceElement& element : ice.elements()) {
            const Corner centre = ice.cut_element(element).centre;
            const Vec3 place(centre.x, 0, centre.z);
            world.apply(element.body, {-300 * place, Vec3(place.z(), 0, -place.x())});
        }
        world.step();
        ice.break_joints(world, 0);
        for (const IceElement& element : ice.elements()) {
            EXPECT_EQ(world.contact_force(element.body), Vec3(0, 0, 0));
        }
        const Vec3 diagonal =
            world.state(ice.elements()[4].body).position - world.state(ice.elements()[0].body).position;
        closest = std::min(closest, std::max(std::abs(diagonal.x()), std::abs(diagonal.z())));
    }
    EXPECT_LT(closest, 0.2 - 1e-3) << "the load must make diagonal neighbours overlap";
}

}  // namespace floating_test
}  // namespace floes::test
