// Loads on the wall by closed form, and mirrored runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// A floe of the length l and thickness T between wall and sheet, seen from the side: its corners from the lower one at
/// the wall on, against the clock.
struct SideView {
    static constexpr double length = 0.6, thickness = 0.033, breadth = 0.6, ice = 930, water = 1000;
    double height, tilt;  ///< of its middle above the water, m; its front down, rad

    std::array<Vec2, 4> corners(double x) const {
        const Vec2 along(0.5 * length * std::cos(tilt), 0.5 * length * std::sin(tilt));
        const Vec2 up(-0.5 * thickness * std::sin(tilt), 0.5 * thickness * std::cos(tilt));
        const Vec2 middle(x, height);
        return {middle - along - up, middle + along - up, middle + along + up, middle - along + up};
    }
};

/// Area under water and its first moment about y, by the shoelace formula.
Vec2 under_water(const std::array<Vec2, 4>& corners) {
    Vec2 found = Vec2::Zero();
    std::vector<Vec2> wet;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2& p = corners.at(i);
        const Vec2& q = corners.at((i + 1) % 4);
        if (p.y() < 0) wet.push_back(p);
        if ((p.y() < 0) != (q.y() < 0)) wet.push_back(p + p.y() / (p.y() - q.y()) * (q - p));
    }
    for (std::size_t i = 0; i < wet.size(); ++i) {
        const Vec2& p = wet[i];
        const Vec2& q = wet[(i + 1) % wet.size()];
        const double twice = p.x() * q.y() - q.x() * p.y();
        found += Vec2(twice / 2, twice * (p.x() + q.x()) / 6);
    }
    return found;
}

/// Thrust of a floe at rest that is squeezed by `advance` between a wall, which its upper front edge slides down with
/// H = ratio V, and a sheet without friction, which its lower far edge leans on: the height and tilt at which both
/// edges touch and no moment is left, by Newton's method.
double thrust(double advance, double slope, double ratio) {
    double h = 0;
    const auto left_over = [&](const Vec2& at) {
        using S = SideView;
        const SideView floe{at.x(), at.y()};
        const double reach = floe.corners(0)[1].x();
        const double x = S::length - advance - reach;
        const auto corners = floe.corners(x);
        const Vec2 wet = under_water(corners);
        const double lift = S::water * 9.81 * S::breadth;  // of an area
        const double weight = S::ice * 9.81 * S::length * S::thickness * S::breadth;
        const double v = lift * wet.x() - weight;
        h = ratio * v;
        const Vec2 front = corners[3];
        const double freeboard = S::thickness * (1 - S::ice / S::water);
        return Vec2(front.x() - (front.y() - freeboard) / slope,
                    lift * wet.y() - weight * x - v * front.x() - h * (front.y() - corners[1].y()));
    };
    Vec2 at(-0.03, 0.15);
    for (int i = 0; i < 100; ++i) {
        const Vec2 here = left_over(at);
        constexpr double small = 1e-7;
        Eigen::Matrix2d slopes;
        slopes << (left_over(at + Vec2(small, 0)) - here) / small, (left_over(at + Vec2(0, small)) - here) / small;
        const Vec2 way = slopes.inverse() * here;
        at -= way * std::min(1.0, 0.02 / way.norm());
    }
    left_over(at);
    return h;
}

// A floe that is pushed under slowly, its other end against the sheet, where nothing rubs: less than half of its lift
// under water, 4.1 N, rests on the wall, and H/V = 5.9 with f = 0.2.
TEST(Wall, IsLoadedByAFloeThatIsPushedUnderAsStaticsHasIt) {
    const Scenario scenario = pushed_under(0.2);
    const double slope = 0.443 / (0.614 - 0.445);
    const double angle = std::atan(slope);
    const double ratio = (std::sin(angle) + 0.2 * std::cos(angle)) / (std::cos(angle) - 0.2 * std::sin(angle));
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
        const double expected = thrust(advance, slope, ratio);
        EXPECT_NEAR(h / steps, expected, 0.012 * expected) << advance;
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
