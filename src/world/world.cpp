#include "world/world.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/state_archive.hpp"
#include "shapes/elements.hpp"
#include "world/engine.hpp"

namespace floes {
// Between SI, in which a World is spoken to, and the units in which it computes.
//
// Bullet has lengths of its own, fixed for bodies of centimetres to a metre: contact points live up to 20 mm, shapes
// have margins of millimetres, its narrow phase has tolerances. So a World, its solvers included, measures lengths in a
// unit u (m) that grows with the ice, times in √u (s) and masses in kg: accelerations and forces have the same numbers
// in both. A scene scaled by Froude, lengths by s and times by √s, then has the same lengths, times and speeds again,
// at s³ times the masses and forces. Whatever a definition has with another unit needs its line here.

class FroudeUnits {
  public:
    /// length: u, m, above 0. 1 is SI, to the bit.
    explicit FroudeUnits(double length) : length_(length), time_(std::sqrt(length)) {}

    Vec3 to_own(const Vec3& position) const { return position / length_; }
    Pose to_own(const Pose& pose) const { return {to_own(pose.position), pose.orientation}; }
    WorldDefinition to_own(WorldDefinition definition) const {
        definition.time_step /= time_;
        definition.contact.split_impulse_depth /= length_;
        definition.contact.crushing_pressure *= length_ * length_;
        definition.contact.slip.speed /= time_;
        definition.contact.slip.slowest /= time_;
        definition.contact.slip.memory /= time_;
        return definition;
    }
    ElementDefinition to_own(ElementDefinition element) const {
        for (Corner& corner : element.corners) corner = {corner.x / length_, corner.z / length_};
        element.half_thickness /= length_;
        element.crushing_pressure *= length_ * length_;
        element.pose = to_own(element.pose);
        return element;
    }
    JointDefinition to_own(JointDefinition joint) const {
        joint.pivot /= length_;
        if (joint.spring) {
            for (double& stiffness : joint.spring->force) stiffness *= length_;
            for (double& stiffness : joint.spring->moment) stiffness /= length_;
        }
        return joint;
    }
    PlaneDefinition to_own(const PlaneDefinition& plane) const {
        return {to_own(plane.point), plane.normal, plane.friction};
    }
    ConvexSolid to_own(const ConvexSolid& solid) const { return solid.scaled(1 / length_); }
    CarriedWater to_own(CarriedWater water) const {
        for (double* first : {&water.x, &water.z}) *first /= length_;
        for (double* second : {&water.yaw, &water.xx, &water.xz, &water.zz}) *second /= length_ * length_;
        return water;
    }
    BodyState to_own(const BodyState& state) const {
        return {to_own(state.position), state.rotation, state.velocity / time_, state.angular_velocity * time_};
    }
    Wrench to_own(const Wrench& wrench) const { return {wrench.force, wrench.moment / length_}; }

    Vec3 to_si(const Vec3& position) const { return position * length_; }
    BodyState to_si(const BodyState& state) const {
        return {state.position * length_, state.rotation, state.velocity * time_, state.angular_velocity / time_};
    }
    JointReaction to_si(JointReaction reaction) const {
        for (double* moment : {&reaction.torsion, &reaction.in_plane_bending, &reaction.bending}) *moment *= length_;
        return reaction;
    }

