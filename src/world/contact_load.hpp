#pragma once
// The forces at contacts. Only for files inside this module.

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <optional>
#include <span>
#include <vector>

#include "core/vector.hpp"
#include "solver/solver_contact.hpp"
#include "world/state.hpp"

namespace floes {

/// Normal and friction force on `body` of all contacts in `manifolds` in the last solve, world axes, N; summed in the
/// given order. Needs SOLVER_USE_WARMSTARTING (else Bullet does not keep the impulses) and one friction direction.
Vec3 contact_load(std::span<btPersistentManifold* const> manifolds, const btCollisionObject* body, double time_step);

/// Refills `found` with the contacts of `body`, or nullptr: of all, that exerted a force in the last solve, in the
/// given order; needs what contact_load() needs. Positions and forces in the units that the world computes in.
void read_contact_forces(std::span<btPersistentManifold* const> manifolds, const btCollisionObject* body,
                         double time_step, std::vector<ContactForce>& found);

/// The same of contacts as the lane solver leaves them.
Vec3 contact_load(std::span<const SolverContact> contacts, BodyId body, double time_step);
void read_contact_forces(std::span<const SolverContact> contacts, std::optional<BodyId> body, double time_step,
                         std::vector<ContactForce>& found);

}  // namespace floes
