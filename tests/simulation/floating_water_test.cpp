// The water on whole floes, by closed form: how they heave, pitch, ring down and rise.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulation/simulation.hpp"
#include "water/floating_plate.hpp"

namespace floes {
namespace floating_water_test {

constexpr double rho_g = 9810;
constexpr double area = 0.36;

/// One floe of the tank, stiff, far from everything, in water at rest; the tow stands still.
Scenario lone_floe() {
    Scenario scenario;
    scenario.general.time_step = 0.002;
    scenario.ice.elastic_modulus = 2e9;
    scenario.ice.bending_strength = scenario.ice.compressive_strength = scenario.ice.shear_strength = 1e8;
    scenario.field.floes = 1;
    scenario.field.concentration = 0.05;
    scenario.structure.speed = 1e-9;
    scenario.water.flow = WaterFlow::still;
    scenario.water.heave_drag = scenario.water.skin_drag = scenario.water.form_drag = 0;
    scenario.analysis.steady_start = 0;
    scenario.analysis.window = 8;
    return scenario;
}

/// A run that begins with the floe lifted by `lift` m and turned by `angle` rad about its own z.
Simulation released(const Scenario& scenario, double lift, double angle) {
    const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{7, 0, 0.4}});
    SimulationState state = Simulation(scenario, floes).state();
    const Vec3 middle = state.elements[4].position;
    const Mat3 frame = state.elements[4].rotation;
    const Mat3 turn = Eigen::AngleAxisd(angle, frame.col(2)).toRotationMatrix();
    for (BodyState& element : state.elements) {
        element.position = middle + turn * (element.position - middle) + Vec3(0, lift, 0);
        element.rotation = turn * element.rotation;
    }
    return Simulation(scenario, floes, state);
}

double tilt(const BodyState& element) {
    return element.rotation(1, 0) / std::hypot(element.rotation(0, 0), element.rotation(2, 0));
}

/// x'' + 2 g x' + w² x = 0 from x = 1 at rest.
double ringing(double w, double g, double t) {
    const double damped = std::sqrt(w * w - g * g);
    return std::exp(-g * t) * (std::cos(damped * t) + g / damped * std::sin(damped * t));
}

double ice_mass(const Scenario& scenario) {
    return area * scenario.floe.thickness * scenario.ice.density;
}

PlateWater plate_of(const Scenario& scenario) {
    return plate_water(1, scenario.floe.thickness * scenario.ice.density / scenario.water.density / 0.6);
}

TEST(FloatingWater, LetsAFloeHeaveAndRingDownAsAPlateThatMakesWaves) {
    const Scenario scenario = lone_floe();
    const PlateWater plate = plate_of(scenario);
    const double added = plate.added_mass * 1000 * 0.216;
    const double mass = ice_mass(scenario) + added;
    const double damping = plate.damping * std::sqrt(9.81 / 0.6) * added;
    Simulation simulation = released(scenario, 0.002, 0);
    Simulation rest = released(scenario, 0, 0);
    const double level = rest.element_states()[4].position.y();
    while (simulation.time() < 3) {
        simulation.step();
        const double expected =
            0.002 * ringing(std::sqrt(rho_g * area / mass), damping / (2 * mass), simulation.time());
        ASSERT_NEAR(simulation.element_states()[4].position.y() - level, expected, 0.02 * 0.002) << simulation.time();
    }
}

TEST(FloatingWater, LetsAFloePitchAtThePeriodOfAPlate) {
    Scenario scenario = lone_floe();
    const PlateWater plate = plate_of(scenario);
    const double gyration = plate.gyration_across * area;
    const double added = plate.added_mass * 1000 * 0.216 * gyration;
    const double inertia = ice_mass(scenario) * (area + 0.033 * 0.033) / 12 + added;
    // Of the ring-down the damping has the distribution of the added mass within elements only on average.
    const double damping = plate.damping * std::sqrt(9.81 / 0.6) * added;
    // The metacentre: ρ g L⁴/12, less what the centre of buoyancy lies below that of mass.
    const double draught = 0.93 * 0.033;
    const double stiffness = rho_g * area * area / 12 - ice_mass(scenario) * 9.81 * 0.5 * (0.033 - draught);
    Simulation simulation = released(scenario, 0, 0.003);
    const double w = std::sqrt(stiffness / inertia);
    std::vector<double> crossings;
    double before = 1;
    while (simulation.time() < 2) {
        simulation.step();
        const double now = tilt(simulation.element_states()[4]);
        if (before * now < 0) crossings.push_back(simulation.time());
        before = now;
    }
    ASSERT_GE(crossings.size(), 3U);
    const double damped = std::sqrt(w * w - std::pow(damping / (2 * inertia), 2));
    EXPECT_NEAR(crossings[2] - crossings[0], 2 * std::acos(-1.0) / damped, 0.02 * 2 * std::acos(-1.0) / damped);
}

// Deep under water no waves are made: a floe rises at √(2 (1 - ρ_i/ρ_w) g T / C_h), 0.213 m/s.
TEST(FloatingWater, LetsAFloeRiseAtTheSpeedOfItsDrag) {
    Scenario scenario = lone_floe();
    scenario.general.time_step = 0.01;
    scenario.water.heave_drag = 1;
    Simulation simulation = released(scenario, -1.3, 0);
    while (simulation.time() < 5) simulation.step();
    EXPECT_NEAR(simulation.element_states()[4].velocity.y(), std::sqrt(2 * 0.07 * 9.81 * 0.033), 0.003);
}

// The force that holds a floe down where it makes no waves is that of its buoyancy alone.
TEST(FloatingWater, DampsNoFloeThatIsCovered) {
    Scenario scenario = lone_floe();
    const double mass = ice_mass(scenario);
    const double added = plate_of(scenario).added_mass * 1000 * 0.216;
    Simulation simulation = released(scenario, -0.5, 0);
    while (simulation.time() < 0.2) simulation.step();
    const double expected = (1000.0 / 930 - 1) * mass * 9.81 / (mass + added) * simulation.time();
    EXPECT_NEAR(simulation.element_states()[4].velocity.y(), expected, 0.01 * expected);
}

// Broken loose, an element has its own water at once.
TEST(FloatingWater, IsSharedOutAnewAmongPieces) {
    Scenario scenario = lone_floe();
    const FloeSet floes = floes_at(scenario, std::vector<PlanarPose>{{7, 0, 0}});
    SimulationState state = Simulation(scenario, floes).state();
    for (BodyState& element : state.elements) element.position.y() -= 0.5;
    Simulation whole(scenario, floes, state);
    const int joints = whole.ice().live_joints();
    for (int joint = 0; joint < joints; ++joint) state.breaks.push_back({0, 0, joint, FailureMode::bending});
    Simulation pieces(scenario, floes, state);
    whole.step();
    pieces.step();
    const double mass = ice_mass(scenario) / 9;
    const double added = plate_water(1, 0.93 * 0.033 / 0.2).added_mass * 1000 * 0.008;
    const double expected = (1000.0 / 930 - 1) * mass * 9.81 / (mass + added) * 0.002;
    for (const BodyState& element : pieces.element_states()) EXPECT_NEAR(element.velocity.y(), expected, 1e-9);
    EXPECT_LT(whole.element_states()[4].velocity.y(), 0.7 * expected);
}

}  // namespace floating_water_test
}  // namespace floes
