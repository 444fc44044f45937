#pragma once
// The solvers of a World, and what they refuse: one list for the check of a scenario's keys and for the World's own.

#include <optional>
#include <string_view>
#include <vector>

#include "solver/contact_law.hpp"

namespace floes {

enum class SolverKind {
    stock,  ///< Bullet's sequential impulses: projected Gauss-Seidel, joints before contacts in each sweep
    lanes,  ///< the same sweeps, many floes side by side (solver/lane_system.hpp)
    direct  ///< joints solved exactly, contacts in sweeps (solver/direct_floes.hpp)
};

/// Two values that cannot stand together. Keys are those of a scenario (scenario/keys.hpp).
struct Refusal {
    std::string_view key;      ///< of the value that is refused
    std::string_view with;     ///< key of the value that refuses it
    std::string_view reason;   ///< a clause
    std::string_view instead;  ///< keys with values that can stand
};

/// What of a contact law the solver cannot do; empty where it can do all.
std::vector<Refusal> refused_contacts(SolverKind solver, const ContactLaw& law);

/// What not every solver can do: joints that are springs, bodies that carry water, joints that soften as they crack, a
/// sea bed, walls, bodies that sleep.
enum class Feature { springs, carried_water, cracks, bed, walls, sleep };

/// Whether it refuses that.
std::optional<Refusal> refusal_of(SolverKind solver, Feature feature);

/// Whether the state of its World can be saved and set again: Bullet keeps much of its own to itself.
constexpr bool saves_state(SolverKind solver) {
    return solver != SolverKind::stock;
}

}  // namespace floes
