#include "world/world.hpp"

#include <limits>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "world/checks.hpp"
#include "world/contact_load.hpp"
#include "world/conversion.hpp"
#include "world/solver_state.hpp"
#include "world/world_bullet.hpp"

namespace floes {

World::World(const WorldDefinition& definition) {
    check(definition);
    bullet_ = std::make_unique<Bullet>(definition);
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

BodyId World::add_element(const BoxDefinition& given) {
    check(given);
    const BoxDefinition box = bullet_->units.to_own(given);
    return bullet_->add_body(bullet_->boxes.take(box.half_extents), box.mass, box.pose, bullet_->friction.ice,
                             box.piece, 0, box.crushing_pressure);
}

BodyId World::add_prism(const PrismDefinition& given) {
    check(given, bullet_->definition.solver);
    const PrismDefinition prism = bullet_->units.to_own(given);
    return bullet_->add_body(bullet_->hulls.take(prism), prism.mass, prism.pose, bullet_->friction.ice, prism.piece, 0,
                             prism.crushing_pressure);
}

BodyId World::add_fixed_box(const FixedBoxDefinition& given) {
    check(given);
    const FixedBoxDefinition box = bullet_->units.to_own(given);
    return bullet_->add_body(bullet_->boxes.take(box.half_extents), 0, box.pose, bullet_->friction.ice, no_piece, 0, 0);
}

BodyId World::add_sliding_box(const SlidingBoxDefinition& given) {
    check(given);
    const SlidingBoxDefinition box = bullet_->units.to_own(given);
    return bullet_->add_body(bullet_->boxes.take(box.half_extents), box.mass, {box.position, Quat::Identity()},
                             bullet_->friction.ice, sheet_piece, 0, 0, box.axis);
}

BodyId World::add_structure(std::span<const ConvexSolid> solids, const Vec3& position) {
    check_structure(solids, bullet_->structure.has_value());
    bullet_->structure_shape.emplace();
    for (const ConvexSolid& solid : solids) {
        SolidShape& shape = bullet_->solids.emplace_back(bullet_->units.to_own(solid));
        bullet_->structure_shape->addChildShape(shape.place(), &shape);
    }
    const Pose pose{bullet_->units.to_own(position), Quat::Identity()};
    bullet_->structure = bullet_->add_body(&*bullet_->structure_shape, 0, pose, bullet_->friction.structure,
                                           sheet_piece, btCollisionObject::CF_KINEMATIC_OBJECT,
                                           std::numeric_limits<double>::infinity());  // it does not crush
    if (bullet_->lanes) bullet_->lanes->set_structure(bullet_->structure->index(), *bullet_->structure_shape);
    return *bullet_->structure;
}

JointId World::add_joint(const JointDefinition& given) {
    check(given, bullet_->bodies.size(), bullet_->definition.solver);
    const JointDefinition joint = bullet_->units.to_own(given);
    const JointId id(bullet_->joint_count++);
    if (bullet_->lanes) {
        bullet_->lanes->add_joint(joint, bullet_->body(joint.a), bullet_->body(joint.b));
        return id;
    }
    bullet_->joints.push_back(std::make_unique<FixedJoint>(joint, bullet_->body(joint.a), bullet_->body(joint.b)));
    bullet_->world.addConstraint(bullet_->joints.back()->constraint());
    return id;
}

void World::remove_joint(JointId joint) {
    if (bullet_->lanes) {
        bullet_->lanes->remove_joint(joint.index());
        return;
    }
    std::unique_ptr<FixedJoint>& removed = bullet_->joints[joint.index()];
    if (!removed) return;
    bullet_->world.remove_in_order(removed->constraint());
    removed.reset();
}

void World::soften_joint(JointId joint, double sound) {
    check_softening(sound, bullet_->definition.solver);
    bullet_->lanes->soften_joint(joint.index(), sound);
}

void World::set_piece(BodyId body, int piece) {
    if (bullet_->lanes)
        bullet_->lanes->set_piece(body.index(), piece);
    else
        bullet_->body(body).setUserIndex2(piece);
}

void World::set_water(BodyId body, const CarriedWater& given) {
    check(given, bullet_->definition.solver);
    bullet_->lanes->set_water(body.index(), bullet_->units.to_own(given));
}

void World::set_asleep(BodyId body, bool asleep) {
    check_sleep(bullet_->definition.solver);
    bullet_->lanes->set_asleep(body.index(), asleep);
}

void World::take_out(BodyId element) {
    check_sleep(bullet_->definition.solver);
    bullet_->lanes->take_out(element.index());
}

void World::put_in(BodyId element, const BoxDefinition& given) {
    check_sleep(bullet_->definition.solver);
    check(given);
    const BoxDefinition box = bullet_->units.to_own(given);
    bullet_->give_back_shape(element);
    bullet_->make_anew(element, bullet_->boxes.take(box.half_extents), box);
}

void World::put_in(BodyId element, const PrismDefinition& given) {
    check(given, bullet_->definition.solver);
    const PrismDefinition prism = bullet_->units.to_own(given);
    bullet_->give_back_shape(element);
    bullet_->make_anew(element, bullet_->hulls.take(prism), prism);
}

void World::put_in(JointId joint, const JointDefinition& given) {
    check_sleep(bullet_->definition.solver);
    check(given, bullet_->bodies.size(), bullet_->definition.solver);
    const JointDefinition definition = bullet_->units.to_own(given);
    bullet_->lanes->put_in_joint(joint.index(), definition, bullet_->body(definition.a), bullet_->body(definition.b));
}

std::vector<BodyId> World::touched_asleep() const {
    return bullet_->lanes ? bullet_->lanes->touched_asleep() : std::vector<BodyId>{};
}

void World::place(BodyId body, const BodyState& given) {
    btRigidBody& placed = bullet_->body(body);
    floes::place(placed, bullet_->units.to_own(given));
    if (bullet_->structure == body) bullet_->turn.place(bullet_->units.to_own(given).rotation);
    if (bullet_->lanes) {
        bullet_->lanes->place(body.index(), state_of(placed));
        return;
    }
    if (bullet_->dispatcher.getNumManifolds() > 0) {  // contacts: there are none before the first step
        bullet_->broadphase.getOverlappingPairCache()->cleanProxyFromPairs(placed.getBroadphaseHandle(),
                                                                           &bullet_->dispatcher);
    }
    bullet_->world.updateSingleAabb(&placed);
}

void World::move_structure(const Vec3& position, double yaw) {
    const Pose pose{bullet_->units.to_own(position), bullet_->turn.to(yaw)};
    // Not setCenterOfMassTransform: that would also move what Bullet takes the velocity from.
    bullet_->body(bullet_->structure.value()).setWorldTransform(to_bullet(pose));
}

void World::apply(BodyId body, const Wrench& given) {
    const Wrench wrench = bullet_->units.to_own(given);
    if (bullet_->lanes) return bullet_->lanes->apply(body.index(), wrench);
    btRigidBody& target = bullet_->body(body);
    target.applyCentralForce(to_bullet(wrench.force));
    target.applyTorque(to_bullet(wrench.moment));
}

void World::step() {
    const double time_step = bullet_->definition.time_step;
    if (!bullet_->lanes) {
        bullet_->world.stepSimulation(time_step, 0);  // 0: this step as it is, no sub-steps
        return;
    }
    if (bullet_->structure) bullet_->turn.save(bullet_->body(*bullet_->structure), time_step);
    bullet_->lanes->step(bullet_->bodies);
}

BodyState World::state(BodyId body) const {
    if (bullet_->lanes && bullet_->lanes->is_free(body.index())) {
        const BodyMotion* motion = bullet_->lanes->motion(body.index());
        return motion != nullptr ? bullet_->units.to_si(*motion)
                                 : bullet_->units.to_si(bullet_->lanes->state(body.index()));
    }
    const btRigidBody& source = bullet_->body(body);
    const btTransform& transform = source.getWorldTransform();
    return bullet_->units.to_si({.position = from_bullet(transform.getOrigin()),
                                 .rotation = from_bullet(transform.getBasis()),
                                 .velocity = from_bullet(source.getLinearVelocity()),
                                 .angular_velocity = from_bullet(source.getAngularVelocity())});
}

int World::sweeps() const {
    return bullet_->lanes ? bullet_->lanes->sweeps() : bullet_->definition.iterations;
}

JointReaction World::reaction(JointId joint) const {
    if (bullet_->lanes) return bullet_->units.to_si(bullet_->lanes->reaction(joint.index()));
    const std::unique_ptr<FixedJoint>& live = bullet_->joints[joint.index()];
    return live ? bullet_->units.to_si(live->reaction()) : JointReaction{};
}

Vec3 World::contact_force(BodyId body) const {
    const double time_step = bullet_->definition.time_step;
    if (bullet_->lanes) return contact_load(bullet_->lanes->contacts(), body, time_step);
    return contact_load(bullet_->world.solved_manifolds(), &bullet_->body(body), time_step);
}

void World::read_contacts(std::vector<ContactForce>& found, std::optional<BodyId> of) const {
    const double time_step = bullet_->definition.time_step;
    if (bullet_->lanes)
        read_contact_forces(bullet_->lanes->contacts(), of, time_step, found);
    else
        read_contact_forces(bullet_->world.solved_manifolds(), of ? &bullet_->body(*of) : nullptr, time_step, found);
    for (ContactForce& one : found) one.point = bullet_->units.to_si(one.point);
}

}  // namespace floes
