#pragma once
// The force that contacts exert on a body. Only for files inside this room.

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <span>

#include "core/vector.hpp"

namespace floes {

/// Normal and friction force on `body` of all contacts in `manifolds` in the last solve, world axes, N; summed in the
/// given order. Needs SOLVER_USE_WARMSTARTING (else Bullet does not keep the impulses) and one friction direction.
Vec3 contact_load(std::span<btPersistentManifold* const> manifolds, const btCollisionObject* body, double time_step);

}  // namespace floes
