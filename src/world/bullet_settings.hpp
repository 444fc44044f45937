#pragma once
// How Bullet's world is set up and taken down, and the piece of what does not touch its like. Only for files inside
// this module.

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include <limits>

#include "world/definitions.hpp"

namespace floes {

/// The piece of sliding boxes and the structure, which do not touch each other. Elements' pieces are numbers of
/// elements.
inline constexpr int sheet_piece = std::numeric_limits<int>::max();

/// Joints take their ERP and CFM from their own definition; of these only m_erp2 concerns contacts (m_erp is that of
/// joints without one). A penetration is corrected by m_erp2 in the velocity impulse, so that the contact force
/// contains the correction, unless split impulse is on and the penetration is deeper than the threshold.
inline void set_up(btContactSolverInfo& info, const WorldDefinition& definition) {
    info.m_numIterations = definition.iterations;
    info.m_erp2 = definition.contact.erp;
    info.m_splitImpulse = definition.contact.split_impulse ? 1 : 0;
    info.m_splitImpulsePenetrationThreshold = -definition.contact.split_impulse_depth;
    info.m_solverMode = SOLVER_USE_WARMSTARTING | SOLVER_SIMD;  // without the first, contact forces are not kept
}

/// Removes the overlapping pairs one by one. Bullet would search all of them for each body, in a time that grows as the
/// square of the number of bodies.
inline void remove_pairs(btBroadphaseInterface& broadphase, btDispatcher& dispatcher) {
    btOverlappingPairCache& pairs = *broadphase.getOverlappingPairCache();
    for (int left = pairs.getNumOverlappingPairs(); left > 0; left = pairs.getNumOverlappingPairs()) {
        const btBroadphasePair& last = pairs.getOverlappingPairArrayPtr()[left - 1];
        pairs.removeOverlappingPair(last.m_pProxy0, last.m_pProxy1, &dispatcher);
    }
}

}  // namespace floes
