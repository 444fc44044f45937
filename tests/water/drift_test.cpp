// Wind and the turning of the layer below the ice, on one element, by closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "water/water_model.hpp"

namespace floes {
namespace drift_test {

constexpr double radius = 0.614;
constexpr double tow = 0.07;
constexpr double degree = std::numbers::pi / 180;

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
