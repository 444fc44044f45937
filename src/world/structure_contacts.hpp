#pragma once
// Contacts of boxes with the structure, from step to step: Bullet's compound and GJK algorithms, for the boxes near it.
// Only for files inside this room.

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "collision/near_pairs.hpp"
#include "solver/body_motion.hpp"

namespace floes {

class StructureContacts {
  public:
    StructureContacts(btCollisionDispatcher& dispatcher, const btDispatcherInfo& info)
        : dispatcher_(&dispatcher), info_(&info) {}
    ~StructureContacts();
    StructureContacts(const StructureContacts&) = delete;
    StructureContacts& operator=(const StructureContacts&) = delete;

    /// Bodies are numbered from 0. Boxes that move have a half extent; for others nothing is looked for. Lengths in m.
    void add(const Triple& half_extent);

    /// Another box under that number; for one without a half extent nothing is looked for.
    void put_in(std::size_t box, const Triple& half_extent);

    /// The box is somewhere else now; contacts that it had begin anew.
    void move(std::size_t box);

    /// The box is not quite where its last motion led.
    void distrust(std::size_t box) { clearance_[box] = 0; }

    /// Finds the points at which the structure, which is where its body is, touches boxes. Boxes near it get their pose
    /// in `bodies`, which Bullet looks at. motions: of all bodies, by number. structure: its number.
    void find(std::deque<btRigidBody>& bodies, const BodyMotion* motions, std::size_t structure);

    /// Those with points, by body and part of the structure. Valid until the next find().
    std::span<btPersistentManifold* const> touching() const { return touching_; }

  private:
    void look(btRigidBody& box, const BodyMotion& motion, btRigidBody& structure, btCollisionAlgorithm*& algorithm);
    void leave(btCollisionAlgorithm*& algorithm);
    void collect();
    double gap_to_solids(const Bounds& box) const;

    btCollisionDispatcher* dispatcher_;
    const btDispatcherInfo* info_;
    std::vector<Triple> half_extent_;
    std::vector<double> radius_;
    std::vector<double> clearance_;                  ///< at least this far from points with the structure, m
    std::vector<btCollisionAlgorithm*> algorithms_;  ///< null for boxes away from it
    btVector3 position_{0, 0, 0};                    ///< of the structure in the last find()
    btMatrix3x3 rotation_ = btMatrix3x3::getIdentity();
    std::vector<btPersistentManifold*> touching_;
    std::vector<Bounds> solids_;  ///< of the structure, in the last find()
};

}  // namespace floes
