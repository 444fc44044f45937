// Ice sheets that give way: how they move, what they press with, and what it does to the tow.

#include "simulation/sheets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "core/error.hpp"
#include "simulation/simulation.hpp"
#include "support/smoke_channel.hpp"

namespace floes {
namespace sheets_test {

/// A channel whose one floe lies far from its sides.
Scenario empty_channel(double confining) {
    Scenario scenario = in_smoke_channel({});
    scenario.field.floes = 1;
    scenario.field.concentration = 0.05;
    scenario.field.confining = confining;
    scenario.structure.speed = 1e-9;
    scenario.water.flow = WaterFlow::still;
    return scenario;
}

double mass_of(const Scenario& scenario, const IceSheet& sheet) {
    return 1.1 * scenario.ice.density * (2 * sheet.half_extents).prod();
}

// m u' = p l (1 - u/u_c): u = u_c (1 - exp(-t p l/(m u_c))), by steps of Δt implicit: u_c (1 - (1 + Δt p l/(m
// u_c))^-n).
TEST(Sheets, CloseAtTheirSpeedWhereTheyMeetNothing) {
    Scenario stated = empty_channel(3);
    stated.water.skin_drag = 0;
    Scenario of_path = stated;
    stated.field.closing_speed = 0.05;
    of_path.path.legs = {{0, 0.05, 10, 0}};
    for (const Scenario& scenario : {stated, of_path}) {
        const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{3, 0, 0}});
        const Channel channel = make_channel(scenario, floes);
        Simulation simulation(scenario, floes);
        ASSERT_EQ(simulation.sheets().size(), 3U);
        while (simulation.steps() < 50) simulation.step();
        for (std::size_t i = 0; i < 3; ++i) {
            const double load = 3 * channel.sheets[i].faces;
            const double k = 0.02 * load / (mass_of(scenario, channel.sheets[i]) * 0.05);
            const double speed = 0.05 * (1 - std::pow(1 + k, -50));
            EXPECT_NEAR(simulation.sheets()[i].speed, speed, 1e-9) << i;
            EXPECT_GT(simulation.sheets()[i].way, 0.3 * speed) << i;
        }
        EXPECT_NEAR(channel.sheets[0].faces, 0.36 / (0.05 * 2.5), 1e-12);
        EXPECT_NEAR(channel.sheets[2].faces, 2.5, 1e-12);
    }
}

// Without an end of its speed, drag balances it: u = u_∞ tanh(t p l/(m u_∞)), u_∞ = √(p l / (½ ρ C_s A)).
TEST(Sheets, ComeToTheSpeedOfTheirDrag) {
    Scenario scenario = empty_channel(0.5);
    scenario.field.closing_speed = 1e9;
    scenario.water.skin_drag = 5;
    const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{3, 0, 0}});
    const Channel channel = make_channel(scenario, floes);
    const IceSheet& side = channel.sheets[0];
    Simulation simulation(scenario, floes);
    const double load = 0.5 * side.faces;
    const double end = std::sqrt(load / (0.5 * 1000 * 5 * 4 * side.half_extents.x() * side.half_extents.z()));
    while (simulation.steps() < 200) {
        simulation.step();
        const double t = simulation.time();
        ASSERT_NEAR(simulation.sheets()[0].speed, end * std::tanh(t * load / (mass_of(scenario, side) * end)),
                    0.02 * end);
    }
}

/// Floes in one row across the channel, touching the sides and each other but for a millimetre.
FloeSet row_across(const Scenario& scenario) {
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 4; ++i) poses.push_back({3, -0.9 + 0.6 * i, 0});
    return floes_at(scenario, poses);
}

Scenario squeezed(double confining) {
    Scenario scenario = in_smoke_channel({});
    scenario.field.floes = 4;
    scenario.field.half_width = 1.2015;
    scenario.field.concentration = 0.75;
    scenario.field.far_end = FarEnd::open;
    scenario.field.confining = confining;
    scenario.field.closing_speed = 0.02;
    scenario.structure.speed = 1e-9;
    scenario.water.flow = WaterFlow::still;
    return scenario;
}

// At rest every cut through a row carries the whole load of the sheet that presses on it.
TEST(Sheets, PressAtRestWithAllOfTheLineLoad) {
    const Scenario scenario = squeezed(40);
    const FloeSet floes = row_across(scenario);
    Simulation simulation(scenario, floes);
    while (simulation.steps() < 500) simulation.step();
    const double load = 40 * scenario.field_length();
    Frame frame;
    simulation.read_frame(frame);
    std::vector<double> through(5);  // cuts at z = -1.2, -0.6, ...
    for (const FrameContact& one : frame.contacts) {
        const auto cut = static_cast<std::size_t>(std::lround((one.point.z() + 1.2) / 0.6));
        through[cut] += std::abs(one.normal.z());
    }
    for (const double force : through) EXPECT_NEAR(force, load, 0.03 * load);
    for (const SheetMotion& sheet : simulation.sheets()) {
        EXPECT_NEAR(sheet.speed, 0, 1e-4);
        EXPECT_LT(sheet.way, 0.01);
    }
}

