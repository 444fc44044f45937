// Floes that differ, side by side in one world: each floats, heaves, bends and breaks by its own closed form.

#include <gtest/gtest.h>

#include <cmath>

#include "ice/ice_field.hpp"
#include "ice/joint_stress.hpp"
#include "simulation/simulation.hpp"

namespace floes {
namespace unlike_floes_test {

constexpr double sides[]{0.2, 0.3, 0.15};     // of elements, m
constexpr double thicknesses[]{0.033, 0.06};  // m

/// Three sizes by two thicknesses in still water, far apart, ahead of a structure that does not reach them.
struct Six {
    Scenario scenario;
    std::vector<SingleFloe> singles;
    FloeSet floes;

    Six() {
        scenario.water.flow = WaterFlow::still;
        scenario.structure.speed = 1e-6;
        scenario.analysis.steady_start = 0;
        scenario.analysis.window = 20;
        scenario.field.floes = 6;
        scenario.field.concentration = 0.02;  // a field as long as the row
        for (int i = 0; i < 6; ++i) {
            const double side = sides[i % 3];
            const FloeShape shape{(2 + i % 2) * side, 2 * side, thicknesses[i / 3], side};
            Material material = scenario.material();
            material.ice.density = 900 + 10 * i;
            material.ice.bending_strength = 30e3 + 5e3 * i;
            material.ice.elastic_modulus = 40e6 * (1 + i);
            singles.push_back({{7 + 1.5 * i, (i % 2) - 0.5, 0.4 * i}, shape, material});
        }
        floes = gathered(singles);
    }
};

TEST(UnlikeFloes, TakeTheirShapesFromOneTable) {
    Six six;
    EXPECT_EQ(six.floes.shapes.size(), 6u);
    six.singles.push_back({{20, 0, 0}, six.singles[2].shape, six.singles[4].material});
    six.floes = gathered(six.singles);
    EXPECT_EQ(six.floes.shapes.size(), 6u);
    EXPECT_EQ(six.floes.floes.back().shape, 2u);
    EXPECT_EQ(six.floes.floes.back().material, 4u);
    double area = 0;
    for (std::size_t i = 0; i < 7; ++i) area += six.floes.shape(i).length * six.floes.shape(i).breadth;
    EXPECT_NEAR(covered_area(six.floes), area, 1e-15);
    EXPECT_DOUBLE_EQ(largest_side(six.floes), 0.9);
    const IceLayout layout(six.floes);
    EXPECT_EQ(layout.elements.size(), 4u + 6 + 4 + 6 + 4 + 6 + 4);
    EXPECT_EQ(layout.joints.size(), 4u + 7 + 4 + 7 + 4 + 7 + 4);
    EXPECT_EQ(layout.elements[10].floe, 2);
    EXPECT_EQ(layout.elements[10].half_extents, Vec3(0.075, 0.0165, 0.075));
    EXPECT_EQ(layout.floe_of_joint(layout.joint(3, 6)), 3u);
}

// Draught T ρ_i / ρ_w, where it stays.
TEST(UnlikeFloes, FloatEachAtItsOwnDraught) {
    const Six six;
    Simulation simulation(six.scenario, six.floes);
    const std::vector<BodyState> before = simulation.element_states();
    ASSERT_TRUE(simulation.run({}));
    for (std::size_t i = 0; i < before.size(); ++i) {
        const auto floe = static_cast<std::size_t>(simulation.ice().elements()[i].floe);
        const double thickness = six.floes.shape(floe).thickness;
        const double draught = thickness * six.floes.material(floe).ice.density / 1000;
        EXPECT_NEAR(thickness / 2 - simulation.element_states()[i].position.y(), draught, 1e-9) << floe;
        EXPECT_LT((simulation.element_states()[i].position - before[i].position).norm(), 1e-9) << floe;
    }
}

// Undamped heave from 1 mm above rest: z = 1 mm cos(ω t), ω² = ρ_w g / (ρ_i T).
TEST(UnlikeFloes, HeaveEachAtItsOwnFrequency) {
    Six six;
    six.scenario.general.time_step = 0.001;
    six.scenario.water.heave_damping_from = six.scenario.water.added_mass_from = WaterFrom::share;
    six.scenario.water.heave_damping = six.scenario.water.heave_drag = six.scenario.water.skin_drag = 0;
    six.scenario.water.form_drag = 0;
    six.scenario.analysis.window = 2;
    SimulationState state = Simulation(six.scenario, six.floes).state();
    std::vector<double> rest;
    for (BodyState& element : state.elements) {
        rest.push_back(element.position.y());
        element.position.y() += 0.001;
    }
    Simulation simulation(six.scenario, six.floes, state);
    while (simulation.time() < 1) simulation.step();
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const auto floe = static_cast<std::size_t>(simulation.ice().elements()[i].floe);
        const double mass_per_area = six.floes.material(floe).ice.density * six.floes.shape(floe).thickness;
        const double omega = std::sqrt(1000 * 9.81 / mass_per_area);
        // Symplectic Euler starts half a step off in phase: 0.5 ω Δt of the amplitude at most.
        EXPECT_NEAR(simulation.element_states()[i].position.y() - rest[i], 0.001 * std::cos(omega * simulation.time()),
                    0.001 * 0.7 * omega * 0.001)
            << floe;
    }
}

/// Two elements of each shape in a row, without water or weight, beam joints.
struct Pairs {
    Scenario scenario;
    FloeSet floes;
    World world;
    IceField ice;

