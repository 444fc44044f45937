#pragma once
// Which bodies may collide: not those of one piece. Only for files inside this room.

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

namespace floes {

// Every body carries its BodyId and its piece in the two integers that Bullet leaves to its user.
inline int body_id_of(const btCollisionObject& object) {
    return object.getUserIndex();
}

inline bool same_piece(const btCollisionObject& a, const btCollisionObject& b) {
    return a.getUserIndex2() >= 0 && a.getUserIndex2() == b.getUserIndex2();
}

/// To be called once the body is in a world.
void assign_piece(btCollisionObject& object, int piece);

/// Asked again every step for every pair that the broad phase finds, so that a changed piece acts in the next step.
class PieceDispatcher final : public btCollisionDispatcher {
  public:
    using btCollisionDispatcher::btCollisionDispatcher;

    /// From now on pairs that cannot touch are skipped without loading their bodies: those of one piece, and those
    /// farther apart than a contact point persists. Saves memory traffic; other pairs are processed as before.
    void pass_over_distant_pairs() { setNearCallback(&PieceDispatcher::look_closer); }

    /// A body whose contact points live up to `threshold` apart, m (btCollisionShape::getContactBreakingThreshold).
    void allow_for(double threshold) { reach_ = btMax(reach_, 2 * threshold); }

    bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override {
        return !same_piece(*a, *b) && btCollisionDispatcher::needsCollision(a, b);
    }

  private:
    static void look_closer(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);

    double reach_ = 0;
};

}  // namespace floes
