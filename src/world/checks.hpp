#pragma once
// What a World refuses: each function throws InputError with the value and its range. Only for files inside this
// module.

#include <cstddef>
#include <span>

#include "shapes/convex_solid.hpp"
#include "solver/carried_water.hpp"
#include "world/definitions.hpp"

namespace floes {

/// With the contact law: what the solver that the definition names refuses (solver/solver_kind.hpp).
void check(const WorldDefinition& definition);
void check(const ElementDefinition& element);
void check(const FixedBoxDefinition& box);
void check(const SlidingBoxDefinition& box);
void check(const JointDefinition& joint, std::size_t bodies, SolverKind solver);
void check(const CarriedWater& water, SolverKind solver);
void check_sleep(SolverKind solver);
void check_softening(double sound, SolverKind solver);
void check_structure(std::span<const ConvexSolid> solids, bool present);

}  // namespace floes
