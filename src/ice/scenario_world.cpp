#include "ice/scenario_world.hpp"

namespace floes {

double size_of_ice(const Scenario& scenario) {
    constexpr double tank = 0.033;  // m
    return scenario.floe.thickness / tank;
}

World scenario_world(const Scenario& scenario) {
    const General& general = scenario.general;
    return World({.time_step = general.time_step,
                  .iterations = general.iterations,
                  .tolerance = general.tolerance,
                  .gravity = general.gravity / (1 + scenario.water.isotropic_mass()),  // the added mass has no weight
                  .contact = scenario.contact_law(),
                  .solver = general.solver,
                  .length_unit = size_of_ice(scenario)});
}

}  // namespace floes
