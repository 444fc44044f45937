#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "peer.hpp"

namespace floes::bench {

namespace {

btVector3 vector_of(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Vec3 vector_of(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

btTransform transform_of(const Pose& pose) {
    const Quat& q = pose.orientation;
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), vector_of(pose.position));
}

class BulletPeer final : public Peer {
  public:
    explicit BulletPeer(const PeerScene& scene)
        : scene_(scene),
          water_(peer_water(scene.scenario)),
          element_(btVector3(scene.scenario.floe.element, scene.scenario.floe.thickness, scene.scenario.floe.element) /
                   2),
          x_(scene.structure_x) {
        world_.setGravity({0, -scene.scenario.general.gravity, 0});
        world_.getSolverInfo().m_numIterations = scene.scenario.general.iterations;
        const double side = scene.scenario.floe.element;
        const double mass = scene.scenario.ice.density * side * side * scene.scenario.floe.thickness;
        for (const BodyState& state : scene.elements) {
            btRigidBody& body =
                add(element_, mass, transform_of({state.position, Quat(state.rotation)}), scene.friction.ice);
            body.setLinearVelocity(vector_of(state.velocity));
            body.setAngularVelocity(vector_of(state.angular_velocity));
        }
        for (const PeerJoint& joint : scene.joints) add(joint);
        for (const auto& [a, b] : scene.diagonals) at(a).setIgnoreCollisionCheck(&at(b), true);
        for (const IceSheet& sheet : scene.sheets) {
            btBoxShape& shape = boxes_.emplace_back(vector_of(sheet.half_extents));
            add(shape, 0, transform_of({sheet.centre, Quat::Identity()}), scene.friction.ice);
        }
        add_structure();
    }

    ~BulletPeer() override {
        for (btFixedConstraint& joint : joints_) world_.removeConstraint(&joint);
        for (btRigidBody& body : bodies_) world_.removeRigidBody(&body);
    }

    void step() override {
        for (std::size_t i = 0; i < scene_.elements.size(); ++i) {
            btRigidBody& body = bodies_[i];
            const btMatrix3x3& r = body.getWorldTransform().getBasis();
            ElementState state{vector_of(body.getWorldTransform().getOrigin()), Mat3(),
                               vector_of(body.getLinearVelocity()), vector_of(body.getAngularVelocity()),
                               scene_.exposed_edges[i]};
            state.rotation << r[0][0], r[0][1], r[0][2], r[1][0], r[1][1], r[1][2], r[2][0], r[2][1], r[2][2];
            const Wrench wrench = water_.wrench(state, x_);
            body.applyCentralForce(vector_of(wrench.force));
            body.applyTorque(vector_of(wrench.moment));
        }
        const double dt = scene_.scenario.general.time_step;
        x_ += scene_.scenario.structure.speed * dt;
        bodies_.back().setWorldTransform(btTransform(btMatrix3x3::getIdentity(), {x_, 0, 0}));
        world_.stepSimulation(dt, 0);
    }

    int contacts() const override {
        int points = 0;
        for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
            points += const_cast<btCollisionDispatcher&>(dispatcher_).getManifoldByIndexInternal(i)->getNumContacts();
        }
        return points;
    }

    double structure_x() const override { return x_; }

    void set_iterations(int iterations) override { world_.getSolverInfo().m_numIterations = iterations; }

    std::vector<Vec3> velocities() const override {
        std::vector<Vec3> found;
        for (std::size_t i = 0; i < scene_.elements.size(); ++i)
            found.push_back(vector_of(bodies_[i].getLinearVelocity()));
        return found;
    }

  private:
    btRigidBody& at(int i) { return bodies_[static_cast<std::size_t>(i)]; }

    btRigidBody& add(btCollisionShape& shape, double mass, const btTransform& pose, double friction) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape.calculateLocalInertia(mass, inertia);
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
        info.m_startWorldTransform = pose;
        info.m_friction = friction;
        btRigidBody& body = bodies_.emplace_back(info);
        body.setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(&body);
        return body;
    }

    void add(const PeerJoint& joint) {
        btFixedConstraint& constraint =
            joints_.emplace_back(at(joint.a), at(joint.b), transform_of(joint.in_a), transform_of(joint.in_b));
        for (int axis = 0; axis < 6; ++axis) {
            constraint.setParam(BT_CONSTRAINT_STOP_CFM, scene_.scenario.joint.cfm, axis);
            constraint.setParam(BT_CONSTRAINT_STOP_ERP, scene_.scenario.joint.erp, axis);
        }
        world_.addConstraint(&constraint, true);
    }

    void add_structure() {
        constexpr int corners = 32;
        for (const ConvexSolid& solid : scene_.structure) {
            const Frustum& frustum = std::get<Frustum>(solid.form);
            btConvexHullShape& hull = hulls_.emplace_back();
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * std::numbers::pi * i / corners;
                for (const auto& [height, radius] : {std::pair{frustum.bottom_height, frustum.bottom_radius},
                                                     std::pair{frustum.top_height, frustum.top_radius}}) {
                    hull.addPoint({radius * std::cos(angle), height, radius * std::sin(angle)}, false);
                }
            }
            hull.recalcLocalAabb();
            hull.setMargin(0.001);
            structure_.addChildShape(btTransform::getIdentity(), &hull);
        }
        btRigidBody& body =
            add(structure_, 0, btTransform(btMatrix3x3::getIdentity(), {x_, 0, 0}), scene_.friction.structure);
        body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    }

    PeerScene scene_;
    WaterModel water_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btBoxShape element_;
    std::deque<btBoxShape> boxes_;
    std::deque<btConvexHullShape> hulls_;
    btCompoundShape structure_;
    std::deque<btRigidBody> bodies_;  // elements first, the structure last
    std::deque<btFixedConstraint> joints_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    double x_;
};

}  // namespace

std::unique_ptr<Peer> make_bullet(const PeerScene& scene) {
    return std::make_unique<BulletPeer>(scene);
}

}  // namespace floes::bench
