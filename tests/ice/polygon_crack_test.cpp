// Polygons that crack by stress: a strip in any direction, and two elements that a crack parts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ice/ice_field.hpp"
#include "ice_scene.hpp"

namespace floes::test {
namespace polygon_crack_test {

FloeSet alone(const Scenario& scenario, const Outline& outline, double element) {
    FloeShape shape = scenario.floe;
    shape.element = element;
    shape.outline = in_axes(outline, measures_of(outline).centroid, {1, 0});
    shape.length = size_of(shape.outline).x;
    shape.breadth = size_of(shape.outline).z;
    return {{shape}, {scenario.material()}, {{}}};
}

Corner direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

/// A strip under couples at its ends. SI.
struct Strip {
    double degrees;
    double half = 1.4;
    double width = 0.5;
    double moment = 0.4;

    Corner along() const { return direction(degrees); }
    double place(const CutElement& one) const { return dot(one.centre, along()); }
};

struct Bent {
    std::vector<double> used;  ///< the largest utilisation of each element in its middle
    double curvature;          ///< there, 1/m
};

/// Bends it until it is at rest.
Bent bent(const Strip& strip) {
    Scenario scenario;
    scenario.general.gravity = 0;
    scenario.joint.damping_ratio = 1;
    scenario.ice.bending_strength = scenario.ice.tensile_strength = 1e6;
    const double half = strip.half;
    const double broad = strip.width / 2;
    const Outline outline{{-half, -broad}, {half - 0.2, -broad}, {half, broad}, {-half + 0.2, broad}};
    World world = scenario_world(scenario);
    const FloeSet floes = alone(scenario, from_axes(outline, {}, strip.along()), 0.1);
    IceField ice(world, scenario, floes);
    const CutFloe& cut = ice.cut(0);
    const auto area_at = [&](double end) {
        double area = 0;
        for (const CutElement& one : cut.elements)
            area += (end > 0 ? 1 : -1) * strip.place(one) > half - 0.4 ? one.area : 0;
        return area;
    };
    const Vec3 about = Vec3(-strip.along().z, 0, strip.along().x);
    for (int step = 0; step < 400; ++step) {
        for (const IceElement& one : ice.elements()) {
            const CutElement& element = cut.elements[static_cast<std::size_t>(one.index)];
            const double at = strip.place(element);
            if (std::abs(at) > half - 0.4)
                world.apply(one.body,
                            {Vec3::Zero(), strip.moment * element.area / area_at(at) * (at > 0 ? about : -about)});
        }
        world.step();
        EXPECT_EQ(ice.break_joints(world, 0.02 * step), 0);
    }
    std::vector<double> all;
    ice.read_utilisation(world, all);
    std::vector<double> middle;
    double squares = 0;
    double places = 0;
    double turns = 0;
    double both = 0;
    for (const IceElement& one : ice.elements()) {
        const CutElement& element = cut.elements[static_cast<std::size_t>(one.index)];
        const double at = strip.place(element);
        if (std::abs(at) > 0.6) continue;
        middle.push_back(all[static_cast<std::size_t>(one.index)]);
        const Vec3 up = world.state(one.body).rotation.col(1);
        const double slope = -(up.x() * strip.along().x + up.z() * strip.along().z) / up.y();
        squares += at * at;
        places += at;
        turns += slope;
        both += at * slope;
    }
    const double count = static_cast<double>(middle.size());
    return {middle, (both - places * turns / count) / (squares - places * places / count)};
}

class Strips : public testing::TestWithParam<double> {};

/// 6 M/(b T²) whatever the angle: the principal stress, of the bending and twist of joints in every direction.
TEST_P(Strips, HaveTheStressOfABeamAtAnyAngle) {
    const Strip strip{.degrees = GetParam()};
    const auto [used, curvature] = bent(strip);
    ASSERT_GT(used.size(), 30U);
    const double rigidity = elastic_ice({}, Material{}).flexural_rigidity();
    EXPECT_NEAR(curvature * rigidity * strip.width / strip.moment, 1, 0.03);
    const double expected = 6 * strip.moment / (strip.width * 0.033 * 0.033) / 1e6;
    double sum = 0;
    for (const double one : used) sum += one / expected / static_cast<double>(used.size());
    EXPECT_NEAR(sum, 1, 0.05);  // of the worst joint of each element
    EXPECT_LT(std::ranges::max(used) / expected, 1.2);
}

INSTANTIATE_TEST_SUITE_P(Ice, Strips,
                         testing::Values(0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0));

class PolygonsThatPart : public testing::TestWithParam<Outline> {};

/// They turn against each other; what they lose until they are free is G_f times
/// thickness times the length of a straight crack.
TEST_P(PolygonsThatPart, LoseTheEnergyOfTheCrack) {
    const Outline& outline = GetParam();
    const double side = std::sqrt(area_of(outline) / 2);
    Scenario scenario;
    scenario.general.time_step = 0.01;
    scenario.water.added_mass_from = WaterFrom::share;
    scenario.ice.fracture_energy = 1.5;
    scenario.joint.damping_ratio = 0;
    const double thick = scenario.floe.thickness;
    const double rate = 0.01;  // rad/s of each
    FloeSet floes = alone(scenario, outline, side);
    FloeShape& shape = floes.shapes.front();
    const auto is_oblique = [&](int pattern) {
        const double towards =
            std::abs(cut_into_cells(shape.outline, side, static_cast<std::uint32_t>(pattern)).joints[0].normal.x);
        return towards > 0.75 && towards < 0.97;
    };
    shape.pattern = 0;
    while (!is_oblique(shape.pattern)) ++shape.pattern;
    const CutFloe cut = shape.cut();
    ASSERT_EQ(cut.elements.size(), 2U);
    ASSERT_EQ(cut.joints.size(), 1U);
    // Of the crack across the bending, which runs along x, however oblique the joint is.
    const double crack = 1.5 * cut.joints[0].length * std::abs(cut.joints[0].normal.x) * thick;
    const auto kinetic_of = [&](const CutElement& one, double density, const BodyState& state) {
        const double sheet = density * thick;
        const Vec3 turning = state.rotation.transpose() * state.angular_velocity;
        const double flat = one.area * thick * thick / 12;
        return 0.5 * sheet *
               ((one.zz + flat) * turning.x() * turning.x() + (one.xx + flat) * turning.z() * turning.z() +
                one.area * state.velocity.squaredNorm());
    };
    double density = 1;
    const auto started = [&](int index) {
        const CutElement& one = cut.elements[static_cast<std::size_t>(index)];
        const double way = one.centre.x < cut.joints[0].pivot.x ? -1 : 1;
        BodyState state;
        state.rotation = turned_to(one.axis).toRotationMatrix();
        state.angular_velocity = Vec3(0, 0, way * rate);
        state.velocity = Vec3(0, rate * std::abs(one.centre.x - cut.joints[0].pivot.x), 0);  // the pivot stays
        return state;
    };
    double before = 0;
    for (const int i : {0, 1}) before += kinetic_of(cut.elements[static_cast<std::size_t>(i)], density, started(i));
    density = 6 * crack / before;
    scenario.ice.density = density;
    floes.materials.front() = scenario.material();
    WorldDefinition definition{.time_step = 0.01, .gravity = 0, .solver = SolverKind::direct};
    definition.contact = scenario.contact_law();
    World world(definition);
    IceField ice(world, scenario, floes);
    for (const IceElement& one : ice.elements()) {
        BodyState state = world.state(one.body);
        const BodyState start = started(one.index);
        ASSERT_LT((state.rotation - start.rotation).norm(), 1e-9);
        state.angular_velocity = start.angular_velocity;
        state.velocity = start.velocity;
        world.place(one.body, state);
    }
    int steps = 0;
    while (ice.live_joints() > 0 && ++steps < 10000) {
        world.step();
        ice.break_joints(world, steps * 0.01);
    }
    ASSERT_EQ(ice.broken_floes(), 1);
    double after = 0;
    for (const IceElement& one : ice.elements())
        after += kinetic_of(cut.elements[static_cast<std::size_t>(one.index)], density, world.state(one.body));
    EXPECT_NEAR((6 * crack - after) / crack, 1, 0.05);
    EXPECT_NEAR(ice.fracture_work() / crack, 1, 0.05);
    EXPECT_EQ(ice.breaks().front().mode, FailureMode::bending);
    EXPECT_EQ(ice.cracked_floes(), 1);
    const std::vector<PieceArea> pieces = ice.piece_areas();
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_NEAR(pieces[0].area + pieces[1].area, area_of(outline), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Ice, PolygonsThatPart,
                         testing::Values(corners_of(0.2, 0.1), corners_of(0.2, 0.05), corners_of(0.2, 0.14),
                                         Outline{{-0.2, -0.1}, {0.2, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}));

}  // namespace polygon_crack_test
}  // namespace floes::test
