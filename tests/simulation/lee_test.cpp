// Form drag on ice in the lee of other ice, by closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "ice/ice_field.hpp"
#include "simulation/simulation.hpp"

namespace floes {
namespace lee_test {

constexpr double side = 0.6;
constexpr double draught = 0.93 * 0.033;
constexpr double speed = 0.1;
constexpr double on_skin = 0.5 * 1000 * 0.009 * side * side * speed * speed;  // of a floe, N
constexpr double on_face = 0.5 * 1000 * 1.0 * side * draught * speed * speed;

/// S_c² across a gap, m.
double let_through(double gap) {
    return 1 - std::exp(-gap / (5.56 * draught));
}

/// Floes of the tank in water at rest, far from the structure and from everything else. The mass of an element is that
/// of its ice, so that its change of speed in a step is the force.
Scenario still_water(int floes) {
    Scenario scenario;
    scenario.field.floes = floes;
    scenario.field.concentration = 1e-5;
    scenario.field.half_width = 100;
    scenario.field.sides = FieldSides::open;
    scenario.field.far_end = FarEnd::open;
    scenario.structure.speed = 1e-9;
    scenario.water.flow = WaterFlow::still;
    scenario.water.added_mass_from = WaterFrom::share;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 1000;
    return scenario;
}

/// Mass of every element, kg.
std::vector<double> masses(const Simulation& simulation, const FloeSet& floes) {
    std::vector<double> all;
    for (const IceElement& element : simulation.ice().elements()) {
        const auto floe = static_cast<std::size_t>(element.floe);
        all.push_back(floes.shape(floe).element_mass(floes.material(floe).ice, simulation.ice().cut_element(element)));
    }
    return all;
}

struct Moving {
    Scenario scenario;
    FloeSet floes;
    SimulationState state;

    /// All at this velocity along x and z, m/s.
    Moving(Scenario of, FloeSet set, const Vec2& velocity = {speed, 0})
        : scenario(std::move(of)), floes(std::move(set)), state(Simulation(scenario, floes).state()) {
        for (BodyState& one : state.elements) one.velocity = {velocity.x(), 0, velocity.y()};
    }

    BodyState& element(int floe, int index) {
        return state.elements[static_cast<std::size_t>(Simulation(scenario, floes).ice().first_element(floe) + index)];
    }

    /// Force on each floe in the next step, N.
    std::vector<Vec3> forces() const {
        Simulation simulation(scenario, floes, state);
        const std::vector<double> mass = masses(simulation, floes);
        simulation.step();
        std::vector<Vec3> found(floes.size(), Vec3::Zero());
        for (std::size_t i = 0; i < mass.size(); ++i) {
            const Vec3 change = simulation.element_states()[i].velocity - state.elements[i].velocity;
            found[static_cast<std::size_t>(simulation.ice().elements()[i].floe)] +=
                mass[i] * change / scenario.general.time_step;
        }
        return found;
    }

    double drag() const {
        double sum = 0;
        for (const Vec3& force : forces()) sum -= force.x();
        return sum;
    }
};

/// One behind the other along x.
std::vector<PlanarPose> row(int floes, double gap) {
    std::vector<PlanarPose> poses;
    for (int i = 0; i < floes; ++i) poses.push_back({20 + i * (side + gap), 0, 0});
    return poses;
}

/// Cut into squares, or into cells.
class LeeOf : public ::testing::TestWithParam<int> {
  protected:
    static Scenario water_with(int floes) {
        Scenario scenario = still_water(floes);
        scenario.floe.pattern = GetParam();
        return scenario;
    }
    static double drag_on_row(int floes, double gap) {
        const Scenario scenario = water_with(floes);
        return Moving(scenario, floes_at(scenario, row(floes, gap))).drag();
    }
};

TEST_P(LeeOf, NoOtherIceChangesNoBit) {
    Scenario scenario = water_with(1);
    const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{20, 0, 0.3}});
    const Moving moving(scenario, floes);
    EXPECT_NEAR(moving.drag(), on_skin + on_face * (std::pow(std::cos(0.3), 3) + std::pow(std::sin(0.3), 3)), 1e-6);
    Simulation sheltered(scenario, floes, moving.state);
    scenario.water.shelter_draughts = 0;
    Simulation open(scenario, floes, moving.state);
    for (int step = 0; step < 20; ++step) {
        sheltered.step();
        open.step();
    }
    for (std::size_t i = 0; i < moving.state.elements.size(); ++i) {
        EXPECT_EQ(sheltered.element_states()[i].velocity, open.element_states()[i].velocity);
        EXPECT_EQ(sheltered.element_states()[i].angular_velocity, open.element_states()[i].angular_velocity);
    }
}

