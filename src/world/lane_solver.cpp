#include "world/lane_solver.hpp"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btTransformUtil.h>

#include "solver/lane_width.hpp"
#include "world/conversion.hpp"
#include "world/piece_dispatcher.hpp"

namespace floes {

namespace {

std::array<double, 3> array_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

std::array<double, 9> rows_of(const btMatrix3x3& m) {
    return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

btVector3 vector_of(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

SolverFrame frame_in(const btRigidBody& body, const JointDefinition& joint) {
    const btTransform frame = body.getWorldTransform().inverse() * to_bullet(Pose{joint.pivot, joint.frame});
    return {rows_of(frame.getBasis()), array_of(frame.getOrigin())};
}

const btRigidBody& rigid(const btCollisionObject* object) {
    return static_cast<const btRigidBody&>(*object);
}

btRigidBody& rigid(btCollisionObject* object) {
    return static_cast<btRigidBody&>(*object);
}

SolverState state_of(const btRigidBody& body) {
    const btTransform& pose = body.getWorldTransform();
    return {array_of(pose.getOrigin()), rows_of(pose.getBasis()), array_of(body.getLinearVelocity()),
            array_of(body.getAngularVelocity())};
}

/// Of a box; zero for other shapes.
std::array<double, 3> half_extent(const btRigidBody& body) {
    if (body.getCollisionShape()->getShapeType() != BOX_SHAPE_PROXYTYPE) return {};
    return array_of(static_cast<const btBoxShape*>(body.getCollisionShape())->getHalfExtentsWithMargin());
}

bool moves(const btRigidBody& body) {
    return body.getInvMass() > 0 && body.isActive();
}

bool solvable(const btPersistentManifold& manifold) {
    return moves(rigid(manifold.getBody0())) || moves(rigid(manifold.getBody1()));
}

/// Crushing needs overlap: a point without any exerts nothing. Rigid contacts act before they touch.
bool acts(const btManifoldPoint& point, const ContactLaw& law) {
    return law.normal == NormalLaw::rigid || point.getDistance() < 0;
}

/// With the cone a point remembers here which contact it was in the last solve, counted from 1; 0: none. Bullet keeps
/// this number while the point lasts, and a new point has 0. The direction of friction it does not keep.
double& number_in_last_solve(btManifoldPoint& point) {
    return point.m_appliedImpulseLateral2;
}

constexpr std::size_t not_in_system = static_cast<std::size_t>(-1);

}  // namespace

LaneSolver::LaneSolver(const ContactLaw& law, int lanes, SolverKind solver)
    : law_(law), width_(lane_kernels(lanes > 0 ? lanes : lane_widths().back()).width), solver_(solver) {}

void LaneSolver::add_joint(const JointDefinition& definition, const btRigidBody& a, const btRigidBody& b) {
    joints_.push_back({static_cast<std::uint32_t>(definition.a.index()),
                       static_cast<std::uint32_t>(definition.b.index()), frame_in(a, definition),
                       frame_in(b, definition), definition.cfm, definition.erp, definition.spring});
    removed_.push_back(false);
    stale_ = true;
}

void LaneSolver::remove_joint(std::size_t joint) {
    removed_[joint] = true;
    if (in_system(joint)) system_->remove_joint(joint_in_system_[joint]);
}

void LaneSolver::place(std::size_t body, const btRigidBody& state) {
    if (system_ && body < system_->body_count()) system_->set_state(body, state_of(state));
}

void LaneSolver::set_water(std::size_t body, const CarriedWater& water) {
    waters_[body] = water;
    if (system_ && body < system_->body_count()) system_->set_water(body, water);
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

void LaneSolver::lay_out(std::span<btCollisionObject* const> bodies) {
    std::vector<SolverBody> solver_bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const btRigidBody& body = rigid(bodies[i]);
        SolverBody& added = solver_bodies.emplace_back();
        if (moves(body)) added = {body.getInvMass(), array_of(body.getInvInertiaDiagLocal()), {}};
        added.half_extent = half_extent(body);
        added.crushing_pressure = crushing_pressures_[i];
    }
    std::vector<SolverJoint> awake;
    joint_in_system_.assign(joints_.size(), not_in_system);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (!rigid(bodies[joints_[i].a]).isActive()) continue;
        joint_in_system_[i] = awake.size();
        awake.push_back(joints_[i]);
    }
    system_.emplace(solver_bodies, awake, width_, solver_);
    for (std::size_t i = 0; i < bodies.size(); ++i) system_->set_state(i, state_of(rigid(bodies[i])));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        if (removed_[i] && in_system(i)) system_->remove_joint(joint_in_system_[i]);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (moves(rigid(bodies[i])) && waters_[i] != CarriedWater{}) system_->set_water(i, waters_[i]);
    }
    stale_ = false;
}

void LaneSolver::read_forces(std::span<btCollisionObject* const> bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const btRigidBody& body = rigid(bodies[i]);
        if (body.isKinematicObject()) system_->set_state(i, state_of(body));
        if (!moves(body)) continue;
        const btVector3 weight = body.getGravity() / body.getInvMass();
        system_->set_force(i, array_of(body.getTotalForce() + weight), array_of(body.getTotalTorque()));
    }
}

