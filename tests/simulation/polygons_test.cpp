// A tow through floes that are polygons.

#include <gtest/gtest.h>

#include <cmath>

#include "arrangement/arrangement.hpp"
#include "simulation/simulation.hpp"
#include "support/smoke_channel.hpp"

namespace floes {
namespace polygons_test {

Scenario channel() {
    Scenario scenario = in_smoke_channel({});
    scenario.joint.failure = JointFailure::moment;
    scenario.analysis.steady_start = 2;
    scenario.analysis.window = 6;
    return scenario;
}

/// Squares given as outlines meet the structure, each other and the walls as squares do, until chance takes over.
TEST(PolygonTow, SquaresAsPolygonsBearTheLoadOfSquares) {
    Scenario scenario = channel();
    const Arrangement squares = make_arrangement(scenario, 1, 0);
    FloeSet polygons = squares;
    polygons.shapes.front().outline = {{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}};
    Simulation one(scenario, squares);
    Simulation other(scenario, polygons);
    double load = 0;
    double difference = 0;
    for (int step = 0; step < 60; ++step) {
        one.step();
        other.step();
        load += std::abs(one.loads().surge.back());
        difference += std::abs(one.loads().surge.back() - other.loads().surge.back());
    }
    EXPECT_GT(load, 10);
    EXPECT_LT(difference, 0.01 * load);
}

/// The first joint that cracks is the same one, at the same time. The ice is weak, so that it cracks within a second:
/// contacts of boxes and of prisms differ by a micrometre, which a tow makes a millimetre of by and by.
TEST(PolygonTow, SquaresAsPolygonsCrackWhereSquaresDo) {
    Scenario scenario = channel();
    scenario.joint.failure = JointFailure::stress;
    scenario.ice.bending_strength *= 0.2;
    const Arrangement squares = make_arrangement(scenario, 1, 0);
    FloeSet polygons = squares;
    polygons.shapes.front().outline = {{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}};
    Simulation one(scenario, squares);
    Simulation other(scenario, polygons);
    for (Simulation* tow : {&one, &other})
        while (tow->ice().breaks().empty() && tow->time() < 8) tow->step();
    ASSERT_FALSE(one.ice().breaks().empty());
    ASSERT_FALSE(other.ice().breaks().empty());
    EXPECT_LT(one.time(), 1);
    const BreakEvent& of_square = one.ice().breaks().front();
    const BreakEvent& of_polygon = other.ice().breaks().front();
    EXPECT_NEAR(of_square.time, of_polygon.time, 1.5 * scenario.general.time_step);
    ASSERT_EQ(of_square.floe, of_polygon.floe);
    EXPECT_EQ(of_square.mode, of_polygon.mode);
    const CutJoint& grid = one.ice().cut(of_square.floe).joints[static_cast<std::size_t>(of_square.joint)];
    const CutJoint& cut = other.ice().cut(of_polygon.floe).joints[static_cast<std::size_t>(of_polygon.joint)];
    EXPECT_EQ(grid.a, cut.a);
    EXPECT_EQ(grid.b, cut.b);
}

TEST(PolygonTow, VoronoiCellsRestUntilTheyAreMet) {
    Scenario scenario = channel();
    scenario.shapes.kind = ShapeKind::voronoi;
    scenario.water.flow = WaterFlow::still;
    scenario.structure.start = 0.5;
    const Arrangement floes = make_arrangement(scenario, 1, 1);
    Simulation tow(scenario, floes);
    for (int step = 0; step < 40; ++step) tow.step();
    for (const BodyState& state : tow.element_states()) {
        EXPECT_LT(state.velocity.norm(), 1e-9);
        EXPECT_LT(state.angular_velocity.norm(), 1e-9);
    }
}

TEST(PolygonTow, WorkOfTheTowIsAccountedFor) {
    Scenario scenario = channel();
    scenario.shapes.kind = ShapeKind::voronoi;
    scenario.analysis.steady_start = 4;
    const Arrangement floes = make_arrangement(scenario, 1, 2);
    Simulation tow(scenario, floes);
    while (tow.time() < 7) tow.step();
    const WorkShares shares = tow.work();
    double mean = 0;
    const int first = scenario.first_window_step();
    for (std::size_t k = static_cast<std::size_t>(first); k < tow.loads().surge.size(); ++k)
        mean += tow.loads().surge[k] / static_cast<double>(tow.loads().surge.size() - static_cast<std::size_t>(first));
    EXPECT_GT(mean, 1);
    EXPECT_LT(std::abs(shares.rest), 0.15 * mean);
}

}  // namespace polygons_test
}  // namespace floes
