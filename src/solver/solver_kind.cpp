#include "solver/solver_kind.hpp"

#include <array>

namespace floes {
constexpr std::string_view solver_key = "general.solver";

std::vector<Refusal> refused_contacts(SolverKind solver, const ContactLaw& law) {
    std::vector<Refusal> refused;
    const auto refuse_if = [&](bool holds, const Refusal& refusal) {
        if (holds) refused.push_back(refusal);
    };
    const bool stock = solver == SolverKind::stock;
    const bool direct = solver == SolverKind::direct;
    refuse_if(law.ice_ice_friction == 0 && law.ice_structure_friction > 0,
              {"contact.ice_ice_friction", "contact.ice_structure_friction",
               "friction is a product of two materials, and without that of ice on ice there is none",
               "a small one such as contact.ice_ice_friction = 1e-6"});
    refuse_if(stock && law.friction == Friction::cone,
              {"contact.friction", solver_key, "Bullet's own solver bounds friction by a square",
               "general.solver = \"lanes\", or contact.preset = \"paper\""});
    for (const auto& [effect, key] : {std::pair(law.slip.ice_ice, "contact.ice_ice_friction_law"),
                                      std::pair(law.slip.ice_structure, "contact.ice_structure_friction_law")})
        refuse_if(stock && effect != SlipEffect::constant,
                  {key, solver_key, "Bullet's own solver has one coefficient of friction for every speed",
                   "general.solver = \"lanes\", or the law \"constant\""});
    refuse_if(stock && law.normal == NormalLaw::crushing,
              {"contact.law", solver_key, "Bullet's own solver has no contacts that crush",
               "general.solver = \"lanes\", or contact.law = \"rigid\""});
    refuse_if(stock && !law.internal_edges,
              {"paper.internal_edges", solver_key, "Bullet's own solver does not know which faces lie inside a floe",
               "general.solver = \"lanes\", or paper.internal_edges = true"});
    refuse_if(direct && law.friction != Friction::cone,
              {"contact.friction", solver_key, "the direct solver has friction in the whole contact plane only",
               "contact.friction = \"cone\", or general.solver = \"lanes\" with joint.model = \"cfm\""});
    refuse_if(direct && law.normal == NormalLaw::rigid && law.split_impulse,
              {"paper.split_impulse_depth_m", solver_key,
               "the direct solver opens every penetration of rigid contacts within the impulse",
               "paper.split_impulse_depth_m = inf"});
    return refused;
}

std::optional<Refusal> refusal_of(SolverKind solver, Feature feature) {
    struct Need {
        SolverKind least;  // those after it can do it, too
        Refusal refusal;
    };
    constexpr std::string_view no_planes = "Bullet's own solver has no bed and no walls for ice to lie against";
    constexpr std::array<Need, 6> needs{{
        {SolverKind::direct,
         {"joint.model", solver_key, "joints as stiff as ice do not converge in sweeps",
          "general.solver = \"direct\", or joint.model = \"cfm\""}},
        {SolverKind::direct,
         {"water.added_mass_from", solver_key, "sweeps over single elements have one mass for every direction",
          "general.solver = \"direct\", or water.added_mass_from = \"share\""}},
        {SolverKind::direct,
         {"joint.failure", solver_key, "what a crack takes off a joint's stiffness goes into an exact solve",
          "general.solver = \"direct\", or joint.failure = \"moment\""}},
        {SolverKind::lanes, {"water.depth_m", solver_key, no_planes, "general.solver = \"direct\""}},
        {SolverKind::lanes, {"field.sides", solver_key, no_planes, "general.solver = \"direct\""}},
        {SolverKind::lanes,
         {"field.wake_radius_m", solver_key, "Bullet's own solver lets no floes rest",
          "general.solver = \"lanes\", or field.wake_radius_m = 0"}},
    }};
    const auto& [least, refusal] = needs.at(static_cast<std::size_t>(feature));
    return solver < least ? std::optional(refusal) : std::nullopt;
}

}  // namespace floes
