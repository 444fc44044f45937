#include "solver/solver_kind.hpp"

namespace floes {
constexpr std::string_view solver_key = "general.solver";

std::vector<Refusal> refused_contacts(SolverKind solver, const ContactLaw& law) {
    std::vector<Refusal> refused;
    if (law.ice_ice_friction == 0 && law.ice_structure_friction > 0) {
        refused.push_back({"contact.ice_ice_friction", "contact.ice_structure_friction",
                           "friction is a product of two materials, and without that of ice on ice there is none",
                           "a small one such as contact.ice_ice_friction = 1e-6"});
    }
    if (solver == SolverKind::stock && law.friction == Friction::cone) {
        refused.push_back({"contact.friction", solver_key, "Bullet's own solver bounds friction by a square",
                           "general.solver = \"lanes\", or contact.preset = \"paper\""});
    }
    if (solver == SolverKind::stock) {
        constexpr std::string_view reason = "Bullet's own solver has one coefficient of friction for every speed";
        constexpr std::string_view instead = "general.solver = \"lanes\", or the law \"constant\"";
        if (law.slip.ice_ice != SlipEffect::constant)
            refused.push_back({"contact.ice_ice_friction_law", solver_key, reason, instead});
        if (law.slip.ice_structure != SlipEffect::constant)
            refused.push_back({"contact.ice_structure_friction_law", solver_key, reason, instead});
    }
    if (solver == SolverKind::stock && law.normal == NormalLaw::crushing) {
        refused.push_back({"contact.law", solver_key, "Bullet's own solver has no contacts that crush",
                           "general.solver = \"lanes\", or contact.law = \"rigid\""});
    }
    if (solver == SolverKind::stock && !law.internal_edges) {
        refused.push_back({"paper.internal_edges", solver_key,
                           "Bullet's own solver does not know which faces lie inside a floe",
                           "general.solver = \"lanes\", or paper.internal_edges = true"});
    }
    if (solver == SolverKind::direct && law.friction != Friction::cone) {
        refused.push_back({"contact.friction", solver_key,
                           "the direct solver has friction in the whole contact plane only",
                           "contact.friction = \"cone\", or general.solver = \"lanes\" with joint.model = \"cfm\""});
    }
    if (solver == SolverKind::direct && law.normal == NormalLaw::rigid && law.split_impulse) {
        refused.push_back({"paper.split_impulse_depth_m", solver_key,
                           "the direct solver opens every penetration of rigid contacts within the impulse",
                           "paper.split_impulse_depth_m = inf"});
    }
    return refused;
}

std::optional<Refusal> refused_springs(SolverKind solver) {
    if (solver == SolverKind::direct) return std::nullopt;
    return Refusal{"joint.model", solver_key, "joints as stiff as ice do not converge in sweeps",
                   "general.solver = \"direct\", or joint.model = \"cfm\""};
}

std::optional<Refusal> refused_water(SolverKind solver) {
    if (solver == SolverKind::direct) return std::nullopt;
    return Refusal{"water.added_mass_from", solver_key, "sweeps over single elements have one mass for every direction",
                   "general.solver = \"direct\", or water.added_mass_from = \"share\""};
}

std::optional<Refusal> refused_planes(SolverKind solver, std::string_view key) {
    if (solver != SolverKind::stock) return std::nullopt;
    return Refusal{key, solver_key, "Bullet's own solver has no bed and no walls for ice to lie against",
                   "general.solver = \"direct\""};
}

std::optional<Refusal> refused_cracks(SolverKind solver) {
    if (solver == SolverKind::direct) return std::nullopt;
    return Refusal{"joint.failure", solver_key, "what a crack takes off a joint's stiffness goes into an exact solve",
                   "general.solver = \"direct\", or joint.failure = \"moment\""};
}

std::optional<Refusal> refused_sleep(SolverKind solver) {
    if (solver != SolverKind::stock) return std::nullopt;
    return Refusal{"field.wake_radius_m", solver_key, "Bullet's own solver lets no floes rest",
                   "general.solver = \"lanes\", or field.wake_radius_m = 0"};
}

}  // namespace floes
