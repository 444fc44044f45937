// Level ice that is held at its far end and lifted on a slope, beside the beam on water (theory/plate.hpp).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/level_ice.hpp"
#include "support/plate_forms.hpp"

namespace floes {
namespace level_ice_test {

constexpr double degree = std::numbers::pi / 180;

/// What the wall bears until the sheet cracks, and where that is.
struct FirstCrack {
    double vertical = 0;    ///< N/m, the largest
    double horizontal = 0;  ///< N/m, then
    double distance = 0;    ///< m from the edge, mean of the joints that failed within a tenth of a second
    double time = 0;        ///< s
};

FirstCrack first_crack(const Scenario& scenario, std::uint32_t arrangement) {
    Simulation simulation(scenario, make_arrangement(scenario, 1, arrangement));
    FirstCrack found;
    while (simulation.ice().breaks().empty() && simulation.time() < 9) {
        simulation.step();
        const double lift = -simulation.loads().heave.back() / scenario.floe.breadth;
        if (lift <= found.vertical) continue;
        found.vertical = lift;
        found.horizontal = simulation.loads().surge.back() / scenario.floe.breadth;
    }
    found.time = simulation.time();
    while (simulation.time() < found.time + 0.1) simulation.step();
    double sum = 0;
    for (const BreakEvent& one : simulation.ice().breaks())
        sum += simulation.ice().cut(0).joints[static_cast<std::size_t>(one.joint)].pivot.x + scenario.floe.length / 2;
    found.distance = sum / static_cast<double>(simulation.ice().breaks().size());
    return found;
}

test::LiftedEdge expected_of(const Scenario& scenario, double angle) {
    return test::lifted_edge({scenario.floe.thickness}, scenario.ice.elastic_modulus, scenario.ice.bending_strength,
                             test::push_over_lift(angle, scenario.contact.ice_structure_friction),
                             scenario.floe.thickness / 2);
}

struct Slope {
    double degrees;
    double element;  ///< over the characteristic length
};

class SlopeAndElement : public testing::TestWithParam<Slope> {};

// The load as the edge is lifted comes by itself from wall, friction, weight and stiffness; with elements of 0.05 to
// 0.3 L_c it is the beam's within 3 %, walls of 30 to 70 degrees, where the thrust is 3 to 26 % of what buckles the
// edge. Joints fail in a zone about the largest moment, which is flat, so where they do scatters by some cells.
TEST_P(SlopeAndElement, CrackTheSheetAsABeamOnWater) {
    const double angle = GetParam().degrees * degree;
    const Scenario scenario = test::level_strip(angle, GetParam().element);
    const test::LiftedEdge expected = expected_of(scenario, angle);
    const FirstCrack found = first_crack(scenario, 0);
    RecordProperty("load_over_beam", std::to_string(found.vertical / expected.vertical));
    RecordProperty("distance_over_beam", std::to_string(found.distance / expected.distance));
    EXPECT_NEAR(found.vertical / expected.vertical, 1, 0.03);
    EXPECT_NEAR(found.horizontal / found.vertical, expected.horizontal / expected.vertical, 0.01);
    EXPECT_NEAR(found.distance / expected.distance, 1, 0.06);
}

INSTANTIATE_TEST_SUITE_P(LevelIce, SlopeAndElement,
                         testing::Values(Slope{30, 0.2}, Slope{45, 0.3}, Slope{45, 0.2}, Slope{45, 0.15},
                                         Slope{45, 0.1}, Slope{45, 0.05}, Slope{60, 0.2}, Slope{70, 0.2}));

// Under the load that the wall bears just before the crack, everywhere within 3 % of what its edge has risen by.
TEST(LevelIce, IsBentAsABeamOnWater) {
    const Scenario scenario = test::level_strip(45 * degree, 0.1);
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    const double afloat = simulation.element_states().front().position.y();
    while (simulation.time() < 3.2) simulation.step();
    ASSERT_TRUE(simulation.ice().breaks().empty());
    const double breadth = scenario.floe.breadth;
    const test::EdgeLoad load{-simulation.loads().heave.back() / breadth, simulation.loads().surge.back() / breadth,
                              scenario.floe.thickness / 2};
    const auto expected = [&](double x) {
        return test::height_of_edge({scenario.floe.thickness}, scenario.ice.elastic_modulus, load, x);
    };
    const CutFloe& cut = simulation.ice().cut(0);
    for (std::size_t i = 0; i < cut.elements.size(); ++i)
        EXPECT_NEAR(simulation.element_states()[i].position.y() - afloat,
                    expected(cut.elements[i].centre.x + scenario.floe.length / 2), 0.03 * expected(0));
}

/// A wall that does not rub, on ice that does not break.
Scenario pressed_strip(double angle, double element, double length) {
    Scenario scenario = test::level_strip(angle, element, length);
    scenario.contact.ice_structure_friction = 1e-6;
    scenario.contact.crushing_pressure = 1e9;
    for (double* strength : {&scenario.ice.bending_strength, &scenario.ice.compressive_strength,
                             &scenario.ice.shear_strength, &scenario.ice.tensile_strength})
        *strength = 5e6;
    return scenario;
}

// E T b / l, l to the middle of the rigid element at the wall, and what presses one end is what the other holds.
TEST(LevelIce, IsPressedAsARodThatIsHeld) {
    const Scenario scenario = pressed_strip(90 * degree, 0.2, 8);
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    double before = 0;
    while (simulation.time() < 0.8) {
        simulation.step();
        if (simulation.steps() == 20) before = simulation.loads().surge.back();
    }
    const double load = simulation.loads().surge.back();
    const double stiffness = (load - before) / (0.4 * scenario.structure.speed);
    EXPECT_NEAR(stiffness * (scenario.floe.length - scenario.floe.element / 2) /
                    (scenario.ice.elastic_modulus * scenario.floe.thickness * scenario.floe.breadth),
                1, 0.03);
    EXPECT_NEAR(simulation.force_on_supports().x() / load, 1, 0.01);
    EXPECT_TRUE(simulation.ice().breaks().empty());
}

/// Height (m) at x (m) from the edge of a sheet on water that is pressed by a smooth wall which the whole face lies on,
/// `tilt` (rad) off upright: w' = tilt and w''' = 0 at the edge, w = exp(-αx) (A cos βx + B sin βx).
double height_beside_wall(const FloatingPlate& plate, double elastic_modulus, double thrust, double tilt, double x) {
    const double rigidity = plate.flexural_rigidity(elastic_modulus);
    const double root = std::sqrt(plate.foundation() / (4 * rigidity));
    const double alpha = std::sqrt(root - thrust / (4 * rigidity));
    const double beta = std::sqrt(root + thrust / (4 * rigidity));
    const double real = alpha * (3 * beta * beta - alpha * alpha);
    const double imaginary = beta * (3 * alpha * alpha - beta * beta);
    const double sine = tilt / (beta + alpha * imaginary / real);
    return std::exp(-alpha * x) * sine * (std::sin(beta * x) - imaginary / real * std::cos(beta * x));
}

struct Thrust {
    double angle;  ///< of the wall, degrees
    double share;  ///< of the thrust that buckles a free edge
};

class SlowThrust : public testing::TestWithParam<Thrust> {};

// Pushed slowly, a sheet bends more and more the nearer the thrust is to what buckles it: √(k D) where its edge is
// free, on a wall of 85 degrees that touches the lower corner, twice that on one of 89.5, which the whole face lies on.
TEST_P(SlowThrust, BendsTheSheetAsABeamThatIsAboutToBuckle) {
    const double angle = GetParam().angle * degree;
    Scenario scenario = pressed_strip(angle, 0.1, 12);
    scenario.structure.speed = 0.0002;  // m/s; at 0.001 the bend lags behind the thrust
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    const double afloat = simulation.element_states().front().position.y();
    const FloatingPlate plate{scenario.floe.thickness};
    const double modulus = scenario.ice.elastic_modulus;
    const double breadth = scenario.floe.breadth;
    const bool flush = GetParam().share > 1;
    const double thrust = GetParam().share * test::buckling_thrust(plate, modulus);
    while (simulation.loads().surge.empty() || simulation.loads().surge.back() < thrust * breadth) {
        simulation.step();
        ASSERT_LT(simulation.time(), 60);
    }
    const test::EdgeLoad load{-simulation.loads().heave.back() / breadth, simulation.loads().surge.back() / breadth,
                              scenario.floe.thickness / 2};
    const CutFloe& cut = simulation.ice().cut(0);
    std::vector<double> height;
    std::vector<double> expected;
    for (std::size_t i = 0; i < cut.elements.size(); ++i) {
        const double x = cut.elements[i].centre.x + scenario.floe.length / 2;
        height.push_back(simulation.element_states()[i].position.y() - afloat);
        expected.push_back(flush ? height_beside_wall(plate, modulus, load.horizontal, 90 * degree - angle, x)
                                 : test::height_of_edge(plate, modulus, load, x));
    }
    const double highest = *std::ranges::max_element(expected);
    for (std::size_t i = 0; i < height.size(); ++i) EXPECT_NEAR(height[i], expected[i], 0.06 * highest);
}

INSTANTIATE_TEST_SUITE_P(LevelIce, SlowThrust,
                         testing::Values(Thrust{85, 0.25}, Thrust{85, 0.4}, Thrust{89.5, 1.2}, Thrust{89.5, 1.6}));

// But for the water's drag, which is a thousandth of this load.
TEST(LevelIce, ThatIsPushedOnAWallAtRestLoadsItAsTheTowThroughIceAtRest) {
    Scenario scenario = test::level_strip(45 * degree, 0.2);
    const FirstCrack towed = first_crack(scenario, 0);
    scenario.field.level_pushed = true;
    const FirstCrack pushed = first_crack(scenario, 0);
    EXPECT_NEAR(pushed.vertical / towed.vertical, 1, 0.02);
    EXPECT_NEAR(pushed.time, towed.time, 0.1);
    EXPECT_NEAR(pushed.distance / towed.distance, 1, 0.1);
}

// At rest it would be struck at its held edge, and crush there.
TEST(LevelIce, ThatIsPushedComesWithWhatPushesIt) {
    Scenario scenario = test::level_strip(45 * degree, 0.2);
    scenario.field.level_pushed = true;
    scenario.structure.speed = 2;
    scenario.structure.start -= 1;  // nothing touches yet
    scenario.analysis.window = 1;
    Simulation simulation(scenario, make_arrangement(scenario, 1, 0));
    for (int k = 0; k < 5; ++k) {
        simulation.step();
        for (const BodyState& one : simulation.state().elements) EXPECT_NEAR(one.velocity.x(), -2, 0.02);
    }
    EXPECT_TRUE(simulation.ice().breaks().empty());
}

TEST(LevelIce, FreeOfWhatIsBehindItIsPushedAway) {
    Scenario scenario = test::level_strip(45 * degree, 0.2);
    scenario.field.level_held = LevelHeld::nowhere;
    scenario.field.far_end = FarEnd::open;
    EXPECT_LT(first_crack(scenario, 0).vertical, 0.1 * expected_of(scenario, 45 * degree).vertical);
}

// Means of four patterns of cells, which scatter by 1 %. Held at 4, 5 and 8 characteristic lengths the edge cracks
// under 0.976, 0.989 and 1.001 of the load of the beam without an end.
TEST(LevelIce, HardlyKnowsWhereItIsHeldFromFiveCharacteristicLengthsOn) {
    const auto mean = [](double length) {
        double sum = 0;
        for (const std::uint32_t arrangement : {0U, 1U, 2U, 3U})
            sum += first_crack(test::level_strip(45 * degree, 0.2, length), arrangement).vertical / 4;
        return sum / expected_of(test::level_strip(45 * degree, 0.2, length), 45 * degree).vertical;
    };
    EXPECT_NEAR(mean(5), 1, 0.02);
    EXPECT_NEAR(mean(8), 1, 0.01);
}

TEST(LevelIce, ThatWasSavedAndSetGoesOnWithTheSameBits) {
    Scenario scenario = test::level_strip(45 * degree, 0.3);
    scenario.spread.length = 0.2;
    scenario.spread.strength = {LawKind::lognormal, 0.2, {0.25, 4}};
    for (const bool pushed : {false, true}) {
        scenario.field.level_pushed = pushed;
        const Arrangement sheet = make_arrangement(scenario, 1, 2);
        Simulation whole(scenario, sheet);
        while (whole.time() < 4) whole.step();
        ASSERT_GT(whole.ice().breaks().size(), 3u);
        Simulation first(scenario, sheet);
        while (first.time() < 3.5) first.step();
        Simulation second(scenario, sheet);
        second.set(first.saved());
        while (second.time() < 4) second.step();
        EXPECT_EQ(second.loads().surge, whole.loads().surge);
        EXPECT_EQ(second.ice().breaks(), whole.ice().breaks());
    }
}

}  // namespace level_ice_test
}  // namespace floes
