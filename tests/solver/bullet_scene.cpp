#include "solver/bullet_scene.hpp"

#include <cmath>

namespace floes::testing {

void OneGroupWorld::solveConstraints(btContactSolverInfo& info) {
    manifolds.clear();
    for (int i = 0; i < getDispatcher()->getNumManifolds(); ++i) {
        btPersistentManifold* manifold = getDispatcher()->getManifoldByIndexInternal(i);
        if (manifold->getNumContacts() > 0) manifolds.push_back(manifold);
    }
    const int joints = getNumConstraints();
    m_constraintSolver->solveGroup(&m_collisionObjects[0], m_collisionObjects.size(), manifolds.data(),
                                   static_cast<int>(manifolds.size()), joints > 0 ? &m_constraints[0] : nullptr, joints,
                                   info, nullptr, getDispatcher());
}

BulletScene::BulletScene(const SceneOptions& options) {
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_numIterations = iterations;
    info.m_splitImpulsePenetrationThreshold = -options.split_depth;
    world_.setGravity({0, 0, 0});

    for (int i = 0; i < options.floes; ++i) {
        const double yaw = 0.04 * i;
        const btTransform pose(btQuaternion(btVector3(0, 1, 0), yaw),
                               btVector3(0.64 * i, 0.004 * (i % 3), 0.05 * (i % 2)));
        add_floe(pose, options.cfm);
    }
    btTransform at(btQuaternion::getIdentity(), btVector3(0.64 * options.floes + 0.3, 0, 0));
    add_box(wall_, 0, at);
    at.setOrigin({-0.85, 0, 0});
    pusher_ = &add_box(wall_, 0, at);
    pusher_->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
}

btRigidBody& BulletScene::add_box(btBoxShape& shape, double mass, const btTransform& pose) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform = pose;
    info.m_friction = std::sqrt(0.3);
    bodies.push_back(std::make_unique<btRigidBody>(info));
    bodies.back()->setActivationState(DISABLE_DEACTIVATION);
    bodies.back()->setUserIndex(static_cast<int>(bodies.size()) - 1);
    world_.addRigidBody(bodies.back().get());
    return *bodies.back();
}

void BulletScene::add_floe(const btTransform& pose, double cfm) {
    const std::size_t first = bodies.size();
    for (int i = 0; i < 9; ++i) {
        add_box(element_, 1.2276,
                pose * btTransform(btQuaternion::getIdentity(), btVector3(0.2 * (i % 3 - 1), 0, 0.2 * (i / 3 - 1))));
    }
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t k = 0; k < i; ++k) bodies[first + i]->setIgnoreCollisionCheck(bodies[first + k].get(), true);
    }
    for (std::size_t i = 0; i < 9; ++i) {
        const btVector3 centre(0.2 * (static_cast<double>(i % 3) - 1), 0, 0.2 * (static_cast<double>(i / 3) - 1));
        const btQuaternion towards_z(btVector3(0, 1, 0), -SIMD_HALF_PI);
        if (i % 3 < 2)
            join(first + i, first + i + 1,
                 pose * btTransform(btQuaternion::getIdentity(), centre + btVector3(0.1, 0, 0)), cfm);
        if (i < 6) join(first + i, first + i + 3, pose * btTransform(towards_z, centre + btVector3(0, 0, 0.1)), cfm);
    }
}

void BulletScene::join(std::size_t a, std::size_t b, const btTransform& frame, double cfm) {
    joints.push_back(std::make_unique<btFixedConstraint>(*bodies[a], *bodies[b],
                                                         bodies[a]->getWorldTransform().inverse() * frame,
                                                         bodies[b]->getWorldTransform().inverse() * frame));
    for (int axis = 0; axis < 6; ++axis) {
        joints.back()->setParam(BT_CONSTRAINT_STOP_CFM, cfm, axis);
        joints.back()->setParam(BT_CONSTRAINT_STOP_ERP, 0.8, axis);
    }
    feedback.push_back(std::make_unique<btJointFeedback>());
    joints.back()->setJointFeedback(feedback.back().get());
    world_.addConstraint(joints.back().get());
}

