// Current, wind and the turning of the layer below the ice, on one element, by closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "water/water_model.hpp"

namespace floes {
namespace drift_test {

constexpr double radius = 0.614;
constexpr double tow = 0.07;
constexpr double degree = std::numbers::pi / 180;

Water streaming(double current, double direction) {
    Water water{.density = 1,
                .form_drag = 0,
                .skin_drag = 0,
                .heave_drag = 0,
                .heave_damping_from = WaterFrom::share,
                .heave_damping = 0.5};
    water.current = current;
    water.current_direction = direction;
    return water;
}

/// Velocity of the water at (x, z) from the structure's axis, as in flow_test.cpp.
Vec2 flow(const Water& water, const Vec2& from_axis) {
    constexpr double side = 0x1p-60;
    const WaterModel model(water, 1, {side, side}, 1 / (side * side), radius, tow);
    ElementState speck;
    speck.position = {from_axis.x(), -1, from_axis.y()};
    speck.rotation << 0, 1, 0, 1, 0, 0, 0, 0, -1;
    const double x = model.wrench(speck, 0).force.x();
    speck.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return {x, model.wrench(speck, 0).force.z()};
}

TEST(Current, IsUndisturbedFarAwayAndDoesNotPassThroughTheStructure) {
    for (const double direction : {0.0, 0.8, 2.5, -1.2}) {
        const Water water = streaming(0.2, direction);
        const Vec2 current(0.2 * std::cos(direction), 0.2 * std::sin(direction));
        EXPECT_NEAR((flow(water, {600, -200}) - current).norm(), 0, 1e-6);
        for (double theta = 0; theta < 6.2; theta += 0.3) {
            const Vec2 outward(std::cos(theta), std::sin(theta));
            EXPECT_NEAR((flow(water, radius * outward) - Vec2(tow, 0)).dot(outward), 0, 1e-14);
        }
    }
}

// What a body meets depends on its velocity through the water alone: turned by an angle, everything turns.
TEST(Current, IsTheFlowOfATowWhenTheStructureRests) {
    const Water still = streaming(0, 0);
    Water against = streaming(tow, std::numbers::pi);  // and the tow at tow: together twice as fast
    for (const Vec2& place : {Vec2(1, 0.3), Vec2(-0.2, 0.8), Vec2(-2, -1)}) {
        const Vec2 relative = flow(against, place) - Vec2(-tow, 0);
        EXPECT_NEAR((relative - 2 * flow(still, place)).norm(), 0, 1e-14);
    }
}

TEST(Current, PassesAStillStructureOnlyAsStillWater) {
    Water water = streaming(0.2, 0.5);
    water.flow = WaterFlow::still;
    EXPECT_NEAR((flow(water, {0.7, 0.1}) - 0.2 * Vec2(std::cos(0.5), std::sin(0.5))).norm(), 0, 1e-14);
}

constexpr ElementShape shape{0.2, 0.033};

WaterModel skin_only(double turning, const Vec2& wind = Vec2::Zero()) {
    Water water;
    water.form_drag = water.heave_drag = 0;
    water.flow = WaterFlow::still;
    water.turning = turning;
    return {water, 9.81, shape, 930 * 0.04 * 0.033, radius, tow, wind};
}

// τ = ½ ρ C_s |U| (cosθ U + sinθ k × U): anticlockwise from above, whichever face is up.
TEST(Turning, TurnsSkinDragAnticlockwiseFromAbove) {
    const double angle = 25 * degree;
    const double size = 0.5 * 1000 * 0.009 * 0.04 * 0.3 * 0.3;
    for (const bool upside_down : {false, true}) {
        ElementState state;
        state.velocity = {-0.3, 0, 0};  // water streams along +x past it
        if (upside_down) state.rotation = Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()).toRotationMatrix();
        const Vec3 force = skin_only(angle).wrench(state, 0).force;
        EXPECT_NEAR(force.x(), size * std::cos(angle), 1e-12);
        EXPECT_NEAR(force.z(), -size * std::sin(angle), 1e-12);
    }
}

TEST(Wind, PressesWithItsStressOnDryTopsOnly) {
    Wind wind;
    wind.speed = 10;
    wind.direction = 30 * degree;
    EXPECT_NEAR(wind.stress().norm(), 1.25 * 1.5e-3 * 100, 1e-15);
    const WaterModel model = skin_only(0, wind.stress());
    ElementState state;
    const Wrench afloat = model.wrench(state, 0);
    EXPECT_NEAR(afloat.force.x(), 0.1875 * 0.04 * std::cos(wind.direction), 1e-15);
    EXPECT_NEAR(afloat.force.z(), 0.1875 * 0.04 * 0.5, 1e-15);
    EXPECT_NEAR(afloat.moment.z(), -0.0165 * afloat.force.x(), 1e-15);  // at the top
    state.position.y() = -0.1;
    EXPECT_EQ(model.wrench(state, 0).force.x(), 0);
}

}  // namespace drift_test
}  // namespace floes
