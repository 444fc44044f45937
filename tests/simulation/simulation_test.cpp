#include "simulation/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "ice/ice_field.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace simulation_test {

/// A channel with room for a few floes and a tow so slow that the structure stays away from them.
Scenario quiet_scenario(int floes, double duration) {
    Scenario scenario = sweeping_scenario();
    scenario.field.floes = floes;
    scenario.field.concentration = 0.05;
    scenario.structure.speed = 1e-9;
    scenario.water.flow = WaterFlow::still;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = duration;
    return scenario;
}

void run(Simulation& simulation) {
    ASSERT_TRUE(simulation.run({}));
}

double draught_of(const BodyState& state, const Scenario& scenario) {
    return 0.5 * scenario.floe.thickness - state.position.y();
}

TEST(Floating, AFloeAtRestStaysAtRestForAMinute) {
    const Scenario scenario = quiet_scenario(1, 60);
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{6.75, 0.3, 0.4}}));
    const std::vector<BodyState> before = simulation.element_states();
    run(simulation);
    const std::vector<BodyState>& after = simulation.element_states();
    ASSERT_EQ(after.size(), 9u);
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_LT((after[i].position - before[i].position).norm(), 1e-9) << i;
        EXPECT_LT((after[i].rotation - before[i].rotation).norm(), 1e-9) << i;
        EXPECT_LT(after[i].velocity.norm(), 1e-9) << i;
        EXPECT_LT(after[i].angular_velocity.norm(), 1e-9) << i;
    }
    EXPECT_TRUE(simulation.ice().breaks().empty());
}

// Started at the draught of another density, 5 mm off, every element settles to ρ_i/ρ_w of the thickness.
TEST(Floating, SettlesToTheTrueDraughtFromFiveMillimetresOff) {
    Scenario scenario = quiet_scenario(1, 20);
    const double draught = 0.93 * 0.033;
    Scenario heavier = scenario;  // its water is denser, so that ice starts 5 mm too high for the water that acts
    heavier.water.density = 930 * 0.033 / (draught - 0.005);
    World world = scenario_world(heavier);
    const std::vector<PlanarPose> poses{{10, 0, 0.2}};
    IceField ice(world, heavier, floes_at(heavier, poses));
    const WaterModel water(scenario.water, 9.81, {0.2, 0.033}, 930 * 0.04 * 0.033, 0.614, 0);
    EXPECT_NEAR(draught_of(world.state(ice.elements()[0].body), scenario), draught - 0.005, 1e-12);
    for (int step = 0; step < scenario.step_count(); ++step) {
        for (const IceElement& element : ice.elements()) {
            const BodyState state = world.state(element.body);
            world.apply(element.body, water.wrench({state.position, state.rotation, state.velocity,
                                                    state.angular_velocity, element.exposed_edges},
                                                   0));
        }
        world.step();
    }
    for (const IceElement& element : ice.elements()) {
        EXPECT_NEAR(draught_of(world.state(element.body), scenario), draught, 1e-4);
    }
}

/// The structure drives at one floe in open water.
Scenario head_on(double duration) {
    Scenario scenario = sweeping_scenario();
    scenario.field.floes = 1;
    scenario.field.concentration = 0.01;
    scenario.field.far_end = FarEnd::open;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = duration;
    return scenario;
}

// Pushed under at one edge, a floe has at most its net buoyancy F = (ρ_w - ρ_i) g T L² = 8.2 N along it to bend it,
// which gives 4/27 F L = 0.73 N m in its worst section: no joint can carry more, against 1.32 N m at which one fails.
TEST(Tow, ALoneFloeIsPushedAwayUnbroken) {
    const Scenario scenario = head_on(60);
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{3.2, 0.0, 0.1}}));
    run(simulation);
    EXPECT_TRUE(simulation.ice().breaks().empty());
    const double net_buoyancy = (1000 - 930) * 9.81 * 0.033 * 0.36;
    EXPECT_LT(simulation.ice().peaks().bending, 4.0 / 27 * net_buoyancy * 0.6);
    EXPECT_GT(simulation.ice().peaks().bending, 0);
    double pushed = 0;
    for (const BodyState& state : simulation.element_states()) pushed = std::max(pushed, state.position.x() - 3.2);
    EXPECT_GT(pushed, 1.0);
}

TEST(Tow, TheLoadIsPositiveAgainstTheTowAndOneEntryAStep) {
    const Scenario scenario = head_on(40);
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{3.2, 0.0, 0.0}}));
    run(simulation);
    const LoadHistory& loads = simulation.loads();
    ASSERT_EQ(loads.surge.size(), 2000u);
    ASSERT_EQ(loads.sway.size(), 2000u);
    ASSERT_EQ(loads.heave.size(), 2000u);
    EXPECT_EQ(*std::max_element(loads.surge.begin(), loads.surge.begin() + 50), 0);  // not there yet
    double impulse = 0;
    for (const double load : loads.surge) impulse += load * scenario.general.time_step;
    // The floe, 11.05 kg, was brought from rest to about the speed of the tow.
    EXPECT_GT(impulse, 0.8 * 11.05 * 0.07);
    EXPECT_LT(*std::max_element(loads.surge.begin(), loads.surge.end()), 100);
    EXPECT_DOUBLE_EQ(simulation.time(), 40);
}

TEST(Tow, ARunawayEndsTheRunWithElementFloeAndTime) {
    Scenario scenario = head_on(40);
    scenario.general.runaway_speed = 0.01;
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{3.2, 0.0, 0.0}}));
    try {
        simulation.run({});
        FAIL() << "no failure";
    } catch (const MemberFailure& failure) {
        EXPECT_THAT(failure.what(), testing::MatchesRegex("Element .* of floe 0 has run away.*t = .* s.*"));
    }
    EXPECT_EQ(simulation.loads().surge.size(), static_cast<std::size_t>(simulation.steps()));
    EXPECT_LT(simulation.steps(), 2000);
}

TEST(Tow, StopsOnRequest) {
    Simulation simulation(head_on(40), floes_at(head_on(40), std::vector<PlanarPose>{{6.5, 0.0, 0.0}}));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(simulation.run(stop.get_token()));
    EXPECT_EQ(simulation.steps(), 0);
}

}  // namespace simulation_test
}  // namespace floes
