#include "world/lane_solver.hpp"

#include <BulletCollision/CollisionShapes/btBoxShape.h>

#include "solver/lane_width.hpp"
#include "world/conversion.hpp"
#include "world/prism_hull.hpp"
#include "world/solver_state.hpp"

namespace floes {

namespace {

const PrismHull* hull_of(const btRigidBody& body) {
    return dynamic_cast<const PrismHull*>(body.getCollisionShape());
}

/// For a box, and for what holds a prism; zero for other shapes.
Triple half_extent(const btRigidBody& body) {
    if (const PrismHull* hull = hull_of(body)) return bounds_of(hull->prism());
    if (body.getCollisionShape()->getShapeType() != BOX_SHAPE_PROXYTYPE) return {};
    return array_of(static_cast<const btBoxShape*>(body.getCollisionShape())->getHalfExtentsWithMargin());
}

double reach_of(const btRigidBody& body) {
    return body.getCollisionShape()->getContactBreakingThreshold(gContactBreakingThreshold);
}

SolverJoint joint_of(const JointDefinition& definition, const btRigidBody& a, const btRigidBody& b) {
    const auto frame_in = [&](const btRigidBody& body) {
        const btTransform frame =
            body.getWorldTransform().inverse() * to_bullet(Pose{definition.pivot, definition.frame});
        return SolverFrame{rows_of(frame.getBasis()), array_of(frame.getOrigin())};
    };
    return {static_cast<std::uint32_t>(definition.a.index()),
            static_cast<std::uint32_t>(definition.b.index()),
            frame_in(a),
            frame_in(b),
            definition.cfm,
            definition.erp,
            definition.spring};
}

constexpr std::size_t not_in_system = static_cast<std::size_t>(-1);

}  // namespace

LaneSolver::LaneSolver(const WorldDefinition& definition, btCollisionDispatcher& dispatcher,
                       const btDispatcherInfo& info)
    : definition_(definition),
      width_(lane_kernels(definition.lanes > 0 ? definition.lanes : lane_widths().back()).width),
      structure_contacts_(dispatcher, info) {}

LaneSolver::Body LaneSolver::made_of(const btRigidBody& body, double crushing_pressure, std::optional<int> rail) const {
    Body made;
    if (body.getInvMass() > 0) {
        made.parts = {body.getInvMass(), array_of(body.getInvInertiaDiagLocal()), {}, 0, 0, {}};
        made.parts.weight = -definition_.gravity * (1.0 / body.getInvMass());
    }
    if (rail) {
        made.parts.rail = *rail;
        made.parts.weight = 0;
        made.parts.inverse_inertia.fill(body.getInvMass() / (1e3 * off_rail));
    }
    made.parts.half_extent = half_extent(body);
    made.parts.crushing_pressure = crushing_pressure;
    made.start = state_of(body);
    made.friction = body.getFriction();
    if (const PrismHull* hull = hull_of(body)) {
        made.parts.is_prism = true;
        made.prism = hull->prism();
    }
    return made;
}

void LaneSolver::add_body(const btRigidBody& body, int piece, double crushing_pressure, std::optional<int> rail) {
    const bool turns = body.getInvMass() > 0 && !rail;
    const Triple extent = half_extent(body);
    free_.push_back(body.getInvMass() > 0 ? 1 : 0);
    const Body& added = bodies_.emplace_back(made_of(body, crushing_pressure, rail));
    boxes_.add({extent, reach_of(body), !turns, extent != Triple{}, rail ? no_piece : piece,
                added.parts.is_prism ? added.prism.corners : Outline{}});
    structure_contacts_.add(turns ? extent : Triple{});
    stale_ = true;
}

void LaneSolver::take_out(std::size_t body) {
    bodies_[body].asleep = true;
    boxes_.take_out(static_cast<std::uint32_t>(body));
    structure_contacts_.put_in(body, {});
    stale_ = true;
}

void LaneSolver::put_in(std::size_t number, const btRigidBody& body, int piece, double crushing_pressure) {
    const Body& made = bodies_[number] = made_of(body, crushing_pressure, {});
    if (in_system_body(number)) system_->set_state(number, bodies_[number].start);
    const Triple extent = half_extent(body);
    boxes_.put_in(static_cast<std::uint32_t>(number),
                  {extent, reach_of(body), false, true, piece, made.parts.is_prism ? made.prism.corners : Outline{}});
    structure_contacts_.put_in(number, extent);
    stale_ = true;
}

void LaneSolver::add_joint(const JointDefinition& definition, const btRigidBody& a, const btRigidBody& b) {
    joints_.push_back(joint_of(definition, a, b));
    removed_.push_back(false);
    hold_edge(joints_.back().a, joints_.back().in_a, 1, true);
    hold_edge(joints_.back().b, joints_.back().in_b, -1, true);
    stale_ = true;
}

void LaneSolver::put_in_joint(std::size_t number, const JointDefinition& definition, const btRigidBody& a,
                              const btRigidBody& b) {
    joints_[number] = joint_of(definition, a, b);
    removed_[number] = false;
    hold_edge(joints_[number].a, joints_[number].in_a, 1, true);
    hold_edge(joints_[number].b, joints_[number].in_b, -1, true);
    stale_ = true;
}

void LaneSolver::remove_joint(std::size_t joint) {
    if (removed_[joint]) return;
    removed_[joint] = true;
    hold_edge(joints_[joint].a, joints_[joint].in_a, 1, false);
    hold_edge(joints_[joint].b, joints_[joint].in_b, -1, false);
    if (in_system(joint)) system_->remove_joint(joint_in_system_[joint]);
}

void LaneSolver::soften_joint(std::size_t joint, double sound) {
    joints_[joint].sound = sound;
    if (in_system(joint)) system_->soften_joint(joint_in_system_[joint], sound);
}

void LaneSolver::set_asleep(std::size_t body, bool asleep) {
    bodies_[body].asleep = asleep;
    boxes_.set_asleep(static_cast<std::uint32_t>(body), asleep);
    stale_ = true;
}

std::vector<BodyId> LaneSolver::touched_asleep() const {
    std::vector<BodyId> touched;
    for_each_touching(*this, [&](std::uint32_t a, std::uint32_t b, const auto&) {
        if (bodies_[a].asleep != bodies_[b].asleep) touched.emplace_back(bodies_[a].asleep ? a : b);
    });
    return touched;
}

void LaneSolver::place(std::size_t body, const SolverState& state) {
    bodies_[body].start = state;
    if (in_system_body(body)) system_->set_state(body, state);
    boxes_.move(static_cast<std::uint32_t>(body));
    structure_contacts_.move(body);
}

void LaneSolver::apply(std::size_t body, const Wrench& wrench) {
    if (!in_system_body(body)) lay_out();
    if (const int rail = bodies_[body].parts.rail; rail >= 0) {
        std::array<double, 3> along{};
        along[static_cast<std::size_t>(rail)] = wrench.force[rail];
        system_->add_force(body, along, {});
        return;
    }
    system_->add_force(body, {wrench.force.x(), wrench.force.y(), wrench.force.z()},
                       {wrench.moment.x(), wrench.moment.y(), wrench.moment.z()});
}

BodyState LaneSolver::state(std::size_t body) const {
    return in_system_body(body) ? body_state(system_->motions()[body]) : body_state(bodies_[body].start);
}

void LaneSolver::set_water(std::size_t body, const CarriedWater& water) {
    bodies_[body].parts.water = water;
    if (!stale_ && in_system_body(body)) system_->set_water(body, water);  // a new system takes it from `parts`
}

JointReaction LaneSolver::reaction(std::size_t joint) const {
    if (!in_system(joint)) return {};
    const auto [force, moment] = system_->reaction(joint_in_system_[joint]);
    return {.axial = force[0],
            .shear_vertical = force[1],
            .shear_in_plane = force[2],
            .torsion = moment[0],
            .in_plane_bending = moment[1],
            .bending = moment[2]};
}

bool LaneSolver::in_system(std::size_t joint) const {
    return joint < joint_in_system_.size() && joint_in_system_[joint] != not_in_system;
}

void LaneSolver::lay_out() {
    std::vector<SolverBody> bodies;
    for (const Body& body : bodies_) {
        bodies.push_back(body.parts);
        bodies.back().water = {};  // see below
        if (!body.asleep) continue;
        bodies.back() = {};
        bodies.back().half_extent = body.parts.half_extent;
        bodies.back().crushing_pressure = body.parts.crushing_pressure;
    }
    std::vector<SolverJoint> awake;
    joint_in_system_.assign(joints_.size(), not_in_system);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (bodies_[joints_[i].a].asleep) continue;
        joint_in_system_[i] = awake.size();
        awake.push_back(joints_[i]);
    }
    const std::optional<LaneSystem> before = std::move(system_);
    system_.emplace(bodies, awake, width_, definition_.solver);
    if (before) system_->take_over(*before);
    for (std::size_t i = before ? before->body_count() : 0; i < bodies_.size(); ++i)
        system_->set_state(i, bodies_[i].start);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (removed_[i] && in_system(i)) system_->remove_joint(joint_in_system_[i]);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (moves(static_cast<std::uint32_t>(i)) && bodies_[i].parts.water != CarriedWater{})
            system_->set_water(i, bodies_[i].parts.water);
    }
    stale_ = false;
    contacts_.reserve(4 * bodies_.size());
    last_.reserve(4 * bodies_.size());
    sources_.reserve(4 * bodies_.size());
}

void LaneSolver::push_apart() {
    if (!system_->pushed()) return;
    boxes_.distrust();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        std::array<double, 6> push = system_->push(i);
        for (std::size_t k = 0; k < 6 && bodies_[i].parts.rail >= 0; ++k)
            if (k != static_cast<std::size_t>(bodies_[i].parts.rail)) push[k] = 0;
        if (push == std::array<double, 6>{}) continue;
        system_->set_state(i, pushed(system_->state(i), push, definition_.time_step));
        structure_contacts_.distrust(i);
    }
}

void LaneSolver::step(std::deque<btRigidBody>& bodies) {
    if (stale_) lay_out();
    if (structure_) system_->set_state(*structure_, state_of(bodies[*structure_]));
    boxes_.find(system_->motions());
    if (structure_) structure_contacts_.find(bodies, system_->motions(), *structure_);
    system_->prepare(definition_.time_step);
    read_contacts();
    sweeps_ = system_->solve(contacts_, definition_.contact, {definition_.iterations, definition_.tolerance});
    write_contacts();
    push_apart();
    system_->advance();
}

}  // namespace floes
