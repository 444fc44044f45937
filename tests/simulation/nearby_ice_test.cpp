// How much ice lies round the structure and goes astern of it, by closed form: floes of known area at known places.

#include "simulation/nearby_ice.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "endless_tow.hpp"
#include "simulation/simulation.hpp"
#include "support/endless_scenario.hpp"

namespace floes {
namespace nearby_ice_test {

constexpr double side = 0.6;

/// A barge of 2 m by 1 m about x = 0 among floes of one element, with no ice sheets: its box goes from -1 to 2 m ahead
/// and 1.5 m aside, and holds 9 - 2 m² of water.
Scenario with_barge(int floes) {
    Scenario scenario;
    scenario.structure.shape = Shape(HullKind::barge, {.length = 2,
                                                       .beam = 1,
                                                       .draught = 0.4,
                                                       .freeboard = 0.2,
                                                       .stem = std::numbers::pi / 2,
                                                       .flare = std::numbers::pi / 2});
    scenario.structure.start = 0;
    scenario.structure.speed = 1e-9;
    scenario.floe.element = side;
    scenario.field.floes = floes;
    scenario.field.sides = FieldSides::open;
    scenario.field.far_end = FarEnd::open;
    scenario.water.flow = WaterFlow::still;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 1;
    return scenario;
}

double concentration(const Scenario& scenario, const std::vector<PlanarPose>& poses) {
    Simulation simulation(scenario, floes_at(scenario, poses));
    simulation.step();
    return simulation.loads().concentration.back();
}

TEST(Concentration, IsTheAreaInTheBoxOverTheWaterThere) {
    const std::vector<PlanarPose> poses{{1.6, 0, 0},                           // inside
                                        {2.0, 1.0, 0},                         // half of it
                                        {2.0, -1.5, 0.25 * std::numbers::pi},  // a quarter
                                        {2.4, 0.3, 0},                         // ahead of it
                                        {-1.4, 0, 0}};                         // astern of it
    EXPECT_NEAR(concentration(with_barge(5), poses), side * side * 1.75 / 7, 1e-6);
}

TEST(Concentration, IsOfTheWaterBetweenTheIceSheets) {
    Scenario scenario = with_barge(2);
    scenario.field.sides = FieldSides::ice_sheet;
    scenario.field.far_end = FarEnd::ice_sheet;
    scenario.field.half_width = 1.2;
    scenario.field.begin = 0;
    scenario.field.concentration = 2 * side * side / (2 * 1.2 * 1.95);  // so that it ends at 1.95 m
    EXPECT_NEAR(concentration(scenario, {{1.6, 0, 0}, {0.2, 0.85, 0}}), 2 * side * side / (2.4 * 2.95 - 2), 1e-6);
}

TEST(Concentration, IsOfTheWaterBetweenWallsThatTheHullIsWiderThan) {
    Scenario scenario = with_barge(1);
    scenario.field.sides = FieldSides::wall;
    scenario.field.half_width = 0.4;
    EXPECT_NEAR(concentration(scenario, {{1.6, 0, 0}}), side * side / (0.8 * 3 - 0.8 * 2), 1e-6);
}

// The same barge in two pieces, of which the upper one stands on the lower one at the waterline.
TEST(Concentration, CountsAWaterplaneOfTwoPiecesOnce) {
    Scenario scenario = with_barge(1);
    std::vector<std::vector<double>> rows;
    for (const double piece : {0.0, 1.0})
        for (const double height : {piece == 0 ? -0.4 : 0.2, 0.0})
            for (const double x : {-1.0, 1.0})
                for (const double z : {-0.5, 0.5}) rows.push_back({piece, 0, x, height, z});
    Shape& shape = scenario.structure.shape;
    shape.part_list() = "hull";
    shape.set_pieces(rows);
    shape.set_kind(HullKind::file);
    scenario.field.sides = FieldSides::wall;
    scenario.field.half_width = 0.4;
    EXPECT_NEAR(concentration(scenario, {{1.6, 0, 0}}), side * side / (0.8 * 3 - 0.8 * 2), 1e-6);
}

TEST(Concentration, IsOfABoxThatTurnsWithTheStructure) {
    Scenario scenario = with_barge(2);
    const double quarter = 0.5 * std::numbers::pi;  // the bow to port, -z
    scenario.path.table = {{.time = 0, .x = 0, .z = 0, .yaw = quarter}, {.time = 1, .x = 1e-9, .z = 0, .yaw = quarter}};
    EXPECT_NEAR(concentration(scenario, {{0, -1.6, 0}, {1.2, -1, 0}}), 2 * side * side / 7, 1e-6);
}

// A floe afloat, one that leans by 30 degrees, its middle 0.05 m below the water, and one that stands outside the box.
TEST(Pile, ReachesAsHighAndDeepAsTheIceInTheBox) {
    const Scenario scenario = with_barge(3);
    const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{1.6, 0, 0}, {1.6, 0.8, 0}, {3, 0, 0}});
    const double thickness = scenario.floe.thickness;
    const double draught = thickness * scenario.ice.density / scenario.water.density;
    Simulation afloat(scenario, floes);
    afloat.step();
    EXPECT_NEAR(afloat.loads().pile_height.back(), thickness - draught, 1e-6);
    EXPECT_NEAR(afloat.loads().pile_draught.back(), draught, 1e-6);
    SimulationState state = Simulation(scenario, floes).state();
    const auto lean = [&](std::size_t element, double height, double angle) {
        state.elements[element].position.y() = height;
        state.elements[element].rotation = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    };
    lean(1, -0.05, std::numbers::pi / 6);
    lean(2, 0, std::numbers::pi / 2);
    Simulation leaning(scenario, floes, state);
    leaning.step();
    const double reach = 0.5 * (side * 0.5 + thickness * std::numbers::sqrt3 / 2);
    EXPECT_NEAR(leaning.loads().pile_height.back(), reach - 0.05, 0.005) << "a step on, in which it turns";
    EXPECT_NEAR(leaning.loads().pile_draught.back(), reach + 0.05, 0.005);
}

