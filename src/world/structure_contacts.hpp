#pragma once
// Contacts of boxes with the structure, from step to step: Bullet's GJK, for each of its solids and the boxes near
// that. Only for files inside this module.

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "collision/near_pairs.hpp"
#include "solver/body_motion.hpp"
#include "world/solid_shape.hpp"

namespace floes {

class StructureContacts {
  public:
    StructureContacts(btCollisionDispatcher& dispatcher, const btDispatcherInfo& info)
        : dispatcher_(&dispatcher), info_(&info) {
        manifolds_.reserve(1);
    }
    ~StructureContacts();
    StructureContacts(const StructureContacts&) = delete;
    StructureContacts& operator=(const StructureContacts&) = delete;

    /// The structure's solids, which stay.
    void set_solids(const btCompoundShape& structure);

    /// Bodies are numbered from 0. Boxes that move have a half extent; for others nothing is looked for. Lengths in m.
    void add(const Triple& half_extent);

    /// Another box under that number; for one without a half extent nothing is looked for.
    void put_in(std::size_t box, const Triple& half_extent);

    /// The box is somewhere else now; contacts that it had begin anew.
    void move(std::size_t box);

    /// The box is not quite where its last motion led.
    void distrust(std::size_t box);

    /// Finds the points at which the structure, which is where its body is, touches boxes. Boxes near it get their pose
    /// in `bodies`, which Bullet looks at. motions: of all bodies, by number. structure: its number.
    void find(std::deque<btRigidBody>& bodies, const BodyMotion* motions, std::size_t structure);

    /// Those with points, by body and part of the structure. Valid until the next find().
    std::span<btPersistentManifold* const> touching() const { return touching_; }

  private:
    /// The contact of a box and a solid. Null where the box is away from it.
    struct Pair {
        btCollisionAlgorithm* algorithm = nullptr;
        double due = 0;  ///< of the box's way, before which they are apart, m
    };

    std::span<Pair> pairs_of(std::size_t box) { return {pairs_.data() + box * solids_.size(), solids_.size()}; }
    double way_of(const btRigidBody& structure);
    void look_round(std::size_t box, btRigidBody& body, const BodyMotion& motion, const btRigidBody& structure);
    void touch(Pair& pair, std::size_t solid, const btRigidBody& box, const btRigidBody& structure);
    void refresh(const Pair& pair, btManifoldResult& result);
    void leave(Pair& pair);
    void collect();

    btCollisionDispatcher* dispatcher_;
    const btDispatcherInfo* info_;
    std::vector<Triple> half_extent_;
    std::vector<double> radius_;
    std::vector<double> way_;                ///< of boxes relative to the structure, turning included, at most, m
    std::vector<double> due_;                ///< the least of a box's pairs
    std::vector<const SolidShape*> solids_;  ///< of the structure
    std::vector<Pair> pairs_;                ///< by box, then solid
    btVector3 position_{0, 0, 0};            ///< of the structure in the last find()
    btMatrix3x3 rotation_ = btMatrix3x3::getIdentity();
    btManifoldArray manifolds_;  ///< of one pair
    std::vector<btPersistentManifold*> touching_;
};

}  // namespace floes
