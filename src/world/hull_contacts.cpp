#include "world/hull_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/solid_faces.hpp"
#include "core/state_archive.hpp"

namespace floes {
namespace {

btTransform place_of(const BodyMotion& motion) {
    return transform_of(motion.position, motion.rotation);
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

Triple triple(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

/// An element at a solid of the structure, and how near they are.
struct Meeting {
    const SolidShape& solid;
    const IceShape& shape;
    PrismPlace of_structure, of_ice;
    double reach;
    PrismCorners prism;
    SolidGap found;

    double margins() const { return solid.getMargin() + shape.core().margin; }
    double distance() const { return found.gap - margins(); }

    void add(const Vec3& on_prism, double gap, TouchingPoints& points) const {
        const Vec3 on_ice = on_prism - found.normal * shape.core().margin + from_bullet(solid.place().getOrigin());
        points.add(of_structure, of_ice, to_world(of_structure, triple(on_ice)),
                   out_of(of_structure, triple(-found.normal)), gap - margins(), reach);
    }

    void gather_deepest(TouchingPoints& points) const {
        points.refresh(of_structure, of_ice, reach);
        if (distance() > reach) return;
        add(found.on_prism, found.gap, points);
        points.refresh(of_structure, of_ice, reach);
    }

    void bear_on_faces(TouchingPoints& points) const {
        TouchingPoints now;
        double least = std::numeric_limits<double>::infinity();
        const BearingPoints on_faces(solid.core(), prism, found);
        for (const BearingPoint& one : on_faces.all()) {
            if (one.gap - margins() > reach) continue;
            add(one.on_prism, one.gap, now);
            least = std::min(least, one.gap);
        }
        if (distance() <= reach && least > found.gap + length_rounding) add(found.on_prism, found.gap, now);
        now.take_impulses(points, reach);
        points = now;
    }
};

}  // namespace

void HullContacts::set_structure(std::uint32_t number, std::span<const ConvexSolid> solids, NormalLaw law) {
    structure_ = number;
    law_ = law;
    for (const ConvexSolid& solid : solids) {
        SolidShape& shape = solids_.emplace_back(solid);
        whole_.addChildShape(shape.place(), &shape);
    }
    reach_ = whole_.getContactBreakingThreshold(gContactBreakingThreshold);
    pairs_.assign(way_.size() * solids_.size(), {});
}

void HullContacts::add() {
    way_.push_back(0);
    due_.push_back(0);
    pairs_.resize(way_.size() * solids_.size());
    touching_.reserve(2 * way_.size());
}

void HullContacts::drop(Pair& pair, ContactStore& store) {
    if (pair.points >= 0) store.give_back(pair.points);
    pair.points = -1;
}

void HullContacts::move(std::uint32_t element, ContactStore& store) {
    distrust(element);
    for (Pair& pair : pairs_of(element)) drop(pair, store);
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

void HullContacts::find(std::span<const LooseElement> bodies, const BodyMotion* motions, ContactStore& store) {
    touching_.clear();
    if (solids_.empty()) return;
    const double way = way_of_structure(motions[structure_]);
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        const auto& [shape, radius] = bodies[i];
        if (shape == nullptr) continue;
        way_[i] += way + motions[i].way + radius * motions[i].turn;
        if (way_[i] >= due_[i]) look_round(i, *shape, motions[i], motions[structure_], store);
    }
}

void HullContacts::look_round(std::uint32_t element, const IceShape& shape, const BodyMotion& motion,
                              const BodyMotion& structure, ContactStore& store) {
    const double reach = 2 * shape.reach();
    const btTransform beside = place_of(structure).inverseTimes(place_of(motion));
    due_[element] = std::numeric_limits<double>::infinity();
    const std::span<Pair> pairs = pairs_of(element);
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        Pair& pair = pairs[i];
        if (way_[element] >= pair.due) {
            const btTransform place(beside.getBasis(), beside.getOrigin() - solids_[i].place().getOrigin());
            const double gap = solids_[i].gap_to(place, shape.prism().half_extent) - reach;
            pair.due = way_[element] + gap;
            if (gap <= 0 && bounds_meet(solids_[i], shape.convex(), place))
                pair.due = way_[element] + touch(pair, solids_[i], shape, place, motion, structure, store);
            else
                drop(pair, store);
        }
        if (pair.points >= 0) touching_.push_back({structure_, element, static_cast<std::int32_t>(i), pair.points});
        due_[element] = std::min(due_[element], pair.due);
    }
}

/// Takes up where they are nearest or overlap. `beside`: of the element, in the solid's axes. Returns how much nearer
/// they must come until there may be a point; 0 if there is one.
double HullContacts::touch(Pair& pair, const SolidShape& solid, const IceShape& shape, const btTransform& beside,
                           const BodyMotion& motion, const BodyMotion& structure, ContactStore& store) const {
    const double reach = std::min(reach_, shape.reach());
    const PrismCorners prism(shape.core(), from_bullet(beside.getOrigin()), from_bullet(beside.getBasis()));
    const Meeting meeting{.solid = solid,
                          .shape = shape,
                          .of_structure = {nullptr, structure.position, structure.rotation},
                          .of_ice = {nullptr, motion.position, motion.rotation},
                          .reach = reach,
                          .prism = prism,
                          .found = gap_between(solid.core(), prism, solid.getMargin() + shape.core().margin + reach)};
    if (pair.points < 0) {
        if (meeting.distance() > reach) return std::max(0.0, meeting.distance() - reach - length_rounding);
        pair.points = store.take();
    }
    TouchingPoints& points = store[pair.points];
    if (law_ == NormalLaw::crushing)
        meeting.bear_on_faces(points);
    else
        meeting.gather_deepest(points);
    if (points.count() == 0) drop(pair, store);
    return 0;
}

void HullContacts::archive(StateArchive& state) {
    auto& [solids, whole, reach, structure, law, way, due, pairs, last, touching] = *this;
    std::array<double, 3> origin = array_of(last.getOrigin());
    std::array<double, 9> basis = rows_of(last.getBasis());
    state(way, due, pairs, origin, basis, touching);
    if (state.sets()) last = transform_of(origin.data(), basis.data());
}

}  // namespace floes
