// Loads on the wall by closed form, and mirrored runs.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/smoke_channel.hpp"

namespace floes {
namespace wall_test {

/// A floe between the wall of configs/table3_physical.toml, 69 degrees below the waterline, and the far end's sheet.
Scenario pushed_under(double friction) {
    Scenario scenario = in_smoke_channel({});
    scenario.structure.shape = Shape({{-0.443, 0.445}, {0.0, 0.614}, {0.122, 0.736}});
    scenario.structure.speed = 0.01;
    scenario.field.floes = 1;
    scenario.field.concentration = 0.36 / (2.5 * 0.604);
    scenario.contact.ice_ice_friction = 1e-6;
    scenario.contact.ice_structure_friction = friction;
    scenario.ice.bending_strength = scenario.ice.compressive_strength = scenario.ice.shear_strength = 1e7;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 8;
    scenario.water.flow = WaterFlow::still;
    return scenario;
}

// Ice that slides down a wall of α from the horizontal loads it with H / V = (sin α + f cos α) / (cos α - f sin α):
// 3.7, 5.9 and 13.7 for f = 0.1, 0.2 and 0.3 at 69.1 degrees.
TEST(Wall, IsLoadedInTheDirectionOfItsNormalAndFriction) {
    const double angle = std::atan2(0.443, 0.614 - 0.445);
    for (const double f : {0.1, 0.2, 0.3}) {
        const Scenario scenario = pushed_under(f);
        Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{2.302, 0, 0}}));
        double h = 0;
        double v = 0;
        int under = 0;
        while (simulation.time() < 7) {
            simulation.step();
            const double surge = simulation.loads().surge.back();
            if (simulation.time() < 2 || surge < 2) continue;
            h += surge;
            v += simulation.loads().heave.back();
            ++under;
        }
        const double expected = (std::sin(angle) + f * std::cos(angle)) / (std::cos(angle) - f * std::sin(angle));
        EXPECT_GT(under, 100);
        EXPECT_NEAR(h / v, expected, 0.002 * expected) << f;
    }
}

// A floe that is pushed under slowly, its other end against the sheet, where nothing rubs. Covered by water it is
// lifted by B = (ρ_w - ρ_i) g times its volume, 8.2 N. About the far end, with the front edge d below it,
// V l + H d = B l/2: so V = (B/2) / (1 + (d/l) H/V), and H = 24 N as it goes under (f = 0.2, H/V = 5.9).
TEST(Wall, IsLoadedByAFloeThatIsPushedUnderAsStaticsHasIt) {
    const Scenario scenario = pushed_under(0.2);
    const double slope = 0.443 / (0.614 - 0.445);
    const double angle = std::atan(slope);
    const double ratio = (std::sin(angle) + 0.2 * std::cos(angle)) / (std::cos(angle) - 0.2 * std::sin(angle));
    const double lift = 70 * 9.81 * 0.36 * 0.033;
    EXPECT_NEAR(0.5 * lift * ratio, 24, 0.3);
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{2.302, 0, 0}}));
    const double gaps = 2.002 + 0.002 - 0.614 - 1.38;  // before the floe is squeezed, m
    for (double advance = 0.03; advance < 0.065; advance += 0.01) {
        double h = 0;
        int steps = 0;
        while (0.01 * simulation.time() - gaps < advance + 0.0025) {
            simulation.step();
            if (0.01 * simulation.time() - gaps < advance - 0.0025) continue;
            h += simulation.loads().surge.back();
            ++steps;
        }
        const double expected = 0.5 * lift * ratio / (1 + slope * advance / 0.6 * ratio);
        EXPECT_NEAR(h / steps, expected, 0.04 * expected) << advance;
    }
}