void BulletScene::step() {
    ++steps_;
    btTransform at(btQuaternion::getIdentity(), btVector3(-0.85 + 0.5 * time_step * steps_, 0, 0));
    pusher_->setWorldTransform(at);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto k = static_cast<double>(i);
        const btVector3 wave(0.2 * std::sin(k), 0.3 * std::cos(2 * k), 0.1 * std::sin(3 * k));
        const btVector3 buoyancy(0, -100 * bodies[i]->getWorldTransform().getOrigin().y(), 0);
        bodies[i]->applyCentralForce(wave + buoyancy - 2 * bodies[i]->getLinearVelocity());
        bodies[i]->applyTorque({0.01 * std::cos(k), 0.005 * std::sin(5 * k), 0.01 * std::sin(2 * k)});
    }
    before_step.clear();
    for (const auto& body : bodies) before_step.push_back(body->getWorldTransform());
    world_.stepSimulation(time_step, 0);
}

namespace {

std::array<double, 9> rows_of(const btMatrix3x3& m) {
    std::array<double, 9> rows{};
    for (int i = 0; i < 9; ++i) rows[static_cast<std::size_t>(i)] = m[i / 3][i % 3];
    return rows;
}

std::array<double, 3> array_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

SolverFrame frame_of(const btTransform& t) {
    return {rows_of(t.getBasis()), array_of(t.getOrigin())};
}

}  // namespace

LaneSystem BulletScene::lane_system(int width) const {
    std::vector<SolverBody> solver_bodies;
    for (const auto& body : bodies)
        solver_bodies.push_back({body->getInvMass(), array_of(body->getInvInertiaDiagLocal())});
    std::vector<SolverJoint> solver_joints;
    for (const auto& joint : joints) {
        const btGeneric6DofSpring2Constraint& j = *joint;
        solver_joints.push_back({static_cast<std::uint32_t>(j.getRigidBodyA().getUserIndex()),
                                 static_cast<std::uint32_t>(j.getRigidBodyB().getUserIndex()),
                                 frame_of(j.getFrameOffsetA()), frame_of(j.getFrameOffsetB()),
                                 j.getParam(BT_CONSTRAINT_STOP_CFM, 0), j.getParam(BT_CONSTRAINT_STOP_ERP, 0),
                                 std::nullopt});
    }
    LaneSystem system(solver_bodies, solver_joints, width);
    for (std::size_t i = 0; i < joints.size(); ++i) {
        if (!joints[i]->isEnabled()) system.remove_joint(i);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const btRigidBody& body = *bodies[i];
        const btTransform& pose = body.getWorldTransform();
        system.set_state(i, {array_of(pose.getOrigin()), rows_of(pose.getBasis()), array_of(body.getLinearVelocity()),
                             array_of(body.getAngularVelocity())});
        system.add_force(i, array_of(body.getTotalForce()), array_of(body.getTotalTorque()));
    }
    system.prepare(time_step);
    return system;
}

std::vector<SolverContact> BulletScene::contacts(std::span<btPersistentManifold*> manifolds) const {
    std::vector<SolverContact> contacts;
    for (btPersistentManifold* manifold : manifolds) {
        for (int i = 0; i < manifold->getNumContacts(); ++i) {
            const btManifoldPoint& point = manifold->getContactPoint(i);
            contacts.push_back({.a = static_cast<std::uint32_t>(manifold->getBody0()->getUserIndex()),
                                .b = static_cast<std::uint32_t>(manifold->getBody1()->getUserIndex()),
                                .on_a = array_of(point.getPositionWorldOnA()),
                                .on_b = array_of(point.getPositionWorldOnB()),
                                .normal = array_of(point.m_normalWorldOnB),
                                .distance = point.getDistance(),
                                .friction = point.m_combinedFriction,
                                .impulse = point.m_appliedImpulse * warm_starting});
        }
    }
    return contacts;
}

ContactLaw BulletScene::law() const {
    const btContactSolverInfo& info = const_cast<OneGroupWorld&>(world_).getSolverInfo();
    return {.erp = info.m_erp2,
            .split_impulse = info.m_splitImpulse != 0,
            .split_impulse_depth = -info.m_splitImpulsePenetrationThreshold};
}

}  // namespace floes::testing
