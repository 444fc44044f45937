// Level ice without end: rows of cells are joined ahead, and broken ice leaves behind.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "endless_tow.hpp"
#include "support/level_ice.hpp"

namespace floes {
namespace endless_sheet_test {

constexpr double degree = std::numbers::pi / 180;

Scenario without_end(Scenario scenario, double ahead) {
    const double length = scenario.characteristic_length();
    scenario.field.far_end = FarEnd::never;
    scenario.field.ahead = scenario.structure.shape.waterline_ahead() + ahead * length;
    scenario.field.behind = scenario.structure.shape.largest_radius() + 2 * length;
    scenario.analysis.segments = 1;
    return scenario;
}

/// The strip of test::level_strip() with elements of 0.2 L_c, on the slope.
Scenario on_slope(double ahead) {
    return without_end(test::level_strip(45 * degree, 0.2), ahead);
}

/// A barge, wider than the strip of elements of 0.3 L_c, that breaks it downwards and passes over it for so long.
Scenario under_barge(double seconds) {
    Scenario scenario = test::level_strip(45 * degree, 0.3);
    scenario.floe.breadth = 4 * scenario.floe.element;
    scenario.structure.shape =
        Shape(HullKind::barge, {.length = 0.5, .beam = 0.6, .draught = 0.15, .freeboard = 0.1, .stem = 45 * degree});
    scenario.field.half_width = 1.5;
    scenario.structure.start = -scenario.structure.shape.waterline_ahead() - 0.01;
    scenario.structure.speed = 0.2;
    scenario.analysis.window = seconds;
    return without_end(scenario, 5);
}

struct Crack {
    double load = 0;  ///< largest until the first joint failed, N
    double time = 0;
};

Crack first_crack(const Scenario& scenario) {
    Simulation simulation = tow(scenario);
    Crack found;
    while (simulation.ice().breaks().empty() && simulation.time() < 9) {
        simulation.step();
        found.load = std::max(found.load, simulation.loads().surge.back());
    }
    found.time = simulation.time();
    return found;
}

TEST(EndlessSheet, BeginsWithTheBitsOfAnyLongerOneAndTakesNoMorePlaces) {
    const std::vector<Contradiction> contradictions = find_contradictions(under_barge(30));
    ASSERT_TRUE(contradictions.empty()) << contradictions.front().sentence;
    Simulation shorter = tow(under_barge(15));
    Simulation longer = tow(under_barge(30));
    ASSERT_NO_FATAL_FAILURE(expect_same_beginning(shorter, longer));
    EXPECT_LE(longer.ice().places(), shorter.ice().places() + 40) << "but for two parts that wait";
    EXPECT_GT(longer.ice().floes(), shorter.ice().floes() + 100);
    EXPECT_GT(longer.ice().breaks().size(), 3 * shorter.ice().breaks().size() / 2);
}

TEST(EndlessSheet, GoesOnFromASavedStateWithTheSameBits) {
    Simulation whole = tow(under_barge(16));
    Simulation resumed = tow(under_barge(16));
    while (whole.time() < 12) whole.step();
    ASSERT_GT(whole.ice().floes(), whole.ice().places()) << "ice is to have left";
    resumed.set(whole.saved());
    EXPECT_TRUE(resumed.saved() == whole.saved());
    ASSERT_TRUE(whole.run({}));
    ASSERT_TRUE(resumed.run({}));
    EXPECT_EQ(whole.loads().surge, resumed.loads().surge);
    EXPECT_EQ(whole.ice().breaks(), resumed.ice().breaks());
    EXPECT_TRUE(whole.saved() == resumed.saved());
}

// Nothing touches the ice; rows come, wake and leave as the hull goes by beside it.
TEST(EndlessSheet, StaysAtRestWhileRowsAreJoined) {
    for (const bool varied : {false, true}) {
        Scenario scenario = under_barge(15);
        scenario.water.flow = WaterFlow::still;
        if (varied) {
            scenario.spread.length = 0.4;
            scenario.spread.thickness.law = LawKind::lognormal;
        }
        Simulation simulation = tow(scenario);
        FromOutside beside;
        beside.offset[1] = 1.0;
        simulation.lead_hull(beside.offset);
        while (simulation.time() < 14) simulation.step(beside);
        EXPECT_GT(simulation.ice().floes(), simulation.ice().places() + 20);
        double fastest = 0;
        for (const BodyState& state : simulation.element_states()) fastest = std::max(fastest, state.velocity.norm());
        EXPECT_LT(fastest, 1e-9);
    }
}

// The first crack does not know whether rows were joined since, and the beam's load says what it is.
TEST(EndlessSheet, CracksAsOneWhoseEndIsFartherAway) {
    const Crack nearer = first_crack(on_slope(8));
    const Crack farther = first_crack(on_slope(12));
    EXPECT_NEAR(nearer.load / farther.load, 1, 0.01);
    EXPECT_NEAR(nearer.time, farther.time, 0.05);
}

TEST(EndlessSheet, ThatIsPushedLoadsTheWallAsTheTow) {
    const Crack towed = first_crack(on_slope(5));
    Scenario scenario = on_slope(5);
    scenario.field.level_pushed = true;
    const Crack pushed = first_crack(scenario);
    EXPECT_NEAR(pushed.load / towed.load, 1, 0.02);
    EXPECT_NEAR(pushed.time, towed.time, 0.1);
}

// The hull is at rest, so water at rest does not flow round it.
TEST(EndlessSheet, ThatIsPushedComesThroughWaterAtRest) {
    Scenario scenario = under_barge(6);
    scenario.field.level_pushed = true;
    Simulation round_the_hull = tow(scenario);
    scenario.water.flow = WaterFlow::still;
    Simulation still = tow(scenario);
    for (const BodyState& state : still.element_states()) EXPECT_EQ(state.velocity.x(), -scenario.structure.speed);
    ASSERT_TRUE(round_the_hull.run({}));
    ASSERT_TRUE(still.run({}));
    ASSERT_FALSE(still.ice().breaks().empty());
    EXPECT_EQ(round_the_hull.loads().surge, still.loads().surge);
}

}  // namespace endless_sheet_test
}  // namespace floes
