#include "ice/scenario_world.hpp"

#include "core/error.hpp"

namespace floes {
namespace {

ConstraintSolver world_solver(SolverKind kind) {
    switch (kind) {
        case SolverKind::stock:
            return ConstraintSolver::stock;
        case SolverKind::lanes:
            return ConstraintSolver::lanes;
        case SolverKind::direct:
            return ConstraintSolver::direct;
    }
    throw InputError("The scenario asks for a solver that the world does not have.");
}

}  // namespace

double size_of_ice(const Scenario& scenario) {
    constexpr double tank = 0.033;  // m
    return scenario.floe.thickness / tank;
}

World scenario_world(const Scenario& scenario) {
    const General& general = scenario.general;
    return World({.time_step = general.time_step,
                  .iterations = general.iterations,
                  .gravity = general.gravity / (1 + scenario.water.added_mass),  // the added mass has no weight
                  .contact = scenario.contact_law(),
                  .solver = world_solver(general.solver),
                  .length_unit = size_of_ice(scenario)});
}

}  // namespace floes