TEST(Concentration, LeavesOutWhatLiesBelowTheIceAtTheSurface) {
    const Scenario scenario = with_barge(2);
    const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{1.6, 0, 0}, {1.6, 0.8, 0}});
    SimulationState state = Simulation(scenario, floes).state();
    state.elements[1].position = state.elements[0].position - Vec3{0, scenario.floe.thickness, 0};
    Simulation simulation(scenario, floes, state);
    simulation.step();
    EXPECT_NEAR(simulation.loads().concentration.back(), side * side / 7, 1e-6);
}

// The aft end of the waterline goes from -1 to 2 m, from 0 m in the window.
TEST(FallenAstern, CountsWhatTheStructurePassesInTheWindow) {
    Scenario scenario = with_barge(9);
    scenario.floe.element = 0.2;  // 9 of them, in three rows across the tow
    scenario.structure.speed = 1;
    scenario.analysis.steady_start = 1;
    scenario.analysis.window = 2;
    std::vector<PlanarPose> poses;
    for (const double x : {-0.5, 0.5, 1.5, 3.5})  // the first before the window, the last after it
        for (const double z : {-1.2, 1.2}) poses.push_back({x, z, 0});
    poses.push_back({2.1, 2.4, 0});  // a row of elements, and not the middle
    Simulation simulation(scenario, floes_at(scenario, poses));
    ASSERT_TRUE(simulation.run({}));
    EXPECT_EQ(simulation.fallen_astern().floes, 4);
    EXPECT_NEAR(simulation.fallen_astern().area, (4 + 1.0 / 3) * side * side, 1e-9);
}

// Floes that have left the field without end stay astern.
TEST(FallenAstern, CountsFloesThatHaveLeft) {
    const Scenario scenario = endless_scenario(20);
    Simulation simulation = tow(scenario);
    const double aft = scenario.structure.shape.waterline_radius();
    const auto ahead = [&] {
        std::vector<double> middle(static_cast<std::size_t>(simulation.ice().places()), 0.0);
        for (std::size_t i = 0; i < simulation.element_states().size(); ++i) {
            const IceElement& element = simulation.ice().elements()[i];
            middle[static_cast<std::size_t>(element.floe)] +=
                simulation.element_states()[i].position.x() / simulation.ice().elements(element.floe);
        }
        const double line = scenario.structure.start + scenario.structure.speed * simulation.time() - aft;
        int found = 0;
        for (int place = 0; place < simulation.ice().places(); ++place)
            found += simulation.ice().is_there(place) && middle[static_cast<std::size_t>(place)] >= line ? 1 : 0;
        return found;
    };
    int before = 0;
    ASSERT_TRUE(simulation.run({}, [&](const Simulation& run) {
        if (run.steps() == scenario.first_window_step()) before = run.ice().floes() - ahead();
    }));
    EXPECT_GT(simulation.ice().floes(), simulation.ice().places()) << "floes are to have left";
    EXPECT_EQ(simulation.fallen_astern().floes, simulation.ice().floes() - ahead() - before);
    EXPECT_NEAR(simulation.fallen_astern().area, simulation.fallen_astern().floes * side * side, 4 * side * side);
    EXPECT_GT(simulation.fallen_astern().floes, 20);
}

}  // namespace nearby_ice_test
}  // namespace floes
