#include "world/rigid_body.hpp"

#include <algorithm>
#include <memory>
#include <ranges>

#include "world/conversion.hpp"

namespace floes {

btRigidBody::btRigidBodyConstructionInfo parts_of_body(btCollisionShape* shape, double mass, const Pose& pose,
                                                       double friction, bool turns) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0 && turns) shape->calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo parts(mass, nullptr, shape, inertia);
    parts.m_startWorldTransform = to_bullet(pose);
    parts.m_friction = friction;
    return parts;
}

void make_anew(btRigidBody& body, const btRigidBody::btRigidBodyConstructionInfo& parts) {
    const int number = body.getUserIndex();
    std::destroy_at(&body);
    std::construct_at(&body, parts);
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setUserIndex(number);
}

BoxShapes::Box::Box(const Vec3& given) : half_extents(given), shape(to_bullet(given)) {}

btBoxShape* BoxShapes::Box::taken() {
    ++users;
    return &shape;
}

btBoxShape* BoxShapes::take(const Vec3& half_extents) {
    for (Box& box : std::views::reverse(boxes_)) {  // most often the last: elements of one floe are equal
        if (box.half_extents == half_extents) return box.taken();
    }
    const auto unused = std::ranges::find(boxes_, 0, &Box::users);
    if (unused == boxes_.end()) return boxes_.emplace_back(half_extents).taken();
    std::destroy_at(&*unused);
    return std::construct_at(&*unused, half_extents)->taken();
}

void BoxShapes::give_back(const btCollisionShape* shape) {
    --std::ranges::find(boxes_, shape, [](const Box& box) -> const btCollisionShape* { return &box.shape; })->users;
}

}  // namespace floes
