#pragma once
// How Bullet's bodies are made, and made anew. Only for files inside this module.

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <deque>
#include <optional>

#include "world/definitions.hpp"

namespace floes {

/// What a body is made of; it turns unless it is on a rail.
btRigidBody::btRigidBodyConstructionInfo parts_of_body(btCollisionShape* shape, double mass, const Pose& pose,
                                                       double friction, bool turns);

/// Makes the body anew: nothing of what it was is left but its number.
void make_anew(btRigidBody& body, const btRigidBody::btRigidBodyConstructionInfo& parts);

/// Boxes as shapes that equal bodies share. One that no body has any more is used for another size.
class BoxShapes {
  public:
    btBoxShape* take(const Vec3& half_extents);
    void give_back(const btCollisionShape* shape);

  private:
    struct Box {
        explicit Box(const Vec3& given);
        btBoxShape* taken();

        Vec3 half_extents;
        btBoxShape shape;
        int users = 0;
    };
    std::deque<Box> boxes_;
};

}  // namespace floes
