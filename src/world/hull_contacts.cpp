#include "world/hull_contacts.hpp"

#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/bullet_shapes.hpp"

namespace floes {
namespace {

btTransform place_of(const BodyMotion& motion) {
    return transform_of(motion.position, motion.rotation);
}

/// 0 of none.
double radius_of(const IceShape* shape) {
    return shape != nullptr ? std::sqrt(dot(shape->prism().half_extent, shape->prism().half_extent)) : 0.0;
}

/// The farthest that turning from one rotation to the other moves a point of the shape, m.
double way_of_turn(const btCollisionShape& shape, const btMatrix3x3& before, const btMatrix3x3& after) {
    double squares = 0;
    for (int row = 0; row < 3; ++row) squares += (after[row] - before[row]).length2();
    if (squares == 0) return 0;
    btVector3 centre;
    btScalar radius = 0;
    shape.getBoundingSphere(centre, radius);
    return std::sqrt(squares) * (centre.length() + radius);
}

/// As Bullet asks before it looks for points, but along the structure's axes.
bool bounds_meet(const SolidShape& solid, const btConvexShape& element, const btTransform& beside) {
    btVector3 low;
    btVector3 high;
    element.getAabb(beside, low, high);
    return (from_bullet(low).array() <= solid.high().array()).all() &&
           (from_bullet(high).array() >= solid.low().array()).all();
}

BoxBeside box_beside(const btTransform& place, const Triple& half_extent) {
    return {from_bullet(place.getOrigin()),
            from_bullet(place.getBasis()),
            {half_extent[0], half_extent[1], half_extent[2]}};
}

/// Takes up what Bullet finds, as btManifoldResult does.
struct PointTaker final : btDiscreteCollisionDetectorInterface::Result {
    PointTaker(TouchingPoints& into, const PrismPlace& of_a, const PrismPlace& of_b, double how_near)
        : points(into), a(of_a), b(of_b), reach(how_near) {}

    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3& normal, const btVector3& on_b, btScalar distance) override {
        if (distance > reach) return;
        points.add(a, b, {on_b.x(), on_b.y(), on_b.z()}, {normal.x(), normal.y(), normal.z()}, distance, reach);
    }

    TouchingPoints& points;
    const PrismPlace &a, &b;
    double reach;
};

}  // namespace

void HullContacts::set_structure(std::uint32_t number, std::span<const ConvexSolid> solids) {
    structure_ = number;
    for (const ConvexSolid& solid : solids) {
        SolidShape& shape = solids_.emplace_back(solid);
        whole_.addChildShape(shape.place(), &shape);
    }
    pairs_.assign(shapes_.size() * solids_.size(), {});
}

void HullContacts::add(const IceShape* shape) {
    shapes_.push_back(shape);
    radius_.push_back(radius_of(shape));
    way_.push_back(0);
    due_.push_back(0);
    pairs_.resize(shapes_.size() * solids_.size());
    touching_.reserve(2 * shapes_.size());
}

void HullContacts::put_in(std::uint32_t element, const IceShape* shape, ContactStore& store) {
    shapes_[element] = shape;
    radius_[element] = radius_of(shape);
    move(element, store);
}

void HullContacts::move(std::uint32_t element, ContactStore& store) {
    distrust(element);
    for (Pair& pair : pairs_of(element)) {
        if (pair.points >= 0) store.give_back(pair.points);
        pair.points = -1;
    }
    std::erase_if(touching_, [&](const Touching& one) { return one.b == element; });
}

void HullContacts::distrust(std::uint32_t element) {
    way_[element] = due_[element] = 0;
    for (Pair& pair : pairs_of(element)) pair.due = 0;
}

/// How far a point of it can have gone since the last find(), m.
double HullContacts::way_of_structure(const BodyMotion& motion) {
    const btTransform now = place_of(motion);
    const double way =
        (now.getOrigin() - last_.getOrigin()).length() + way_of_turn(whole_, last_.getBasis(), now.getBasis());
    last_ = now;
    return way;
}

void HullContacts::find(const BodyMotion* motions, ContactStore& store) {
    touching_.clear();
    if (solids_.empty()) return;
    const double way = way_of_structure(motions[structure_]);
    for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
        if (shapes_[i] == nullptr) continue;
        way_[i] += way + motions[i].way + radius_[i] * motions[i].turn;
        if (way_[i] >= due_[i]) look_round(i, motions[i], motions[structure_], store);
    }
}

void HullContacts::look_round(std::uint32_t element, const BodyMotion& motion, const BodyMotion& structure,
                              ContactStore& store) {
    const IceShape& shape = *shapes_[element];
    const double reach = 2 * shape.reach();
    const btTransform beside = place_of(structure).inverseTimes(place_of(motion));
    due_[element] = std::numeric_limits<double>::infinity();
    const std::span<Pair> pairs = pairs_of(element);
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        Pair& pair = pairs[i];
        if (way_[element] >= pair.due) {
            const btTransform place(beside.getBasis(), beside.getOrigin() - solids_[i].place().getOrigin());
            const double gap = solids_[i].gap_to(box_beside(place, shape.prism().half_extent)) - reach;
            pair.due = way_[element] + gap;
            if (gap <= 0 && bounds_meet(solids_[i], shape.convex(), place)) {
                if (pair.points < 0) pair.points = store.take();
                touch(store[pair.points], i, element, motion, structure);
            } else if (pair.points >= 0) {
                store.give_back(pair.points);
                pair.points = -1;
            }
        }
        if (pair.points >= 0 && store[pair.points].count() > 0)
            touching_.push_back({structure_, element, static_cast<std::int32_t>(i), pair.points});
        due_[element] = std::min(due_[element], pair.due);
    }
}

/// As btCompoundCollisionAlgorithm and btConvexConvexAlgorithm do with one child.
void HullContacts::touch(TouchingPoints& points, std::size_t solid, std::uint32_t element, const BodyMotion& motion,
                         const BodyMotion& structure) {
    const IceShape& shape = *shapes_[element];
    const double reach = std::min(whole_.getContactBreakingThreshold(gContactBreakingThreshold), shape.reach());
    const PrismPlace a{nullptr, structure.position, structure.rotation};
    const PrismPlace b{nullptr, motion.position, motion.rotation};
    points.refresh(a, b, reach);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = place_of(structure) * solids_[solid].place();
    input.m_transformB = place_of(motion);
    const double farthest = solids_[solid].getMargin() + shape.convex().getMargin() + reach;
    input.m_maximumDistanceSquared = farthest * farthest;
    btGjkPairDetector detector(&solids_[solid], &shape.convex(), &simplex_, &depths_);
    PointTaker taker(points, a, b, reach);
    detector.getClosestPoints(input, taker, nullptr);
    points.refresh(a, b, reach);
}

}  // namespace floes