// However hard: ice that is blocked stops them, and they do not go through it. (A row of floes would buckle.)
TEST(Sheets, DoNotGoThroughIceThatIsBlocked) {
    Scenario scenario = squeezed(2000);
    scenario.ice.compressive_strength = scenario.ice.bending_strength = scenario.ice.shear_strength = 1e6;
    scenario.field.floes = 1;
    scenario.field.half_width = 0.7015;
    scenario.floe.length = scenario.floe.breadth = 1.4;
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{4, 0, 0}}));
    while (simulation.steps() < 500) simulation.step();
    for (const SheetMotion& sheet : simulation.sheets()) {
        EXPECT_NEAR(sheet.speed, 0, 1e-3);
        EXPECT_LT(sheet.way, 0.03);
    }
}

TEST(Sheets, AreTheSameAfterAStateIsTakenUp) {
    Scenario scenario = squeezed(40);
    const FloeSet floes = row_across(scenario);
    Simulation simulation(scenario, floes);
    while (simulation.steps() < 40) simulation.step();
    const Simulation again(scenario, floes, simulation.state());
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(again.sheets()[i].way, simulation.sheets()[i].way, 1e-12);
        EXPECT_NEAR(again.sheets()[i].speed, simulation.sheets()[i].speed, 1e-12);
    }
}

TEST(Sheets, ThatCloseAsFarAsTheStructureEndTheMember) {
    Scenario scenario = empty_channel(30);
    scenario.field.closing_speed = 0.5;
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{5, 0, 0}}));
    EXPECT_THROW(simulation.run({}), MemberFailure);
}

Scenario packed(double confining) {
    Scenario scenario = in_smoke_channel({});
    scenario.analysis.steady_start = 6;
    scenario.analysis.window = 10;
    scenario.analysis.segments = 1;
    scenario.field.confining = confining;
    return scenario;
}

double mean_load(const Simulation& simulation, const Scenario& scenario) {
    const std::vector<double>& surge = simulation.loads().surge;
    const auto first = surge.begin() + scenario.first_window_step();
    return std::accumulate(first, surge.end(), 0.0) / static_cast<double>(surge.end() - first);
}

// The work that sheets do on the ice is one of the shares: without it they would not add up.
TEST(Sheets, HaveTheirShareOfTheWork) {
    const Scenario scenario = packed(3);
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    ASSERT_TRUE(simulation.run({}));
    const double mean = mean_load(simulation, scenario);
    const WorkShares work = simulation.work();
    EXPECT_GT(std::abs(work.driving), 0.02 * mean);
    EXPECT_LT(std::abs(work.rest), 0.01 * std::max(mean, std::abs(work.driving)));
}

// With nothing to hold the floes abeam, they go aside and little load is left.
TEST(Sheets, OpenSidesLetFloesOut) {
    Scenario scenario = packed(0);
    Simulation closed(scenario, make_arrangement(scenario, 1, 0));
    ASSERT_TRUE(closed.run({}));
    scenario.field.sides = FieldSides::open;
    const FloeSet floes = make_arrangement(scenario, 1, 0);
    EXPECT_EQ(make_channel(scenario, floes).sheets.size(), 1U);
    Simulation open(scenario, floes);
    ASSERT_TRUE(open.run({}));
    EXPECT_LT(mean_load(open, scenario), 0.7 * mean_load(closed, scenario));
    double widest = 0;
    for (const BodyState& element : open.element_states()) widest = std::max(widest, std::abs(element.position.z()));
    EXPECT_GT(widest, scenario.field.half_width);
}

TEST(Sheets, AreMovedByEachSolver) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::stock}) {
        Scenario scenario = packed(10);
        scenario.general.solver = solver;
        scenario.joint.model = JointModel::cfm;
        scenario.water.added_mass_from = WaterFrom::share;
        if (solver == SolverKind::stock) scenario.contact = with_preset(scenario.contact, ContactPreset::paper);
        Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
        for (int i = 0; i < 300; ++i) simulation.step();
        for (const SheetMotion& sheet : simulation.sheets()) EXPECT_GT(std::abs(sheet.way), 0.01);
    }
}

}  // namespace sheets_test
}  // namespace floes