// A blow on a floe that lies free: without friction the wall pushes along its normal n, r from the floe's centre, and
// the rim takes up the wall's speed along n. The floe and the water that moves with it resist with the mass 1/m_n = 1/m
// + (r x n)²/I, so the impulse is m_n V sin α along n: the load of floes that are struck as often for each metre of the
// tow grows with V².
TEST(Wall, IsStruckByAFloeAndTheWaterThatItMoves) {
    const double angle = std::atan2(0.443, 0.614 - 0.445);
    const double carried = 1 + 4.4;
    const double mass = carried * 930 * 0.6 * 0.6 * 0.033;
    const double inertia = mass * (0.6 * 0.6 + 0.033 * 0.033) / 12;
    const double arm = 0.3 * std::cos(angle) - 0.5 * 0.033 * std::sin(angle);
    const double struck = 1 / (1 / mass + arm * arm / inertia);
    for (const double speed : {0.05, 0.1, 0.2, 0.4}) {
        Scenario scenario = pushed_under(0);
        scenario.structure.shape = Shape({{-0.443, 0.445}, {0.122, 0.445 + 0.565 / std::tan(angle)}});
        scenario.structure.speed = speed;
        scenario.general.time_step = 5e-4 / speed;
        scenario.floe.element = 0.6;
        scenario.field.far_end = FarEnd::open;
        scenario.field.concentration = 0.05;
        scenario.contact.normal = NormalLaw::rigid;
        scenario.contact.split_impulse = false;
        scenario.water.added_mass_from = WaterFrom::share;
        scenario.water.added_mass = carried - 1;
        scenario.analysis.window = 10;
        Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{2.302, 0, 0}}));
        double surge = 0;
        double heave = 0;
        for (int steps = 0; steps < 3;) {
            simulation.step();
            surge += simulation.loads().surge.back() * scenario.general.time_step;
            heave += simulation.loads().heave.back() * scenario.general.time_step;
            if (surge > 0) ++steps;
            ASSERT_LT(simulation.time(), 0.05 / speed + 2);
        }
        const double impulse = struck * speed * std::sin(angle);
        EXPECT_NEAR(surge, impulse * std::sin(angle), 0.03 * impulse) << speed;
        EXPECT_NEAR(heave, impulse * std::cos(angle), 0.03 * impulse) << speed;
    }
}

double mean_of(const std::vector<double>& values, int first) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(first); i < values.size(); ++i) sum += values[i];
    return sum / static_cast<double>(values.size() - static_cast<std::size_t>(first));
}

// A floe of an odd number of elements, hit in the middle, gives hardly any load abeam.
TEST(Wall, IsNotPushedAsideByAFloeInTheMiddle) {
    Scenario scenario = in_smoke_channel({});
    scenario.field.floes = 1;
    scenario.field.concentration = 0.05;
    scenario.field.far_end = FarEnd::open;
    Simulation simulation(scenario, floes_at(scenario, std::vector<PlanarPose>{{2.302, 0, 0}}));
    double surge = 0;
    double sway = 0;
    while (simulation.time() < 4) {
        simulation.step();
        surge = std::max(surge, simulation.loads().surge.back());
        sway = std::max(sway, std::abs(simulation.loads().sway.back()));
    }
    EXPECT_GT(surge, 20);
    EXPECT_LT(sway, 1e-3 * surge);
}

// Fields seen in a mirror: not the same loads step by step, because contacts are solved one after another, but the
// same on average, and sway with the other sign.
TEST(Wall, IsLoadedAlikeByMirroredFields) {
    Scenario scenario = in_smoke_channel({});
    scenario.analysis.steady_start = 4;
    scenario.analysis.window = 8;
    double surge[2]{};
    double sway[2]{};
    constexpr int arrangements = 4;
    for (int k = 0; k < arrangements; ++k) {
        FloeSet floes = make_arrangement(scenario, 34, static_cast<std::uint32_t>(k));
        for (int mirrored = 0; mirrored < 2; ++mirrored) {
            Simulation simulation(scenario, floes);
            ASSERT_TRUE(simulation.run({}));
            surge[mirrored] += mean_of(simulation.loads().surge, scenario.first_window_step()) / arrangements;
            sway[mirrored] += mean_of(simulation.loads().sway, scenario.first_window_step()) / arrangements;
            for (Floe& floe : floes.floes) floe.pose = {floe.pose.x, -floe.pose.z, -floe.pose.yaw};
        }
    }
    EXPECT_NEAR(surge[1], surge[0], 0.2 * surge[0]);
    EXPECT_NEAR(sway[1], -sway[0], 0.2 * surge[0]);
}

}  // namespace wall_test
}  // namespace floes
