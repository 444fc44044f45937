#pragma once
// Which bodies may collide in the stock solver's world: not those of one piece. Only for files inside this module.

#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <LinearMath/btPoolAllocator.h>

namespace floes {

// Every body carries its BodyId and its piece in the two integers that Bullet leaves to its user.
inline int body_id_of(const btCollisionObject& object) {
    return object.getUserIndex();
}

inline bool same_piece(const btCollisionObject& a, const btCollisionObject& b) {
    return a.getUserIndex2() >= 0 && a.getUserIndex2() == b.getUserIndex2();
}

/// Asked again every step for every pair that the broad phase finds, so that a changed piece acts in the next step.
class PieceDispatcher final : public btCollisionDispatcher {
  public:
    /// The list of manifolds is as long as their pool from the beginning, so that steps take no memory.
    explicit PieceDispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
        m_manifoldsPtr.reserve(configuration->getPersistentManifoldPool()->getMaxCount());
    }

    bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override {
        return !same_piece(*a, *b) && btCollisionDispatcher::needsCollision(a, b);
    }
};

}  // namespace floes
