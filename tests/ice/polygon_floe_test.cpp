// Floes in cells: as beams and plates.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "ice/ice_field.hpp"
#include "ice_scene.hpp"
#include "theory/plate.hpp"

namespace floes::test {
namespace polygon_floe_test {

Scenario polygon_scenario() {
    Scenario scenario;
    scenario.joint.failure = JointFailure::moment;
    scenario.ice.bending_strength = scenario.ice.shear_strength = scenario.ice.compressive_strength = 1e12;
    return scenario;
}

/// About its centroid and long axis, as floes are.
FloeShape shape_of(const Scenario& scenario, const Outline& outline, double element) {
    const Measures of = measures_of(outline);
    FloeShape shape = scenario.floe;
    shape.element = element;
    shape.outline = in_axes(outline, of.centroid, long_axis(of));
    shape.length = size_of(shape.outline).x;
    shape.breadth = size_of(shape.outline).z;
    return shape;
}

FloeSet alone(const Scenario& scenario, const FloeShape& shape, const PlanarPose& pose = {}) {
    return {{shape}, {scenario.material()}, {{pose}}};
}

/// Buoyancy as springs under each element, and drag that brings everything to rest.
void float_on(World& world, const IceField& ice, const Scenario& scenario, double drag) {
    const CutFloe& cut = ice.cut(0);
    for (const IceElement& one : ice.elements()) {
        const CutElement& element = cut.elements[static_cast<std::size_t>(one.index)];
        const BodyState state = world.state(one.body);
        const double k = scenario.water.density * scenario.general.gravity;
        const double under = scenario.floe.thickness / 2 - state.position.y();
        const Vec3 tilt = state.rotation.transpose() * Vec3::UnitY().cross(state.rotation.col(1));
        const Vec3 righting = -k * Vec3(element.zz * tilt.x(), 0, element.xx * tilt.z());
        world.apply(one.body, {{0, k * element.area * under - drag * element.area * state.velocity.y(), 0},
                               state.rotation * righting});
    }
}

/// Couples at its oblique ends bend a strip to the curvature M/(D b).
TEST(PolygonFloe, CutObliquelyBendsAsABeam) {
    Scenario scenario = polygon_scenario();
    scenario.general.gravity = 0;
    const double width = 0.2;
    const FloeShape strip = shape_of(scenario, {{-1.2, -0.1}, {0.8, -0.1}, {1.2, 0.1}, {-0.8, 0.1}}, 0.1);
    World world = scenario_world(scenario);
    IceField ice(world, scenario, alone(scenario, strip));
    const CutFloe& cut = ice.cut(0);
    const double moment = 0.05;
    const auto at_end = [&](const CutElement& one, double end) { return one.centre.x * end > 0.55; };
    const auto area_at = [&](double end) {
        double area = 0;
        for (const CutElement& one : cut.elements) area += at_end(one, end) ? one.area : 0;
        return area;
    };
    for (int step = 0; step < 600; ++step) {
        for (const IceElement& one : ice.elements()) {
            const CutElement& element = cut.elements[static_cast<std::size_t>(one.index)];
            for (const double end : {-1.0, 1.0})
                if (at_end(element, end))
                    world.apply(one.body, {Vec3::Zero(), {0, 0, end * moment * element.area / area_at(end)}});
        }
        world.step();
    }
    // Slopes of elements in the middle third, by least squares over x.
    double xs = 0;
    double slopes = 0;
    int count = 0;
    for (const IceElement& one : ice.elements()) {
        const double x = cut.elements[static_cast<std::size_t>(one.index)].centre.x;
        if (std::abs(x) > 0.4) continue;
        const Mat3 in_floe =
            world.state(one.body).rotation *
            turned_to(cut.elements[static_cast<std::size_t>(one.index)].axis).toRotationMatrix().transpose();
        xs += x * x;
        slopes += x * std::atan2(in_floe(1, 0), in_floe(0, 0));
        ++count;
    }
    ASSERT_GT(count, 10);
    const double expected = moment / (elastic_ice(strip, scenario.material()).flexural_rigidity() * width);
    EXPECT_NEAR(slopes / xs / expected, 1, 0.02);
}

/// Depth under a load on the element in its middle, over that of the infinite plate of the closed form.
double depth_over_plate(const Scenario& scenario, const Outline& outline, double element) {
    const FloeShape shape = shape_of(scenario, outline, element);
    World world = scenario_world(scenario);
    const IceField ice(world, scenario, alone(scenario, shape));
    const CutFloe& cut = ice.cut(0);
    const auto nearest =
        std::ranges::min_element(cut.elements, {}, [](const CutElement& one) { return dot(one.centre, one.centre); });
    EXPECT_LT(dot(nearest->centre, nearest->centre), element * element);
    const BodyId middle = ice.elements()[static_cast<std::size_t>(nearest - cut.elements.begin())].body;
    const double load = 4;
    const double start = world.state(middle).position.y();
    for (int step = 0; step < 500; ++step) {
        float_on(world, ice, scenario, 2000);
        world.apply(middle, {{0, -load, 0}, Vec3::Zero()});
        world.step();
    }
    const FloatingPlate plate{.thickness = shape.thickness};
    const double radius = std::sqrt(nearest->area / std::numbers::pi);
    return (start - world.state(middle).position.y()) * patch_load_slope(plate, scenario.ice.elastic_modulus, radius) /
           load;
}

/// A hexagon on water under a load in its middle sinks as a square sheet of such elements, which the closed form is
/// compared with in tests/simulation; here both are within what elements of 0.7 of a characteristic length resolve.
TEST(PolygonFloe, HexagonOnWaterSinksAsAPlate) {
    Scenario scenario = polygon_scenario();
    scenario.ice.elastic_modulus = 15e6;  // so soft that the rim is far away
    const double element = 0.19;
    const double half = 8.5 * element;
    Outline hexagon;
    for (int k = 0; k < 6; ++k)
        hexagon.push_back({half * std::cos(k * std::numbers::pi / 3), half * std::sin(k * std::numbers::pi / 3)});
    const double of_hexagon = depth_over_plate(scenario, hexagon, element);
    const double of_square =
        depth_over_plate(scenario, {{-half, -half}, {half, -half}, {half, half}, {-half, half}}, element);
    EXPECT_NEAR(of_hexagon / of_square, 1, 0.03);
    EXPECT_NEAR(of_square, 1, 0.1);
    EXPECT_NEAR(of_hexagon, 1, 0.1);
}

/// A joint fails when its moment exceeds that of its own edge, σ L T²/6.
TEST(PolygonFloe, JointsFailByTheLengthOfTheirEdges) {
    const Scenario scenario = polygon_scenario();
    Material material = scenario.material();
    material.ice.bending_strength = 40e3;
    const Thresholds whole = make_thresholds(scenario.floe, material);
    const Thresholds half =
        make_thresholds(scenario.floe.element / 2, scenario.floe.element, scenario.floe.thickness, material);
    EXPECT_NEAR(half.bending, whole.bending / 2, 1e-12);
    EXPECT_NEAR(half.shear, whole.shear / 2, 1e-9);
    JointReaction reaction{.bending = 0.75 * whole.bending};
    EXPECT_FALSE(failure(reaction, whole));
    EXPECT_EQ(failure(reaction, half), FailureMode::bending);
}

TEST(PolygonFloe, FallsIntoPiecesWhereItsJointsFail) {
    Scenario scenario = polygon_scenario();
    scenario.general.gravity = 0;
    scenario.ice.bending_strength = 36e3;
    const FloeShape strip = shape_of(scenario, {{-0.5, -0.1}, {0.3, -0.1}, {0.5, 0.1}, {-0.3, 0.1}}, 0.2);
    World world = scenario_world(scenario);
    IceField ice(world, scenario, alone(scenario, strip));
    const int joints = ice.live_joints();
    const IceElement& first = ice.elements().front();
    const IceElement& last = ice.elements().back();
    const auto rim = [&] {
        int edges = 0;
        for (const IceElement& one : ice.elements()) edges += std::popcount(one.exposed_edges);
        return edges;
    };
    const int before = rim();
    for (int step = 0; step < 20 && ice.live_joints() == joints; ++step) {
        world.apply(first.body, {{0, 40, 0}, Vec3::Zero()});
        world.apply(last.body, {{0, 40, 0}, Vec3::Zero()});
        world.apply(ice.elements()[ice.elements().size() / 2].body, {{0, -80, 0}, Vec3::Zero()});
        world.step();
        ice.break_joints(world, 0.02 * (step + 1));
    }
    EXPECT_LT(ice.live_joints(), joints);
    EXPECT_GT(ice.pieces(), 1);
    EXPECT_GT(rim(), before);
}

}  // namespace polygon_floe_test
}  // namespace floes::test
