// Structures that give way or follow a path through ice.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "core/error.hpp"
#include "simulation/simulation.hpp"
#include "statistics/load_statistics.hpp"
#include "support/smoke_channel.hpp"

namespace floes {
namespace moored_test {

constexpr double pi = std::numbers::pi;

/// Half of the smoke channel's floes, from the first contact on.
Scenario short_channel() {
    Scenario scenario = in_smoke_channel({});
    scenario.field.floes = 14;
    scenario.field.begin = 2.0;
    scenario.analysis.steady_start = 4;
    scenario.analysis.window = 6;
    scenario.analysis.segments = 1;
    return scenario;
}

/// A hull of 500 kg whose period in surge is this, s, alike in sway and yaw.
Moorings of_period(double period) {
    const double k = 500 * 4 * pi * pi / (period * period);
    return {.mass = 500, .gyration = 0.4, .surge = k, .sway = k, .yaw = 0.16 * k, .damping = 0.1};
}

Simulation run(const Scenario& scenario, std::uint32_t number = 0) {
    Simulation simulation(scenario, make_arrangement(scenario, 1, number));
    simulation.run({});
    return simulation;
}

double mean_in_window(const Scenario& scenario, const std::vector<double>& history) {
    return mean_of(std::span(history).subspan(static_cast<std::size_t>(scenario.first_window_step())));
}

// The stiffest moorings that a time step of 0.02 s allows: the load is the towed cone's as far as the ice, which
// amplifies any difference, lets four arrangements say; and its impulse is that of moorings, damping and motion.
TEST(MooredStructure, StiffMooringsCarryTheTowedLoad) {
    Scenario towed = short_channel();
    Scenario moored = towed;
    moored.moorings = of_period(1);
    double load_of_towed = 0;
    double load_of_moored = 0;
    for (std::uint32_t number = 0; number < 4; ++number) {
        const Simulation there = run(towed, number);
        const Simulation here = run(moored, number);
        const double load = mean_in_window(moored, here.loads().surge);
        load_of_towed += mean_in_window(towed, there.loads().surge);
        load_of_moored += load;
        const double step = moored.general.time_step;
        const auto impulse = [&](const std::vector<double>& force) {
            return step * std::accumulate(force.begin(), force.end(), 0.0);
        };
        const MooredState end = here.state().moored;
        const double k = moored.moorings.surge;
        const double damping = 2 * moored.moorings.damping * std::sqrt(k * 500);
        const double taken = impulse(here.motions().surge_mooring) - 500 * end.velocity[0] - damping * end.offset[0];
        EXPECT_NEAR(taken / impulse(here.loads().surge), 1, 0.01);
        EXPECT_NEAR(mean_in_window(moored, here.motions().surge_offset) * moored.moorings.surge,
                    mean_in_window(moored, here.motions().surge_mooring), 1e-9);
        EXPECT_GT(load, 5);
        EXPECT_TRUE(there.motions().x.empty());
    }
    EXPECT_NEAR(load_of_moored / load_of_towed, 1, 0.15);
}

TEST(MooredStructure, GivesWayMoreOnSofterMoorings) {
    Scenario moored = short_channel();
    moored.moorings = of_period(6);
    const Simulation soft = run(moored);
    const double offset = mean_in_window(moored, soft.motions().surge_offset);
    EXPECT_GT(offset, 0.01) << "some 10 N on 550 N/m";
    const std::vector<double>& x = soft.motions().x;
    const std::size_t last = x.size() - 1;
    EXPECT_NEAR(x[last], moored.structure.start + moored.structure.speed * 10 - soft.motions().surge_offset[last],
                1e-12);
    EXPECT_NE(soft.motions().sway_offset[last], 0);
    EXPECT_NE(soft.motions().yaw[last], 0);
}

TEST(MooredStructure, HeldDirectionsStayHeld) {
    Scenario moored = short_channel();
    moored.moorings = of_period(6);
    moored.moorings.free = {true};
    moored.analysis = {.steady_start = 2, .window = 2, .segments = 1};
    const Simulation simulation = run(moored);
    EXPECT_NE(simulation.motions().surge_offset.back(), 0);
    EXPECT_EQ(simulation.motions().sway_offset.back(), 0);
    EXPECT_EQ(simulation.motions().yaw.back(), 0);
}

// What the ice pushes up is borne by the water, by damping and by the hull's own rise; a cone is lifted.
TEST(MooredStructure, HeavesUnderTheIce) {
    Scenario moored = short_channel();
    moored.moorings = of_period(3);
    Moorings& moorings = moored.moorings;
    moorings.free = {true, true, true, true, true, true};
    moorings.mass = 383;
    moorings.height = -0.1;
    moorings.pitch_gyration = moorings.roll_gyration = 0.36;
    moorings.added[at(Motion::heave)] = 200;
    const Simulation simulation = run(moored);
    const double step = moored.general.time_step;
    const auto impulse = [&](const std::vector<double>& of) {
        return step * std::accumulate(of.begin(), of.end(), 0.0);
    };
    const auto heave = static_cast<int>(Motion::heave);
    const double stiffness = moored.water_stiffness()(heave, heave);
    EXPECT_NEAR(stiffness, 1000 * 9.81 * pi * 0.614 * 0.614, 1e-3 * stiffness);
    const MooredState end = simulation.state().moored;
    const double mass = 583;
    const double damping = 2 * moorings.damping * std::sqrt(stiffness * mass);
    const double taken =
        stiffness * impulse(simulation.motions().heave) + mass * end.velocity[heave] + damping * end.offset[heave];
    const double given = impulse(simulation.loads().heave);
    EXPECT_GT(mean_in_window(moored, simulation.loads().heave), 1);
    EXPECT_NEAR(taken / given, 1, 0.02);
    EXPECT_NE(simulation.motions().pitch.back(), 0);
    EXPECT_NE(simulation.motions().roll.back(), 0);
    EXPECT_EQ(simulation.structure().after().position.y(), end.offset[heave]);
}

// Ice that drifts against +x is the straight tow. The water of a structure that turns and drifts is computed with more
// terms, so that the last bits differ; later they decide once which points two elements touch at.
TEST(PathOfStructure, StraightLegIsTheTow) {
    Scenario towed = short_channel();
    towed.analysis = {.steady_start = 1, .window = 0.4, .segments = 1};
    Scenario legs = towed;
    legs.path = {.legs = {{0, towed.structure.speed, 10, 0}}};
    Scenario drift = towed;
    drift.path = {.legs = {{pi, towed.structure.speed, 10, 0}}, .of = PathOf::ice};
    const Simulation there = run(towed);
    const Simulation along = run(legs);
    const Simulation past = run(drift);
    double most = 0;
    for (std::size_t k = 0; k < 50; ++k) {  // rounding grows later
        most = std::max(most, there.loads().surge[k]);
        EXPECT_NEAR(along.loads().surge[k], there.loads().surge[k], 1e-8) << k;
        EXPECT_NEAR(past.loads().surge[k], there.loads().surge[k], 1e-8) << k;
    }
    EXPECT_GT(most, 1);
    EXPECT_NEAR(along.work().hull_friction, there.work().hull_friction, 1e-8);
}

// A bow at 90° feels ahead as sway what the world calls surge.
TEST(PathOfStructure, LoadsAreInTheStructuresOwnAxes) {
    Scenario ahead = short_channel();
    ahead.analysis = {.steady_start = 1, .window = 1, .segments = 1};
    Scenario turned = ahead;
    ahead.path.table = {{0, 0, 0, 0}, {10, 1, 0, 0}};
    turned.path.table = {{0, 0, 0, pi / 2}, {10, 1, 0, pi / 2}};  // the bow towards -z
    const Simulation one = run(ahead);
    const Simulation other = run(turned);
    // Before touching differs: a cone of many sides looks the same turned by 90°.
    EXPECT_NEAR(mean_of(other.loads().sway), -mean_of(one.loads().surge), 0.05 * std::abs(mean_of(one.loads().surge)));
    EXPECT_NEAR(mean_of(other.loads().heave), mean_of(one.loads().heave), 0.05 * std::abs(mean_of(one.loads().heave)));
    EXPECT_NEAR(other.motions().yaw.front(), pi / 2, 0);
}

// Ice rubs against the turning: the moment is negative for a positive yaw rate.
TEST(PathOfStructure, TurningWallIsRubbed) {
    for (const double side : {1.0, -1.0}) {
        Scenario scenario = short_channel();
        scenario.analysis = {.steady_start = 2, .window = 2, .segments = 1};
        scenario.path.table = {{0, 0, 0, 0}, {5, 0.5, 0, 2.5 * side}, {10, 1, 0, 5 * side}};
        const Simulation simulation = run(scenario);
        EXPECT_LT(side * mean_in_window(scenario, simulation.motions().yaw_load), -0.05);
        EXPECT_GT(simulation.work().hull_friction, 0);
    }
}

TEST(MooredStructure, ResumesWithTheSameBitsWhileNothingTouchesIt) {
    Scenario scenario = short_channel();
    scenario.structure.start = 1.2;
    scenario.moorings = of_period(3);
    scenario.moorings.quadratic[0] = 100;
    const FloeSet floes = make_arrangement(scenario, 1, 0);
    const Simulation start(scenario, floes);
    SimulationState pushed = start.state();
    pushed.moored.velocity = in_plane({0.01, 0.002, 0.01});
    Simulation whole(scenario, floes, pushed);
    for (int i = 0; i < 10; ++i) whole.step();
    Simulation resumed(scenario, floes, whole.state());
    for (int i = 0; i < 10; ++i) {
        whole.step();
        resumed.step();
    }
    ASSERT_EQ(whole.loads().surge.back(), 0);
    EXPECT_NE(whole.motions().yaw.back(), 0);
    EXPECT_EQ(resumed.motions().x.back(), whole.motions().x.back());
    EXPECT_EQ(resumed.motions().yaw.back(), whole.motions().yaw.back());
    for (std::size_t i = 0; i < whole.element_states().size(); ++i)
        EXPECT_NEAR((resumed.element_states()[i].position - whole.element_states()[i].position).norm(), 0, 1e-6) << i;
}

TEST(MooredStructure, FailsAtTheBank) {
    for (const auto& [sides, what] : {std::pair(FieldSides::ice_sheet, "has come to the ice sheet at a side"),
                                      {FieldSides::wall, "has come to the wall at a side"}}) {
        Scenario scenario = short_channel();
        scenario.field.sides = sides;
        scenario.moorings = of_period(6);
        const FloeSet floes = make_arrangement(scenario, 1, 0);
        SimulationState pushed = Simulation(scenario, floes).state();
        pushed.moored.velocity = in_plane({0, 3, 0});
        Simulation simulation(scenario, floes, pushed);
        try {
            simulation.run({});
            FAIL() << "no bank";
        } catch (const MemberFailure& failure) {
            EXPECT_NE(std::string(failure.what()).find(what), std::string::npos) << failure.what();
        }
    }
}

TEST(MooredStructure, FailsWhereItsBowTurnsIntoTheBank) {
    Scenario scenario = short_channel();
    const double length = 2 * scenario.field.half_width + 0.4;
    scenario.structure.shape =
        Shape(HullKind::barge, {.length = length, .beam = 0.6, .draught = 0.3, .freeboard = 0.2, .stem = 0.25 * pi});
    scenario.structure.start = scenario.field.begin - length;
    scenario.moorings = of_period(6);
    const FloeSet floes = make_arrangement(scenario, 1, 0);
    SimulationState turned = Simulation(scenario, floes).state();
    Simulation along(scenario, floes, turned);
    EXPECT_NO_THROW(along.step());
    turned.moored.offset = in_plane({0, 0, 0.5 * pi});
    Simulation across(scenario, floes, turned);
    EXPECT_THROW(across.step(), MemberFailure);
}

}  // namespace moored_test
}  // namespace floes
