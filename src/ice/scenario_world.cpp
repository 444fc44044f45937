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
    }
    throw InputError("The scenario asks for a solver that the world does not have.");
}

}  // namespace

World scenario_world(const Scenario& scenario) {
    const General& general = scenario.general;
    const Contact& contact = scenario.contact;
    return World({.time_step = general.time_step,
                  .iterations = general.iterations,
                  .gravity = general.gravity / (1 + scenario.water.added_mass),  // the added mass has no weight
                  .contact_erp = contact.erp,
                  .split_impulse = contact.split_impulse,
                  .split_impulse_depth = contact.split_impulse_depth,
                  .solver = world_solver(general.solver)});
}

MaterialFriction scenario_friction(const Scenario& scenario) {
    return material_friction(scenario.contact.ice_ice_friction, scenario.contact.ice_structure_friction);
}

}  // namespace floes
