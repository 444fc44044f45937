#include "world/world.hpp"

#include "world/checks.hpp"
#include "world/engine.hpp"
#include "world/froude_units.hpp"

namespace floes {

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
    parts_->engine->remove_joint(joint);
}

void World::soften_joint(JointId joint, double sound) {
    check_softening(sound, parts_->solver);
    parts_->engine->soften_joint(joint, sound);
}

void World::set_piece(BodyId body, int piece) {
    parts_->engine->set_piece(body, piece);
}

void World::set_water(BodyId body, const CarriedWater& water) {
    check(water, parts_->solver);
    parts_->engine->set_water(body, parts_->units.to_own(water));
}

void World::set_asleep(BodyId body, bool asleep) {
    check_sleep(parts_->solver);
    parts_->engine->set_asleep(body, asleep);
}

void World::take_out(BodyId element) {
    check_sleep(parts_->solver);
    parts_->engine->take_out(element);
}

void World::put_in(BodyId element, const ElementDefinition& definition) {
    check_sleep(parts_->solver);
    check(definition);
    parts_->engine->put_in(element, parts_->units.to_own(definition));
}

void World::put_in(JointId joint, const JointDefinition& definition) {
    check_sleep(parts_->solver);
    check(definition, parts_->bodies, parts_->solver);
    parts_->engine->put_in(joint, parts_->units.to_own(definition));
}

std::vector<BodyId> World::touched_asleep() const {
    return parts_->engine->touched_asleep();
}

void World::place(BodyId body, const BodyState& state) {
    parts_->engine->place(body, parts_->units.to_own(state));
}

void World::move_structure(const Pose& pose) {
    parts_->engine->move_structure(parts_->units.to_own(pose));
}

void World::apply(BodyId body, const Wrench& wrench) {
    parts_->engine->apply(body, parts_->units.to_own(wrench));
}

void World::step() {
    parts_->engine->step();
}

BodyState World::state(BodyId body) const {
    return parts_->units.to_si(parts_->engine->state(body));
}

int World::sweeps() const {
    return parts_->engine->sweeps();
}

JointReaction World::reaction(JointId joint) const {
    return parts_->units.to_si(parts_->engine->reaction(joint));
}

Vec3 World::contact_force(BodyId body) const {
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

}  // namespace floes