  private:
    double length_;
    double time_;
};

namespace {

// What a World refuses: each function throws InputError with the value and its range.

void require(bool allowed, const char* what, double value, const char* range) {
    if (!allowed)
        throw InputError(fmt::format("The world cannot be built: {} is {}; it must be {}.", what, value, range));
}

void check_box(const Vec3& half_extents) {
    require((half_extents.array() > 0).all(), "the smallest half extent of a box", half_extents.minCoeff(),
            "above 0 m");
}

void refuse(const Refusal& refusal) {
    throw InputError(fmt::format("The world refuses this: {}; take {}.", refusal.reason, refusal.instead));
}

void require(SolverKind solver, Feature feature) {
    if (const auto refusal = refusal_of(solver, feature)) refuse(*refusal);
}

void check_contact(const ContactLaw& law, SolverKind solver) {
    for (const Refusal& refusal : refused_contacts(solver, law)) refuse(refusal);
    // Bullet limits a combined coefficient to 10.
    for (const double friction : {law.ice_ice_friction, law.ice_structure_friction}) {
        require(friction >= 0 && friction <= 10, "a coefficient of friction", friction, "between 0 and 10");
    }
    const SlipFriction& slip = law.slip;
    require(slip.speed > 0, "the speed at which friction is given", slip.speed, "above 0 m/s");
    require(slip.memory > 0, "the memory of friction", slip.memory, "above 0 s");
    require(0 <= slip.least && slip.least <= slip.largest && slip.largest <= 10, "the least coefficient of friction",
            slip.least, "at least 0 and at most the largest, which is at most 10");
    require(law.normal == NormalLaw::rigid || law.crushing_pressure > 0, "the crushing pressure", law.crushing_pressure,
            "above 0 Pa");
    require(law.erp >= 0 && law.erp <= 1, "the contact ERP", law.erp, "between 0 and 1");
    require(law.split_impulse_depth >= 0, "the split impulse depth", law.split_impulse_depth, "at least 0 m");
}

/// With the contact law: what the solver that the definition names refuses (solver/solver_kind.hpp).
void check(const WorldDefinition& d) {
    require(d.time_step > 0, "the time step", d.time_step, "above 0 s");
    require(d.iterations >= 1, "the number of iterations", d.iterations, "at least 1");
    require(std::isfinite(d.gravity), "gravity", d.gravity, "a finite number");
    require(d.length_unit > 0 && std::isfinite(d.length_unit), "the unit of length", d.length_unit, "above 0 m");
    check_contact(d.contact, d.solver);
}

void check(const ElementDefinition& element) {
    require(element.half_thickness > 0, "half the thickness of an element", element.half_thickness, "above 0 m");
    require(element.mass > 0, "the mass of an element", element.mass, "above 0 kg");
    if (const auto fault = fault_of(element.corners))
        throw InputError(fmt::format("The world cannot be built: an element is no convex polygon: {}.", *fault));
    require(element.corners.size() <= most_corners, "the number of corners of an element",
            static_cast<double>(element.corners.size()), fmt::format("at most {}", most_corners).c_str());
    const Measures of = measures_of(element.corners);
    require(of.area > 0, "the area of an element", of.area, "above 0 m², with corners from x to z");
    require(std::abs(of.centroid.x) + std::abs(of.centroid.z) <= 1e-6 * reach_of(element.corners) &&
                std::abs(of.xz) <= 1e-6 * (of.xx + of.zz),
            "the product of inertia of an element", of.xz, "0, about its centre of mass");
}

void check(const FixedBoxDefinition& box) {
    check_box(box.half_extents);
}

void check(const SlidingBoxDefinition& box) {
    check_box(box.half_extents);
    require(box.mass > 0, "the mass of a sliding box", box.mass, "above 0 kg");
    require(box.axis >= 0 && box.axis <= 2, "the axis of a sliding box", box.axis, "0, 1 or 2");
}

void check(const JointDefinition& joint, std::size_t bodies, SolverKind solver) {
    const auto last = static_cast<double>(bodies) - 1;
    for (const BodyId body : {joint.a, joint.b}) {
        require(body.index() < bodies, "the index of a joined body", static_cast<double>(body.index()),
                fmt::format("at most {}", last).c_str());
    }
    require(joint.a != joint.b, "the second body of a joint", static_cast<double>(joint.b.index()),
            "another than the first");
    // The sweeps are an over-relaxation by 1 + Σ, which does not converge from 1 on.
    require(joint.cfm >= 0 && joint.cfm < 1, "the joint CFM", joint.cfm, "at least 0 and below 1");
    require(joint.erp >= 0 && joint.erp <= 1, "the joint ERP", joint.erp, "between 0 and 1");
    if (!joint.spring) {
        require(solver != SolverKind::direct || joint.cfm > 0, "the joint CFM", joint.cfm,
                "above 0 with the direct solver");
        return;
    }
    require(solver, Feature::springs);
    for (const auto& part : {joint.spring->force, joint.spring->moment}) {
        for (const double stiffness : part) {
            require(stiffness > 0 && std::isfinite(stiffness), "the stiffness of a joint", stiffness, "above 0");
        }
    }
    require(joint.spring->damping_ratio >= 0, "the damping ratio of a joint", joint.spring->damping_ratio,
            "at least 0");
}

void check(const CarriedWater& water, SolverKind solver) {
    require(solver, Feature::carried_water);
    for (const double mass : {water.in_plane, water.normal})
        require(mass >= 0 && std::isfinite(mass), "a mass of water", mass, "at least 0 kg");
    for (const double inertia : {water.yaw, water.xx, water.zz})
        require(inertia >= 0 && std::isfinite(inertia), "a moment of inertia of water", inertia, "at least 0 kg m²");
    require(water.x * water.x <= water.normal * water.xx && water.z * water.z <= water.normal * water.zz &&
                water.xz * water.xz <= water.xx * water.zz,
            "the first moment of the water along x", water.x, "that of a mass somewhere");
}

void check(const PlaneDefinition& plane, SolverKind solver) {
    require(solver, Feature::bed);
    require(plane.point.allFinite(), "a point of a plane", plane.point.sum(), "finite");
    require(std::abs(plane.normal.norm() - 1) < 1e-9, "the length of a plane's normal", plane.normal.norm(), "1");
    require(plane.friction >= 0 && plane.friction <= 10, "the friction of a plane", plane.friction, "between 0 and 10");
}

void check_structure(std::span<const ConvexSolid> solids, bool present) {
    require(!present, "the number of structures", 2, "at most 1");
    require(!solids.empty(), "the number of solids of the structure", 0, "at least 1");
    for (const ConvexSolid& solid : solids) {
        if (const auto fault = solid.fault()) throw InputError(fmt::format("The world cannot be built: {}.", *fault));
    }
}

}  // namespace

struct World::Parts {
    explicit Parts(const WorldDefinition& definition)
        : solver(definition.solver),
          units(definition.length_unit),
          time_step(units.to_own(definition).time_step),
          engine((solver == SolverKind::stock ? make_bullet_engine : make_lane_engine)(units.to_own(definition))) {}