TEST_P(LeeOf, ARowOfFloesThatTouchBearsSkinDragAndThatOfOneFace) {
    EXPECT_NEAR(drag_on_row(12, 0), 12 * on_skin + on_face, 1e-3 * on_face);
    EXPECT_NEAR(12 * on_skin + on_face, 0.29, 0.005);
    EXPECT_NEAR(12 * on_skin + 12 * on_face, 1.30, 0.005);  // without shelter
}

TEST_P(LeeOf, ARowWithGapsFollowsTheLaw) {
    for (const double draughts : {0.1, 1.0, 5.0, 20.0}) {
        const double expected = 4 * on_skin + (1 + 3 * let_through(draughts * draught)) * on_face;
        EXPECT_NEAR(drag_on_row(4, draughts * draught), expected, 1e-3 * on_face) << draughts;
    }
    EXPECT_NEAR(drag_on_row(4, 26 * draught), 4 * on_skin + 4 * on_face, 1e-3 * on_face);
}

// All columns of a pack but the first are in the lee, of each part of the flow by itself.
TEST_P(LeeOf, APackBearsItsSkinDragAndThatOfItsRim) {
    constexpr double gap = 0.03;
    const Scenario scenario = water_with(25);
    std::vector<PlanarPose> poses;
    for (int i = 0; i < 25; ++i) poses.push_back({20 + (i % 5) * (side + gap), (i / 5) * (side + gap), 0});
    for (const double angle : {0.0, std::numbers::pi / 6}) {
        const Vec2 along(std::cos(angle), std::sin(angle));
        Vec3 force = Vec3::Zero();
        for (const Vec3& one : Moving(scenario, floes_at(scenario, poses), speed * along).forces()) force -= one;
        const double faces = 5 * (1 + 4 * let_through(gap)) * on_face;
        EXPECT_NEAR(force.x(), 25 * on_skin * along.x() + faces * along.x() * along.x(), 1e-3 * faces);
        EXPECT_NEAR(force.z(), 25 * on_skin * along.y() + faces * along.y() * along.y(), 1e-3 * faces);
    }
}

INSTANTIATE_TEST_SUITE_P(Elements, LeeOf, ::testing::Values(static_cast<int>(FloeShape::squares), 0));

// Two hexagons, an edge of each facing the other. Edges at 60° to it look past the one ahead.
TEST(Lee, OfPolygonsIsThatOfTheEdgeThatFacesThem) {
    const Scenario scenario = still_water(2);
    const double apothem = 0.3;
    Outline hexagon;
    for (int k = 0; k < 6; ++k) {
        const double angle = (2 * k - 1) * std::numbers::pi / 6;
        hexagon.push_back({apothem / std::cos(std::numbers::pi / 6) * std::cos(angle),
                           apothem / std::cos(std::numbers::pi / 6) * std::sin(angle)});
    }
    constexpr double gap = 0.05;
    FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{20, 0, 0}, {20 + 2 * apothem + gap, 0, 0}});
    floes.shapes.front().outline = hexagon;
    const double edge = 2 * apothem * std::tan(std::numbers::pi / 6);
    const double face = 0.5 * 1000 * edge * draught * speed * speed;
    const double skin = 0.5 * 1000 * 0.009 * area_of(hexagon) * speed * speed;
    const double oblique = 2 * std::pow(std::cos(std::numbers::pi / 3), 3);
    const std::vector<Vec3> forces = Moving(scenario, floes).forces();
    EXPECT_NEAR(-forces[0].x(), skin + (let_through(gap) + oblique) * face, 1e-3 * face);
    EXPECT_NEAR(-forces[1].x(), skin + (1 + oblique) * face, 1e-3 * face);
}

// Water in the lee moves with the ice ahead: that of ice at rest in still water is still.
TEST(Lee, IsSeenFromTheIceAhead) {
    constexpr double gap = 0.05;
    const Scenario scenario = still_water(2);
    Moving moving(scenario, floes_at(scenario, row(2, gap)));
    const double calm = 1 - std::sqrt(let_through(gap));
    for (const double slower : {1.0, 0.5, 0.0}) {
        for (int i = 0; i < 9; ++i) moving.element(1, i).velocity.x() = slower * speed;
        const double meets = 1 - calm * slower;
        EXPECT_NEAR(-moving.forces()[0].x(), on_skin + meets * meets * on_face, 1e-3 * on_face) << slower;
    }
}

TEST(Lee, OfThinnerIceReachesAsDeepAsThat) {
    constexpr double gap = 0.05;
    const Scenario scenario = still_water(2);
    FloeSet floes = floes_at(scenario, row(2, gap));
    floes.shapes.push_back(floes.shapes.front());
    floes.shapes.back().thickness *= 0.5;
    floes.floes[1].shape = 1;
    EXPECT_NEAR(-Moving(scenario, floes).forces()[0].x(),
                on_skin + (1 - 0.5 * std::exp(-gap / (5.56 * draught))) * on_face, 1e-3 * on_face);
}