void LaneSolver::read_contacts(std::span<btPersistentManifold* const> manifolds, const btContactSolverInfo& info) {
    const bool cone = law_.friction == Friction::cone;
    if (cone) last_.swap(contacts_);
    // Cones start from the whole impulse, or contacts near sliding creep.
    const double kept = cone ? 1.0 : info.m_warmstartingFactor;
    contacts_.clear();
    for (btPersistentManifold* manifold : manifolds) {
        if (!solvable(*manifold)) continue;
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            btManifoldPoint& point = manifold->getContactPoint(i);
            if (!acts(point, law_)) continue;
            contacts_.push_back({.a = static_cast<std::uint32_t>(body_id_of(*manifold->getBody0())),
                                 .b = static_cast<std::uint32_t>(body_id_of(*manifold->getBody1())),
                                 .on_a = array_of(point.getPositionWorldOnA()),
                                 .on_b = array_of(point.getPositionWorldOnB()),
                                 .normal = array_of(point.m_normalWorldOnB),
                                 .distance = point.getDistance(),
                                 .friction = point.m_combinedFriction,
                                 .impulse = point.m_appliedImpulse * kept});
            if (!cone) continue;
            if (const auto number = static_cast<std::size_t>(number_in_last_solve(point)); number > 0) {
                const SolverContact& last = last_[number - 1];
                contacts_.back().slide = last.slide;
                contacts_.back().friction_impulse = last.friction_impulse;
            }
        }
    }
}

void LaneSolver::write_contacts(std::span<btPersistentManifold* const> manifolds) const {
    const bool cone = law_.friction == Friction::cone;
    std::size_t at = 0;
    for (btPersistentManifold* manifold : manifolds) {
        const bool solved = solvable(*manifold);
        for (int i = 0; cone && !solved && i < manifold->getNumContacts(); ++i) {
            number_in_last_solve(manifold->getContactPoint(i)) = 0;
        }
        if (!solved) continue;
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            btManifoldPoint& point = manifold->getContactPoint(i);
            if (!acts(point, law_)) {
                point.m_appliedImpulse = 0;
                point.m_appliedImpulseLateral1 = 0;
                number_in_last_solve(point) = 0;
                continue;
            }
            if (cone) number_in_last_solve(point) = static_cast<double>(at + 1);
            point.m_appliedImpulse = contacts_[at].impulse;
            point.m_appliedImpulseLateral1 = contacts_[at].friction_impulse;
            point.m_lateralFrictionDir1 = vector_of(contacts_[at].slide);
            ++at;
        }
    }
}

void LaneSolver::push_apart(std::span<btCollisionObject* const> bodies, const btContactSolverInfo& info) {
    if (!system_->pushed()) return;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const std::array<double, 6> push = system_->push(i);
        if (push == std::array<double, 6>{}) continue;
        SolverState state = system_->state(i);
        btTransform pose;
        btTransformUtil::integrateTransform(rigid(bodies[i]).getWorldTransform(), {push[0], push[1], push[2]},
                                            btVector3(push[3], push[4], push[5]) * info.m_splitImpulseTurnErp,
                                            info.m_timeStep, pose);
        state.position = array_of(pose.getOrigin());
        state.rotation = rows_of(pose.getBasis());
        system_->set_state(i, state);
    }
}

void LaneSolver::write_bodies(std::span<btCollisionObject* const> bodies) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        btRigidBody& body = rigid(bodies[i]);
        if (!moves(body)) continue;
        const auto [position, r, velocity, angular_velocity] = system_->state(i);
        body.setWorldTransform(
            btTransform(btMatrix3x3(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]), vector_of(position)));
        body.setLinearVelocity(vector_of(velocity));
        body.setAngularVelocity(vector_of(angular_velocity));
        body.clearForces();
    }
}

btScalar LaneSolver::solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                                int manifold_count, btTypedConstraint**, int, const btContactSolverInfo& info,
                                btIDebugDraw*, btDispatcher*) {
    const std::span<btCollisionObject* const> all(bodies, static_cast<std::size_t>(body_count));
    const std::span<btPersistentManifold* const> touching(manifolds, static_cast<std::size_t>(manifold_count));
    if (stale_ || system_->body_count() != all.size()) lay_out(all);
    read_forces(all);
    system_->prepare(info.m_timeStep);
    read_contacts(touching, info);
    system_->solve(contacts_, law_, info.m_numIterations);
    write_contacts(touching);
    push_apart(all, info);
    system_->advance();
    write_bodies(all);
    return 0;
}

}  // namespace floes
