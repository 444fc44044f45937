#include "world/piece_dispatcher.hpp"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

namespace floes {

namespace {

// Bullet's own collision groups take the lowest bits of the broad phase's group; the piece goes above them.
constexpr int group_bits = 6;
constexpr int group_mask = (1 << group_bits) - 1;

bool same_piece(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
    const int piece = a.m_collisionFilterGroup >> group_bits;
    return piece > 0 && piece == b.m_collisionFilterGroup >> group_bits;
}

/// Do the boxes, which the broad phase has blown up by gContactBreakingThreshold, leave a gap wider than `reach`?
bool apart(const btBroadphaseProxy& a, const btBroadphaseProxy& b, double reach) {
    const double overlap = 2 * gContactBreakingThreshold - reach;
    for (int axis = 0; axis < 3; ++axis) {
        if (a.m_aabbMax[axis] - b.m_aabbMin[axis] < overlap || b.m_aabbMax[axis] - a.m_aabbMin[axis] < overlap) {
            return true;
        }
    }
    return false;
}

}  // namespace

void assign_piece(btCollisionObject& object, int piece) {
    object.setUserIndex2(piece);
    int& group = object.getBroadphaseHandle()->m_collisionFilterGroup;
    group = (group & group_mask) | (piece + 1) << group_bits;
}

void PieceDispatcher::look_closer(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                                  const btDispatcherInfo& info) {
    const btBroadphaseProxy& a = *pair.m_pProxy0;
    const btBroadphaseProxy& b = *pair.m_pProxy1;
    if (same_piece(a, b)) return;
    // A pair that was close in the last step is processed once more, which removes its old contact points.
    const int close = apart(a, b, static_cast<PieceDispatcher&>(dispatcher).reach_) ? 0 : 1;
    if (close == 0 && pair.m_internalTmpValue == 0) return;
    pair.m_internalTmpValue = close;
    defaultNearCallback(pair, dispatcher, info);
}

}  // namespace floes