TEST(Lee, IsNoneBehindIceThatLiesOnOtherIce) {
    const Scenario scenario = still_water(2);
    Moving moving(scenario, floes_at(scenario, row(2, 0.05)));
    for (int i = 0; i < 9; ++i) moving.element(1, i).position.y() += 1.1 * draught;
    EXPECT_NEAR(-moving.forces()[0].x(), on_skin + on_face, 1e-3 * on_face);
}

// The faces of an open crack shelter each other, whether it was there before or opens between two looks.
TEST(Lee, IsOnBothSidesOfACrack) {
    Scenario scenario = still_water(1);
    const FloeSet floes = floes_at(scenario, row(1, 0));
    Moving moving(scenario, floes);
    const CutFloe cut = floes.shapes.front().cut();
    for (std::size_t k = 0; k < cut.joints.size(); ++k)
        if (cut.joints[k].normal.x > 0.5) moving.state.breaks.push_back({0, 0, static_cast<std::int32_t>(k)});
    ASSERT_EQ(moving.state.breaks.size(), 6u);
    EXPECT_NEAR(moving.drag(), on_skin + on_face, 1e-3 * on_face);
}

TEST(Lee, IsOnBothSidesOfACrackAtOnce) {
    Scenario scenario = still_water(1);
    scenario.joint.failure = JointFailure::moment;
    scenario.ice.bending_strength = 1;
    const FloeSet floes = floes_at(scenario, row(1, 0));
    Moving moving(scenario, floes);
    moving.state.steps = 1;
    for (int i = 0; i < 9; ++i) moving.element(0, i).velocity.y() = i % 3 == 1 ? 1e-3 : 0;
    Simulation simulation(scenario, floes, moving.state);
    simulation.step();
    ASSERT_EQ(simulation.ice().live_joints(), 0);
    const std::vector<double> mass = masses(simulation, floes);
    const auto along = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < mass.size(); ++i) sum += mass[i] * simulation.element_states()[i].velocity.x();
        return sum;
    };
    const double before = along();
    simulation.step();
    EXPECT_NEAR((before - along()) / scenario.general.time_step, on_skin + on_face, 0.01 * on_face);
}

// A floe at rest in the current that comes from the sheet at the far end.
TEST(Lee, IsThatOfAnIceSheetToo) {
    constexpr double gap = 0.05;
    Scenario scenario = still_water(1);
    scenario.field.far_end = FarEnd::ice_sheet;
    scenario.field.half_width = 2;
    scenario.field.concentration = 0.09;
    scenario.water.current = speed;
    scenario.water.current_direction = std::numbers::pi;
    const double end = scenario.field_end();
    const Moving at_rest(scenario, floes_at(scenario, std::vector<PlanarPose>{{end - gap - 0.5 * side, 0, 0}}), {0, 0});
    EXPECT_NEAR(at_rest.drag(), on_skin + let_through(gap) * on_face, 1e-3 * on_face);
}

// ρ_a C_a U² N l b = ½ ρ_w (C_s N l b + C_d b d) u²: a pack drifts nearly at U √(ρ_a C_a / (½ ρ_w C_s)), 2.0 % of the
// wind; a floe of the tank by itself at 0.8 %.
TEST(Lee, LetsAPackDriftInTheWind) {
    constexpr double wind = 5;
    for (const auto& [floes, share] : {std::pair{1, 0.8}, std::pair{12, 1.7}, std::pair{40, 1.9}}) {
        Scenario scenario = still_water(floes);
        scenario.wind.speed = wind;
        const double driven = 1.25 * 1.5e-3 * wind * wind * floes * side * side;
        const double drift = speed * std::sqrt(driven / (floes * on_skin + on_face));
        EXPECT_NEAR(drift, share / 100 * wind, 0.05 * drift);
        EXPECT_NEAR(Moving(scenario, floes_at(scenario, row(floes, 0)), {drift, 0}).drag(), 0, 1e-4 * driven);
    }
}

// Twelve floes that a current presses against a wall bear on it with their skin drag and that of one face.
TEST(Lee, IsThatOfARowAgainstAWall) {
    Scenario scenario = still_water(12);
    HullSizes sizes;
    sizes.length = 2;
    sizes.beam = 2;
    sizes.draught = 0.3;
    sizes.freeboard = 0.3;
    sizes.stem = sizes.flare = std::numbers::pi / 2;
    scenario.structure.shape = Shape(HullKind::barge, sizes);
    scenario.structure.start = 20 - 0.5 * side - 1.0005;
    scenario.water.current = speed;
    scenario.water.current_direction = std::numbers::pi;
    Simulation simulation(scenario, floes_at(scenario, row(12, 0)));
    double load = 0;
    int steps = 0;
    while (simulation.time() < 30) {
        simulation.step();
        if (simulation.time() < 15) continue;
        load += simulation.loads().surge.back();
        ++steps;
    }
    EXPECT_NEAR(load / steps, 12 * on_skin + on_face, 0.03 * (12 * on_skin + on_face));
}

}  // namespace lee_test
}  // namespace floes