    Pairs()
        : scenario(physical()), floes(pairs(scenario)), world(scenario_world(scenario)), ice(world, scenario, floes) {}

    static Scenario physical() {
        Scenario scenario;
        scenario.general.gravity = 1e-9;
        scenario.general.solver = SolverKind::direct;
        scenario.joint.model = JointModel::beam;
        scenario.joint.damping_ratio = 1;
        scenario.joint.averaging =
            scenario.general.time_step;  // without weight a plate on water has no time of its own
        return scenario;
    }

    static FloeSet pairs(const Scenario& scenario) {
        std::vector<SingleFloe> made;
        for (int i = 0; i < 6; ++i) {
            const double side = sides[i % 3];
            Material material = scenario.material();
            material.ice.elastic_modulus = 40e6 * (1 + i);
            material.ice.bending_strength = 30e3 + 5e3 * i;
            made.push_back({{2.0 * i, 0, 0.3 * i}, {2 * side, side, thicknesses[i / 3], side}, material});
        }
        return gathered(made);
    }

    /// Steps with a moment in each joint, about its own z axis, N m.
    void bend(const std::vector<double>& moment, int steps) {
        for (int step = 0; step < steps; ++step) {
            for (std::size_t i = 0; i < floes.size(); ++i) {
                const BodyId a = ice.elements()[2 * i].body;
                const BodyId b = ice.elements()[2 * i + 1].body;
                const double level = moment[i] * std::min(1.0, (step + 1) / (0.5 * steps));
                const Vec3 about = world.state(a).rotation.col(2) * level;
                world.apply(a, {Vec3::Zero(), about});
                world.apply(b, {Vec3::Zero(), -about});
            }
            world.step();
            ice.break_joints(world, step);
        }
    }
};

// A couple M at both ends turns the two halves against each other by M / D, D = E T³ / (12 (1 - ν²)).
TEST(UnlikeFloes, BendEachByItsOwnRigidity) {
    Pairs pairs;
    std::vector<double> moment;
    for (std::size_t i = 0; i < 6; ++i)
        moment.push_back(0.5 * make_thresholds(pairs.floes.shape(i), pairs.floes.material(i)).bending);
    pairs.bend(moment, 2000);
    EXPECT_TRUE(pairs.ice.breaks().empty());
    for (std::size_t i = 0; i < 6; ++i) {
        const double thickness = pairs.floes.shape(i).thickness;
        const double rigidity = pairs.floes.material(i).ice.elastic_modulus * std::pow(thickness, 3) / (12 * 0.91);
        const Vec3 x = pairs.world.state(pairs.ice.elements()[2 * i].body).rotation.col(0);
        const Vec3 other = pairs.world.state(pairs.ice.elements()[2 * i + 1].body).rotation.col(0);
        EXPECT_NEAR(x.cross(other).norm(), moment[i] / rigidity, 0.01 * moment[i] / rigidity) << i;
    }
}

// ε = L T² σ_b / 6 of each: at 0.98 and 1.02 of it every other one breaks.
TEST(UnlikeFloes, BreakEachAtItsOwnStrength) {
    Pairs pairs;
    std::vector<double> moment;
    for (std::size_t i = 0; i < 6; ++i) {
        const FloeShape& shape = pairs.floes.shape(i);
        const double threshold =
            shape.element * shape.thickness * shape.thickness / 6 * (30e3 + 5e3 * static_cast<double>(i));
        moment.push_back((i % 2 == 0 ? 0.98 : 1.02) * threshold);
    }
    pairs.bend(moment, 2000);
    ASSERT_EQ(pairs.ice.breaks().size(), 3u);
    std::vector<int> broken;
    for (const BreakEvent& event : pairs.ice.breaks()) broken.push_back(event.floe);
    std::ranges::sort(broken);
    EXPECT_EQ(broken, (std::vector<int>{1, 3, 5}));
    EXPECT_EQ(pairs.ice.failure_ratio(), 0.5);
}

}  // namespace unlike_floes_test
}  // namespace floes
