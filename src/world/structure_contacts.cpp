#include "world/structure_contacts.hpp"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "world/conversion.hpp"

namespace floes {
namespace {

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

/// As Bullet asks before it looks for points, but along the structure's axes.
bool bounds_meet(const SolidShape& solid, const btRigidBody& box, const btTransform& beside) {
    btVector3 low;
    btVector3 high;
    box.getCollisionShape()->getAabb(beside, low, high);
    return (from_bullet(low).array() <= solid.high().array()).all() &&
           (from_bullet(high).array() >= solid.low().array()).all();
}

BoxBeside box_beside(const btTransform& place, const Triple& half_extent) {
    return {from_bullet(place.getOrigin()),
            from_bullet(place.getBasis()),
            {half_extent[0], half_extent[1], half_extent[2]}};
}

btTransform shifted(const btTransform& place, const btVector3& by) {
    return btTransform(place.getBasis(), place.getOrigin() + by);
}

}  // namespace

StructureContacts::~StructureContacts() {
    for (Pair& pair : pairs_) leave(pair);
}

void StructureContacts::set_solids(const btCompoundShape& structure) {
    for (int i = 0; i < structure.getNumChildShapes(); ++i)
        solids_.push_back(static_cast<const SolidShape*>(structure.getChildShape(i)));
    pairs_.assign(half_extent_.size() * solids_.size(), {});
}

void StructureContacts::add(const Triple& half_extent) {
    half_extent_.push_back(half_extent);
    radius_.push_back(std::sqrt(dot(half_extent, half_extent)));
    way_.push_back(0);
    due_.push_back(0);
    pairs_.resize(half_extent_.size() * solids_.size());
    touching_.reserve(2 * half_extent_.size());
}

void StructureContacts::put_in(std::size_t box, const Triple& half_extent) {
    half_extent_[box] = half_extent;
    radius_[box] = std::sqrt(dot(half_extent, half_extent));
    move(box);
}

void StructureContacts::move(std::size_t box) {
    distrust(box);
    for (Pair& pair : pairs_of(box)) leave(pair);
    collect();
}

void StructureContacts::distrust(std::size_t box) {
    way_[box] = due_[box] = 0;
    for (Pair& pair : pairs_of(box)) pair.due = 0;
}

void StructureContacts::leave(Pair& pair) {
    if (pair.algorithm == nullptr) return;
    pair.algorithm->~btCollisionAlgorithm();
    dispatcher_->freeCollisionAlgorithm(pair.algorithm);
    pair.algorithm = nullptr;
}

/// How far a point of it can have gone since the last find(), m.
double StructureContacts::way_of(const btRigidBody& structure) {
    const btVector3 position = structure.getWorldTransform().getOrigin();
    const btMatrix3x3& rotation = structure.getWorldTransform().getBasis();
    const double way = (position - position_).length() + way_of_turn(structure, rotation_, rotation);
    position_ = position;
    rotation_ = rotation;
    return way;
}

void StructureContacts::find(std::deque<btRigidBody>& bodies, const BodyMotion* motions, std::size_t structure) {
    const double way = way_of(bodies[structure]);
    for (std::size_t i = 0; i < half_extent_.size(); ++i) {
        if (radius_[i] == 0) continue;
        way_[i] += way + motions[i].way + radius_[i] * motions[i].turn;
        if (way_[i] >= due_[i]) look_round(i, bodies[i], motions[i], bodies[structure]);
    }
    collect();
}

void StructureContacts::look_round(std::size_t box, btRigidBody& body, const BodyMotion& motion,
                                   const btRigidBody& structure) {
    const double* r = motion.rotation;
    body.setWorldTransform(btTransform(btMatrix3x3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]),
                                       {motion.position[0], motion.position[1], motion.position[2]}));
    const double reach = 2 * body.getCollisionShape()->getContactBreakingThreshold(gContactBreakingThreshold);
    const btTransform beside = structure.getWorldTransform().inverseTimes(body.getWorldTransform());
    due_[box] = std::numeric_limits<double>::infinity();
    const std::span<Pair> pairs = pairs_of(box);
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        if (way_[box] >= pairs[i].due) {
            const btTransform place = shifted(beside, -solids_[i]->place().getOrigin());
            const double gap = solids_[i]->gap_to(box_beside(place, half_extent_[box])) - reach;
            pairs[i].due = way_[box] + gap;
            if (gap <= 0 && bounds_meet(*solids_[i], body, place))
                touch(pairs[i], i, body, structure);
            else
                leave(pairs[i]);
        }
        due_[box] = std::min(due_[box], pairs[i].due);
    }
}

/// Moves the points that there are with the bodies, and drops those that came apart.
void StructureContacts::refresh(const Pair& pair, btManifoldResult& result) {
    manifolds_.resize(0);
    pair.algorithm->getAllContactManifolds(manifolds_);
    for (int i = 0; i < manifolds_.size(); ++i) {
        if (manifolds_[i]->getNumContacts() == 0) continue;
        result.setPersistentManifold(manifolds_[i]);
        result.refreshContactPoints();
    }
    result.setPersistentManifold(nullptr);
}

/// As btCompoundCollisionAlgorithm does with each of its children.
void StructureContacts::touch(Pair& pair, std::size_t solid, const btRigidBody& box, const btRigidBody& structure) {
    const btCollisionObjectWrapper whole(nullptr, structure.getCollisionShape(), &structure,
                                         structure.getWorldTransform(), -1, -1);
    const btTransform own = solids_[solid]->place();
    const btTransform place = structure.getWorldTransform() * own;
    const btCollisionObjectWrapper one(&whole, solids_[solid], &structure, place, own, -1, static_cast<int>(solid));
    const btCollisionObjectWrapper other(nullptr, box.getCollisionShape(), &box, box.getWorldTransform(), -1, -1);
    btManifoldResult result(&one, &other);
    result.setShapeIdentifiersA(-1, static_cast<int>(solid));
    if (pair.algorithm == nullptr)
        pair.algorithm = dispatcher_->findAlgorithm(&one, &other, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    else
        refresh(pair, result);
    pair.algorithm->processCollision(&one, &other, *info_, &result);
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
