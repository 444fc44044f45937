#include "world/structure_contacts.hpp"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace floes {
namespace {

/// Of bounds along the axis along which they are farthest apart.
double gap_between(const Bounds& a, const Bounds& b) {
    double gap = -1;
    for (std::size_t i = 0; i < 3; ++i) gap = std::max({gap, a.low[i] - b.high[i], b.low[i] - a.high[i]});
    return gap;
}

Bounds bounds_of(const btRigidBody& body) {
    btVector3 low;
    btVector3 high;
    body.getCollisionShape()->getAabb(body.getWorldTransform(), low, high);
    return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

/// The farthest that turning from one rotation to the other moves a point of the body, m.
double way_of_turn(const btRigidBody& body, const btMatrix3x3& before, const btMatrix3x3& after) {
    double squares = 0;
    for (int row = 0; row < 3; ++row) squares += (after[row] - before[row]).length2();
    if (squares == 0) return 0;
    btVector3 centre;
    btScalar radius = 0;
    body.getCollisionShape()->getBoundingSphere(centre, radius);
    return std::sqrt(squares) * (centre.length() + radius);
}

/// Of each of its solids.
void read_solid_bounds(const btRigidBody& structure, std::vector<Bounds>& solids) {
    solids.clear();
    const auto* shape = static_cast<const btCompoundShape*>(structure.getCollisionShape());
    for (int i = 0; i < shape->getNumChildShapes(); ++i) {
        btVector3 low;
        btVector3 high;
        shape->getChildShape(i)->getAabb(structure.getWorldTransform() * shape->getChildTransform(i), low, high);
        solids.push_back({{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}});
    }
}

}  // namespace

StructureContacts::~StructureContacts() {
    for (btCollisionAlgorithm*& algorithm : algorithms_) leave(algorithm);
}

void StructureContacts::add(const Triple& half_extent) {
    half_extent_.push_back(half_extent);
    radius_.push_back(std::sqrt(dot(half_extent, half_extent)));
    clearance_.push_back(0);
    algorithms_.push_back(nullptr);
    touching_.reserve(2 * algorithms_.size());
}

void StructureContacts::put_in(std::size_t box, const Triple& half_extent) {
    half_extent_[box] = half_extent;
    radius_[box] = std::sqrt(dot(half_extent, half_extent));
    move(box);
}

void StructureContacts::move(std::size_t box) {
    clearance_[box] = 0;
    leave(algorithms_[box]);
    collect();
}

void StructureContacts::leave(btCollisionAlgorithm*& algorithm) {
    if (algorithm == nullptr) return;
    algorithm->~btCollisionAlgorithm();
    dispatcher_->freeCollisionAlgorithm(algorithm);
    algorithm = nullptr;
}

void StructureContacts::find(std::deque<btRigidBody>& bodies, const BodyMotion* motions, std::size_t structure) {
    btRigidBody& body = bodies[structure];
    const Bounds bounds = bounds_of(body);
    read_solid_bounds(body, solids_);
    const btVector3 position = body.getWorldTransform().getOrigin();
    const btMatrix3x3& rotation = body.getWorldTransform().getBasis();
    const double way = (position - position_).length() + way_of_turn(body, rotation_, rotation);
    position_ = position;
    rotation_ = rotation;
    for (std::size_t i = 0; i < half_extent_.size(); ++i) {
        if (radius_[i] == 0) continue;
        const BodyMotion& motion = motions[i];
        clearance_[i] -= way + motion.way + radius_[i] * motion.turn;
        if (clearance_[i] > 0) continue;
        const double reach = 2 * bodies[i].getCollisionShape()->getContactBreakingThreshold(gContactBreakingThreshold);
        const Bounds box = bounds_of({half_extent_[i].data(), motion.position, motion.rotation});
        clearance_[i] = gap_between(box, bounds) - reach;
        if (clearance_[i] <= 0 && solids_.size() > 1) clearance_[i] = gap_to_solids(box) - reach;
        if (clearance_[i] > 0)
            leave(algorithms_[i]);
        else
            look(bodies[i], motion, body, algorithms_[i]);
    }
    collect();
}

double StructureContacts::gap_to_solids(const Bounds& box) const {
    double gap = std::numeric_limits<double>::infinity();
    for (const Bounds& solid : solids_) gap = std::min(gap, gap_between(box, solid));
    return gap;
}

/// As btCollisionDispatcher::defaultNearCallback does.
void StructureContacts::look(btRigidBody& box, const BodyMotion& motion, btRigidBody& structure,
                             btCollisionAlgorithm*& algorithm) {
    const double* r = motion.rotation;
    box.setWorldTransform(btTransform(btMatrix3x3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                                      {motion.position[0], motion.position[1], motion.position[2]}));
    btRigidBody& first = box.getUserIndex() < structure.getUserIndex() ? box : structure;
    btRigidBody& second = &first == &box ? structure : box;
    const btCollisionObjectWrapper one(nullptr, first.getCollisionShape(), &first, first.getWorldTransform(), -1, -1);
    const btCollisionObjectWrapper other(nullptr, second.getCollisionShape(), &second, second.getWorldTransform(), -1,
                                         -1);
    if (algorithm == nullptr)
        algorithm = dispatcher_->findAlgorithm(&one, &other, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    btManifoldResult result(&one, &other);
    algorithm->processCollision(&one, &other, *info_, &result);
}

void StructureContacts::collect() {
    touching_.clear();
    for (int i = 0; i < dispatcher_->getNumManifolds(); ++i) {
        btPersistentManifold* const manifold = dispatcher_->getManifoldByIndexInternal(i);
        if (manifold->getNumContacts() > 0) touching_.push_back(manifold);
    }
    const auto key = [](const btPersistentManifold* manifold) {
        const btManifoldPoint& first = manifold->getContactPoint(0);
        return std::tuple(manifold->getBody0()->getUserIndex(), manifold->getBody1()->getUserIndex(), first.m_index0,
                          first.m_index1);
    };
    std::ranges::sort(touching_, [&](const auto* a, const auto* b) { return key(a) < key(b); });
}

}  // namespace floes