    BodyId add(const ElementDefinition& body, std::optional<int> rail = {}) {
        engine->add_body(units.to_own(body), rail);
        return BodyId(bodies++);
    }

    SolverKind solver;
    FroudeUnits units;
    double time_step;  ///< in the engine's units, as impulses are
    std::unique_ptr<Engine> engine;
    std::size_t bodies = 0;
    std::size_t joints = 0;
    bool has_structure = false;
};

namespace {

Vec3 vector_of(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

Outline plan_of(const Vec3& half_extents) {
    return corners_of(half_extents.x(), half_extents.z());
}

}  // namespace

World::World(const WorldDefinition& definition) {
    check(definition);
    parts_ = std::make_unique<Parts>(definition);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

BodyId World::add_element(const ElementDefinition& element) {
    check(element);
    return parts_->add(element);
}

BodyId World::add_fixed_box(const FixedBoxDefinition& box) {
    check(box);
    return parts_->add(
        {.corners = plan_of(box.half_extents), .half_thickness = box.half_extents.y(), .pose = box.pose});
}

BodyId World::add_sliding_box(const SlidingBoxDefinition& box) {
    check(box);
    return parts_->add({.corners = plan_of(box.half_extents),
                        .half_thickness = box.half_extents.y(),
                        .mass = box.mass,
                        .pose = {box.position, Quat::Identity()}},
                       box.axis);
}

BodyId World::add_plane(const PlaneDefinition& plane) {
    check(plane, parts_->solver);
    parts_->engine->add_plane(parts_->units.to_own(plane));
    return BodyId(parts_->bodies++);
}

BodyId World::add_structure(std::span<const ConvexSolid> solids, const Pose& pose) {
    check_structure(solids, parts_->has_structure);
    std::vector<ConvexSolid> own;
    for (const ConvexSolid& solid : solids) own.push_back(parts_->units.to_own(solid));
    parts_->engine->add_structure(own, parts_->units.to_own(pose));
    parts_->has_structure = true;
    return BodyId(parts_->bodies++);
}

JointId World::add_joint(const JointDefinition& joint) {
    check(joint, parts_->bodies, parts_->solver);
    parts_->engine->add_joint(parts_->units.to_own(joint));
    return JointId(parts_->joints++);
}

void World::remove_joint(JointId joint) {
    FLOES_EXPECTS(joint.index() < parts_->joints);
    parts_->engine->remove_joint(joint);
}

void World::soften_joint(JointId joint, double sound) {
    FLOES_EXPECTS(joint.index() < parts_->joints);
    require(parts_->solver, Feature::cracks);
    require(sound > 0 && sound <= 1, "the share of a joint's stiffness that is left", sound, "above 0 and at most 1");
    parts_->engine->soften_joint(joint, sound);
}

void World::set_piece(BodyId body, int piece) {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    parts_->engine->set_piece(body, piece);
}

void World::set_water(BodyId body, const CarriedWater& water) {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    check(water, parts_->solver);
    parts_->engine->set_water(body, parts_->units.to_own(water));
}

void World::set_asleep(BodyId body, bool asleep) {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    require(parts_->solver, Feature::sleep);
    parts_->engine->set_asleep(body, asleep);
}

void World::take_out(BodyId element) {
    FLOES_EXPECTS(element.index() < parts_->bodies);
    require(parts_->solver, Feature::sleep);
    parts_->engine->take_out(element);
}

void World::put_in(BodyId element, const ElementDefinition& definition) {
    FLOES_EXPECTS(element.index() < parts_->bodies);
    require(parts_->solver, Feature::sleep);
    check(definition);
    parts_->engine->put_in(element, parts_->units.to_own(definition));
}

void World::put_in(JointId joint, const JointDefinition& definition) {
    FLOES_EXPECTS(joint.index() < parts_->joints);
    require(parts_->solver, Feature::sleep);
    check(definition, parts_->bodies, parts_->solver);
    parts_->engine->put_in(joint, parts_->units.to_own(definition));
}

std::vector<BodyId> World::touched_asleep() const {
    return parts_->engine->touched_asleep();
}

void World::place(BodyId body, const BodyState& state) {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    parts_->engine->place(body, parts_->units.to_own(state));
}

void World::move_structure(const Pose& pose) {
    FLOES_EXPECTS(parts_->has_structure);
    parts_->engine->move_structure(parts_->units.to_own(pose));
}

void World::apply(BodyId body, const Wrench& wrench) {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    parts_->engine->apply(body, parts_->units.to_own(wrench));
}

void World::step() {
    parts_->engine->step();
}

BodyState World::state(BodyId body) const {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    return parts_->units.to_si(parts_->engine->state(body));
}

int World::sweeps() const {
    return parts_->engine->sweeps();
}

JointReaction World::reaction(JointId joint) const {
    FLOES_EXPECTS(joint.index() < parts_->joints);
    return parts_->units.to_si(parts_->engine->reaction(joint));
}

Vec3 World::contact_force(BodyId body) const {
    FLOES_EXPECTS(body.index() < parts_->bodies);
    Vec3 impulse = Vec3::Zero();
    for (const SolverContact& contact : parts_->engine->contacts()) {
        const double side = contact.a == body.index() ? 1.0 : contact.b == body.index() ? -1.0 : 0.0;
        if (side == 0.0) continue;
        const Vec3 on_a =
            vector_of(contact.normal) * contact.impulse + vector_of(contact.slide) * contact.friction_impulse;
        impulse += side * on_a;
    }
    return impulse / parts_->time_step;
}

void World::read_contacts(std::vector<ContactForce>& found, std::optional<BodyId> of) const {
    found.clear();
    for (const SolverContact& contact : parts_->engine->contacts()) {
        if (of && contact.a != of->index() && contact.b != of->index()) continue;
        if (contact.impulse == 0 && contact.friction_impulse == 0) continue;
        found.push_back({.a = BodyId(contact.a),
                         .b = BodyId(contact.b),
                         .point = parts_->units.to_si((vector_of(contact.on_a) + vector_of(contact.on_b)) / 2),
                         .normal = vector_of(contact.normal) * (contact.impulse / parts_->time_step),
                         .friction = vector_of(contact.slide) * (contact.friction_impulse / parts_->time_step),
                         .solid = contact.solid});
    }
}

void World::archive(StateArchive& state) {
    auto& [solver, units, time_step, engine, bodies, joints, has_structure] = *parts_;
    state.same(solver);
    state(bodies, joints);
    engine->archive(state);
}

}  // namespace floes
