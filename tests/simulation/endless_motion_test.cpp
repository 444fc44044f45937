// Structures on moorings and on paths through a field without end: the window goes with them and never back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "endless_tow.hpp"
#include "scenario/floes.hpp"
#include "simulation/moving_window.hpp"
#include "statistics/load_statistics.hpp"
#include "support/endless_scenario.hpp"

namespace floes {
namespace endless_motion_test {

constexpr double pi = std::numbers::pi;
constexpr double mass = 500;  // kg

/// On springs of this period, s, alike in surge, sway and yaw.
Scenario moored(double seconds, double period, SolverKind solver = SolverKind::lanes) {
    Scenario scenario = endless_scenario(seconds, solver);
    const double k = mass * 4 * pi * pi / (period * period);
    scenario.moorings = {.mass = mass, .gyration = 0.4, .surge = k, .sway = k, .yaw = 0.16 * k, .damping = 0.1};
    scenario.field.behind = 2.4;
    return scenario;
}

double mean_in_window(const Scenario& scenario, const std::vector<double>& history) {
    return mean_of(std::span(history).subspan(static_cast<std::size_t>(scenario.first_window_step())));
}

TEST(EndlessMoored, BeginsWithTheBitsOfAnyLongerOne) {
    for (const SolverKind solver : {SolverKind::lanes, SolverKind::direct}) {
        const auto run = [&](double seconds) {
            Scenario scenario = moored(seconds, 3, solver);
            scenario.field.behind = 1.6;
            EXPECT_EQ(find_contradictions(scenario).size(), 0u);
            return tow(scenario);
        };
        Simulation shorter = run(6);
        Simulation longer = run(14);
        ASSERT_TRUE(shorter.run({}));
        ASSERT_TRUE(longer.run({}));
        EXPECT_GT(longer.ice().floes(), longer.ice().places()) << "floes are to have left";
        EXPECT_GT(*std::ranges::max_element(shorter.motions().surge_offset), 0.005);
        const auto begins = [&](std::vector<double> all, const std::vector<double>& begin) {
            all.resize(begin.size());
            return all == begin;
        };
        EXPECT_TRUE(begins(longer.loads().surge, shorter.loads().surge));
        EXPECT_TRUE(begins(longer.motions().x, shorter.motions().x));
        EXPECT_TRUE(begins(longer.motions().yaw, shorter.motions().yaw));
    }
}

// The stiffest springs that 50 steps of 0.02 s in a period allow. The ice amplifies any difference, so that the means
// over three arrangements are compared.
TEST(EndlessMoored, StiffMooringsCarryTheTowedLoad) {
    double held = 0;
    double given = 0;
    for (std::uint32_t number = 0; number < 3; ++number) {
        const Scenario towed = endless_scenario(20);
        const Scenario stiff = moored(20, 1);
        Simulation there = tow(towed, number);
        Simulation here = tow(stiff, number);
        ASSERT_TRUE(there.run({}));
        ASSERT_TRUE(here.run({}));
        held += mean_in_window(towed, there.loads().surge) / 3;
        given += mean_in_window(stiff, here.loads().surge) / 3;
    }
    EXPECT_GT(held, 10);
    EXPECT_NEAR(given / held, 1, 0.15);
}

// The impulse of the ice is that of moorings, damping and motion: of floes that come and go too.
TEST(EndlessMoored, MeanOffsetIsTheMeanLoadOverTheStiffness) {
    Scenario scenario = moored(30, 2);
    scenario.analysis.steady_start = 10;
    scenario.analysis.window = 20;
    Simulation simulation = tow(scenario);
    ASSERT_TRUE(simulation.run({}));
    const double k = scenario.moorings.surge;
    const double load = mean_in_window(scenario, simulation.loads().surge);
    EXPECT_GT(load, 10);
    EXPECT_NEAR(mean_in_window(scenario, simulation.motions().surge_offset) * k / load, 1, 0.05);
    const auto impulse = [&](const std::vector<double>& force) {
        return scenario.general.time_step * std::accumulate(force.begin(), force.end(), 0.0);
    };
    const MooredState end = simulation.state().moored;
    const double damping = 2 * scenario.moorings.damping * std::sqrt(k * mass);
    const double taken = impulse(simulation.motions().surge_mooring) - mass * end.velocity[0] - damping * end.offset[0];
    EXPECT_NEAR(taken / impulse(simulation.loads().surge), 1, 0.01);
}

TEST(EndlessMoored, WindowDoesNotSwingWithTheHull) {
    const Scenario scenario = endless_scenario(20);
    LaidField laid = lay_field(scenario, 1, 0);
    MovingWindow window(scenario, laid.floes, std::move(laid.ahead));
    EXPECT_TRUE(window.moves_to(3.1));
    const double first = window.first();
    const double last = window.last();
    EXPECT_LE(first, 3.1 - scenario.field.behind);
    EXPECT_GT(last, 3.1 + scenario.field.ahead - 0.2);
    EXPECT_FALSE(window.moves_to(2.0));
    EXPECT_EQ(window.first(), first);
    EXPECT_EQ(window.last(), last);
    const double least = window_least(scenario);
    EXPECT_FALSE(window.has_left(first + least + 1e-9));
    EXPECT_TRUE(window.has_left(first + least - 1e-9));
    EXPECT_TRUE(window.moves_to(3.4));
}

// Its line ahead breaks, and that astern pulls it back over ice that is gone.
TEST(EndlessMoored, FailsWhereTheIceIsGone) {
    Scenario scenario = endless_scenario(20);
    scenario.moorings = {.free = {true}, .mass = mass};
    scenario.moorings.lines = {
        {.azimuth = 0, .distance = 20, .pretension = 200, .stiffness = 50, .break_load = 201},
        {.azimuth = pi, .distance = 20, .pretension = 200, .stiffness = 10},
    };
    ASSERT_EQ(find_contradictions(scenario).size(), 0u);
    Simulation simulation = tow(scenario);
    try {
        simulation.run({});
        FAIL() << "a hull came back over ice that is gone";
    } catch (const MemberFailure& failure) {
        const std::string words = failure.what();
        EXPECT_NE(words.find("The structure has come back to x = "), std::string::npos) << words;
        EXPECT_NE(words.find("larger field.behind_m"), std::string::npos) << words;
    }
    EXPECT_FALSE(std::isnan(simulation.state().moored.broken_at[0]));
    const std::vector<double>& x = simulation.motions().x;
    const double room = scenario.window_behind() - window_least(scenario);
    EXPECT_GT(*std::ranges::max_element(x) - x.back(), room) << "too early";
    EXPECT_LT(*std::ranges::max_element(x) - x.back(), room + 0.3) << "too late: a stride, and a step";
}

// The same floes in a field that ends far ahead: the same load, until a corner that slips by a rounding tells them
// apart, and from then on hardly another way: after 4 s eight arrangements lie 6 to 21 mm apart.
TEST(EndlessMoored, MeetsTheIceOfALongClosedField) {
    constexpr double apart = 0.025;  // m, of a way of 1.2 m
    const Scenario scenario = moored(4, 3);
    LaidField laid = lay_field(scenario, 1, 0);
    std::vector<SingleFloe> floes;
    for (std::size_t i = 0; i < laid.floes.size(); ++i)
        floes.push_back({laid.floes.floes[i].pose, laid.floes.shape(i), laid.floes.material(i)});
    for (const SingleFloe& floe : lay_field(scenario, 1, 0).ahead.next().floes) floes.push_back(floe);
    Scenario closed = scenario;
    closed.field.far_end = FarEnd::open;
    closed.field.floes = static_cast<int>(floes.size());
    Simulation endless(scenario, laid.floes, std::move(laid.ahead));
    Simulation ends(closed, gathered(floes));
    constexpr std::size_t first_blows = 11;  // steps
    for (std::size_t k = 0; k < first_blows; ++k) {
        endless.step();
        ends.step();
        EXPECT_NEAR(endless.loads().surge[k], ends.loads().surge[k], 1e-6) << k;
        EXPECT_NEAR(endless.motions().x[k], ends.motions().x[k], 1e-9) << k;
    }
    EXPECT_GT(endless.loads().surge[first_blows - 1], 10);
    ASSERT_TRUE(endless.run({}));
    ASSERT_TRUE(ends.run({}));
    for (std::size_t k = 0; k < endless.loads().surge.size(); ++k)
        EXPECT_NEAR(endless.motions().x[k], ends.motions().x[k], apart) << k;
}

// A drift that turns, a stop, and a way back that is short enough.
Scenario on_a_path(double seconds) {
    Scenario scenario = endless_scenario(seconds);
    scenario.structure.shape = Shape({{-0.443, 0.43}, {0.0, 0.5}, {0.122, 0.55}});
    scenario.field.behind = 2.4;
    scenario.path = {.legs = {{0, 0.3, 4, 0},
                              {0, 0.3, 3, 15 * unit::degree},
                              {20 * unit::degree, 0.3, 2, 0},
                              {0, 0, 1, 0},
                              {180 * unit::degree, 0.1, 1, 0},
                              {0, 0.3, 60, 0}}};
    return scenario;
}

TEST(EndlessPath, BeginsWithTheBitsOfAnyLongerOne) {
    ASSERT_EQ(find_contradictions(on_a_path(16)).size(), 0u);
    Simulation shorter = tow(on_a_path(12));
    Simulation longer = tow(on_a_path(16));
    ASSERT_NO_FATAL_FAILURE(expect_same_beginning(shorter, longer));
    EXPECT_GT(std::abs(longer.structure().after().position.z()), 0.3);
}

}  // namespace endless_motion_test
}  // namespace floes
