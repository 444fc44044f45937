// Whole floes in current and wind, by closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/smoke_channel.hpp"

namespace floes {
namespace drift_test {

constexpr double degree = std::numbers::pi / 180;

/// One floe of the tank far from the structure and from everything else, in water that is still unless it streams.
Scenario lone_floe() {
    Scenario scenario;
    scenario.field.floes = 1;
    scenario.field.concentration = 0.001;
    scenario.field.half_width = 50;
    scenario.field.sides = FieldSides::open;
    scenario.field.far_end = FarEnd::open;
    scenario.structure.speed = 1e-9;
    scenario.water.flow = WaterFlow::still;
    scenario.water.form_drag = 0;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 1000;
    return scenario;
}

Vec2 drift_of(const Scenario& scenario, double yaw = 0) {
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{20, 0, yaw}}));
    while (simulation.time() < 800) simulation.step();
    const Vec3& velocity = simulation.element_states()[4].velocity;
    return {velocity.x(), velocity.z()};
}

// ρ_a C_a U² = ½ ρ_w C_s u²: u = U √(ρ_a C_a / (½ ρ_w C_s)).
TEST(Drift, InWindAloneIsThatOfTheDragCoefficients) {
    Scenario scenario = lone_floe();
    scenario.wind.speed = 5;
    scenario.wind.direction = 40 * degree;
    const double expected = 5 * std::sqrt(1.25 * 1.5e-3 / (0.5 * 1000 * 0.009));
    const Vec2 drift = drift_of(scenario, 0.3);
    EXPECT_NEAR(drift.x(), expected * std::cos(40 * degree), 0.01 * expected);
    EXPECT_NEAR(drift.y(), expected * std::sin(40 * degree), 0.01 * expected);
}

// With form drag on the edge that meets the water: ρ_a C_a U² l b = ½ ρ_w (C_s l b + C_d b d) u².
TEST(Drift, InWindCountsFormDragOnTheEdge) {
    Scenario scenario = lone_floe();
    scenario.water.form_drag = 1;
    scenario.wind.speed = 5;
    const double draught = 0.93 * 0.033;
    const double expected = 5 * std::sqrt(1.25 * 1.5e-3 * 0.36 / (0.5 * 1000 * (0.009 * 0.36 + 1.0 * 0.6 * draught)));
    const Vec2 drift = drift_of(scenario);
    EXPECT_NEAR(drift.x(), expected, 0.01 * expected);
    EXPECT_NEAR(drift.y(), 0, 1e-3 * expected);
}

// The layer below turns the drift to the right of the wind (northern hemisphere), by the whole of its angle.
TEST(Drift, IsTurnedToTheRightOfTheWind) {
    Scenario scenario = lone_floe();
    scenario.wind.speed = 5;
    scenario.water.turning = 25 * degree;
    const Vec2 drift = drift_of(scenario);  // right of +x, seen from above, is +z
    EXPECT_NEAR(std::atan2(drift.y(), drift.x()), 25 * degree, 0.2 * degree);
}

TEST(Drift, WithTheCurrentIsExactlyAtItsSpeed) {
    Scenario scenario = lone_floe();
    scenario.water.form_drag = 1;
    scenario.water.current = 0.15;
    scenario.water.current_direction = -70 * degree;
    const Vec2 drift = drift_of(scenario, 0.2);
    EXPECT_NEAR(drift.x(), 0.15 * std::cos(70 * degree), 1e-12);
    EXPECT_NEAR(drift.y(), -0.15 * std::sin(70 * degree), 1e-12);
}

struct TwoTows {
    Simulation rest, stream;
};

/// A tow at 0.1 m/s through still water, and the same seen by somebody who moves along at 0.0625 m/s: with ice that
/// drifts in the current and nothing fixed near.
TwoTows two_tows(double start, double time_step) {
    Scenario rest = in_smoke_channel({});
    rest.general.time_step = time_step;
    rest.field.sides = FieldSides::open;
    rest.field.far_end = FarEnd::open;
    rest.structure.start = start;
    Scenario stream = rest;
    stream.structure.speed = 0.0375;
    stream.water.current = 0.0625;
    stream.water.current_direction = 180 * degree;
    const FloeSet floes = make_arrangement(rest, 1, 0);
    return {Simulation(rest, floes), Simulation(stream, floes)};
}

// Galilei: as long as nothing touches the structure, ice before it moves as if the frame did not matter, but for
// rounding, which contacts among the ice let grow.
TEST(Drift, WithTheCurrentIsTheSameFlowSeenFromElsewhere) {
    auto [rest, stream] = two_tows(1.1, 0.02);
    double fastest = 0;
    while (rest.time() < 1.5) {
        rest.step();
        stream.step();
        ASSERT_EQ(rest.loads().surge.back(), 0);
        for (std::size_t i = 0; i < rest.element_states().size(); ++i) {
            const BodyState& one = rest.element_states()[i];
            const BodyState& other = stream.element_states()[i];
            ASSERT_NEAR((one.position - other.position - Vec3(0.0625 * rest.time(), 0, 0)).norm(), 0, 1e-6);
            ASSERT_NEAR((one.velocity - other.velocity - Vec3(0.0625, 0, 0)).norm(), 0, 1e-6);
            fastest = std::max(fastest, one.velocity.norm());
        }
    }
    EXPECT_GT(fastest, 0.002);
}

// In contact only nearly: the structure is met where it is at the end of a step, the ice where it is at the
// beginning, so that a frame that moves at c shifts the two by c Δt.
TEST(Drift, WithTheCurrentGivesTheLoadOfTheSameTow) {
    auto [rest, stream] = two_tows(1.38, 0.002);
    double one = 0;
    double other = 0;
    while (rest.time() < 3) {
        rest.step();
        stream.step();
        one += rest.loads().surge.back() * 0.002;
        other += stream.loads().surge.back() * 0.002;
    }
    EXPECT_GT(one, 1);
    EXPECT_NEAR(other, one, 0.1 * one);
}

// With wind the shares of the work still add up: without that of the wind they would not.
TEST(Drift, OfWindHasItsShareOfTheWork) {
    Scenario scenario = in_smoke_channel({});
    scenario.wind.speed = 20;
    scenario.wind.direction = 180 * degree;
    scenario.water.current = 0.05;
    scenario.water.current_direction = 180 * degree;
    scenario.analysis.steady_start = 6;
    scenario.analysis.window = 6;
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    ASSERT_TRUE(simulation.run({}));
    const WorkShares work = simulation.work();
    const double load = together(work);
    EXPECT_GT(std::abs(work.driving), 0.02 * load);
    EXPECT_LT(std::abs(work.rest), 0.01 * load);
}

}  // namespace drift_test
}  // namespace floes
