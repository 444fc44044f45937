// Bullet's own world, whole: btDiscreteDynamicsWorld with its sequential impulses and btFixedConstraint, as the paper
// computed, with an order of the solve that is a function of ids alone.

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btPoolAllocator.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <tuple>
#include <vector>

#include "world/bullet_shapes.hpp"
#include "world/definitions.hpp"
#include "world/engine.hpp"
#include "world/state.hpp"

namespace floes {
namespace {

// Which bodies may collide in the stock solver's world: not those of one piece.

// Every body carries its BodyId and its piece in the two integers that Bullet leaves to its user.
int body_id_of(const btCollisionObject& object) {
    return object.getUserIndex();
}

bool same_piece(const btCollisionObject& a, const btCollisionObject& b) {
    return a.getUserIndex2() >= 0 && a.getUserIndex2() == b.getUserIndex2();
}

/// Asked again every step for every pair that the broad phase finds, so that a changed piece acts in the next step.
class PieceDispatcher final : public btCollisionDispatcher {
  public:
    /// The list of manifolds is as long as their pool from the beginning, so that steps take no memory.
    explicit PieceDispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
        m_manifoldsPtr.reserve(configuration->getPersistentManifoldPool()->getMaxCount());
    }

    bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override {
        return !same_piece(*a, *b) && btCollisionDispatcher::needsCollision(a, b);
    }
};

// Bullet's world with a solve whose order is a function of ids alone.
//
// Stock Bullet sorts joints by simulation island with an unstable sort, and takes contacts in the order of a
// list that removal scrambles: both depend on all that happened before. Here all is one group, joints come in the order
// in which they were added, and contact manifolds are sorted by (body, body, child shape, child shape).

class OrderedDynamicsWorld final : public btDiscreteDynamicsWorld {
  public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

    /// Takes the joint out and keeps the order of the others (removeConstraint puts the last in its place).
    void remove_in_order(btTypedConstraint* joint) {
        const int position = m_constraints.findLinearSearch(joint);
        for (int i = position; i + 1 < m_constraints.size(); ++i) m_constraints[i] = m_constraints[i + 1];
        m_constraints.pop_back();
    }

    /// The contact manifolds of the last solve in their order. Valid until the next step.
    std::span<btPersistentManifold* const> solved_manifolds() const { return manifolds_; }

  private:
    void calculateSimulationIslands() override {}

    void solveConstraints(btContactSolverInfo& info) override {
        collect_manifolds();
        const int joints = m_constraints.size();
        const int manifolds = static_cast<int>(manifolds_.size());
        m_constraintSolver->solveGroup(
            &m_collisionObjects[0], m_collisionObjects.size(), manifolds > 0 ? manifolds_.data() : nullptr, manifolds,
            joints > 0 ? &m_constraints[0] : nullptr, joints, info, m_debugDrawer, getDispatcher());
    }

    void collect_manifolds() {
        entries_.clear();
        const btDispatcher& dispatcher = *getDispatcher();
        for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
            btPersistentManifold* const manifold = const_cast<btDispatcher&>(dispatcher).getManifoldByIndexInternal(i);
            const btCollisionObject& a = *manifold->getBody0();
            const btCollisionObject& b = *manifold->getBody1();
            // The manifold of two bodies that became one piece is no longer updated: its old contacts must not act.
            if (same_piece(a, b)) manifold->clearManifold();
            if (manifold->getNumContacts() == 0) continue;
            const btManifoldPoint& first = manifold->getContactPoint(0);
            entries_.push_back({{body_id_of(a), body_id_of(b), first.m_index0, first.m_index1}, manifold});
        }
        std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
        manifolds_.clear();
        for (const Entry& entry : entries_) manifolds_.push_back(entry.manifold);
    }

    struct Entry {
        std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t> key;
        btPersistentManifold* manifold;
    };
    std::vector<Entry> entries_;
    std::vector<btPersistentManifold*> manifolds_;
};

// A joint in Bullet and what it reports.

btTransform frame_in(const btRigidBody& body, const JointDefinition& definition) {
    return body.getWorldTransform().inverse() * to_bullet(Pose{definition.pivot, definition.frame});
}

class FixedJoint {
  public:
    FixedJoint(const JointDefinition& definition, btRigidBody& a, btRigidBody& b)
        : constraint_(a, b, frame_in(a, definition), frame_in(b, definition)) {
        // Set for all six axes: Bullet uses the first row's CFM for every axis without one of its own.
        for (int axis = 0; axis < 6; ++axis) {
            constraint_.setParam(BT_CONSTRAINT_STOP_CFM, definition.cfm, axis);
            constraint_.setParam(BT_CONSTRAINT_STOP_ERP, definition.erp, axis);
        }
        constraint_.setJointFeedback(&feedback_);
    }

    FixedJoint(const FixedJoint&) = delete;  // the constraint holds the address of the feedback
    FixedJoint& operator=(const FixedJoint&) = delete;

    btTypedConstraint* constraint() { return &constraint_; }

    /// From the last solve, at the pivot, in the joint's frame at that solve.
    JointReaction reaction() const {
        // The feedback is in world axes, the torque about the centre of mass of a. The constraint keeps the transform
        // with which it was solved; the body's own has moved on.
        const btMatrix3x3& frame = constraint_.getCalculatedTransformA().getBasis();
        const btTransform& offset = constraint_.getFrameOffsetA();
        const btVector3 arm = frame * (offset.getOrigin() * offset.getBasis());  // v * M is Mᵀ v
        const btVector3& world_force = feedback_.m_appliedForceBodyA;
        const btVector3 force = world_force * frame;
        const btVector3 moment = (feedback_.m_appliedTorqueBodyA - arm.cross(world_force)) * frame;
        return {.axial = force.x(),
                .shear_vertical = force.y(),
                .shear_in_plane = force.z(),
                .torsion = moment.x(),
                .in_plane_bending = moment.y(),
                .bending = moment.z()};
    }

  private:
    btFixedConstraint constraint_;
    btJointFeedback feedback_{};
};

/// Joints take their ERP and CFM from their own definition; of these only m_erp2 concerns contacts (m_erp is that of
/// joints without one). A penetration is corrected by m_erp2 in the velocity impulse, so that the contact force
/// contains the correction, unless split impulse is on and the penetration is deeper than the threshold.
void set_up(btContactSolverInfo& info, const WorldDefinition& definition) {
    info.m_numIterations = definition.iterations;
    info.m_erp2 = definition.contact.erp;
    info.m_splitImpulse = definition.contact.split_impulse ? 1 : 0;
    info.m_splitImpulsePenetrationThreshold = -definition.contact.split_impulse_depth;
    info.m_solverMode = SOLVER_USE_WARMSTARTING | SOLVER_SIMD;  // without the first, contact forces are not kept
}

/// Removes the overlapping pairs one by one. Bullet would search all of them for each body, in a time that grows as the
/// square of the number of bodies.
void remove_pairs(btBroadphaseInterface& broadphase, btDispatcher& dispatcher) {
    btOverlappingPairCache& pairs = *broadphase.getOverlappingPairCache();
    for (int left = pairs.getNumOverlappingPairs(); left > 0; left = pairs.getNumOverlappingPairs()) {
        const btBroadphasePair& last = pairs.getOverlappingPairArrayPtr()[left - 1];
        pairs.removeOverlappingPair(last.m_pProxy0, last.m_pProxy1, &dispatcher);
    }
}

/// Which solid touches: only the structure has several.
int solid_at(const btPersistentManifold& manifold, const btManifoldPoint& point) {
    if (manifold.getBody0()->getCollisionShape()->isCompound()) return point.m_index0;
    return manifold.getBody1()->getCollisionShape()->isCompound() ? point.m_index1 : -1;
}

class BulletEngine final : public Engine {
  public:
    explicit BulletEngine(const WorldDefinition& definition)
        : definition_(definition), friction_(material_friction(definition.contact)) {
        set_up(world_.getSolverInfo(), definition);
        world_.setGravity({0, -definition.gravity, 0});
        world_.setForceUpdateAllAabbs(false);  // fixed boxes do not move
    }

    ~BulletEngine() override { remove_pairs(broadphase_, dispatcher_); }

    void add_body(const ElementDefinition& body, std::optional<int> rail) override {
        IceShape& shape = shapes_.emplace_back(body.corners, body.half_thickness);
        btRigidBody::btRigidBodyConstructionInfo parts(body.mass, nullptr, &shape.convex());
        if (body.mass > 0 && !rail) parts.m_localInertia = shape.inertia(body.mass);
        parts.m_startWorldTransform = to_bullet(body.pose);
        parts.m_friction = friction_.ice;
        btRigidBody& added = add(parts, 0);
        if (rail) {
            btVector3 along(0, 0, 0);
            along[*rail] = 1;
            added.setLinearFactor(along);
            added.setFlags(BT_DISABLE_WORLD_GRAVITY);
        }
        world_.addRigidBody(&added);
        added.setUserIndex2(rail ? sheet_piece : body.piece);
    }

    void add_structure(std::span<const ConvexSolid> solids, const Pose& pose) override {
        for (const ConvexSolid& solid : solids) {
            SolidShape& shape = solids_.emplace_back(solid);
            structure_shape_.addChildShape(shape.place(), &shape);
        }
        btRigidBody::btRigidBodyConstructionInfo parts(0, nullptr, &structure_shape_);
        parts.m_startWorldTransform = to_bullet(pose);
        parts.m_friction = friction_.structure;
        structure_ = &add(parts, btCollisionObject::CF_KINEMATIC_OBJECT);
        world_.addRigidBody(structure_);
        structure_->setUserIndex2(sheet_piece);
    }

    /// Not setCenterOfMassTransform: that would also move what Bullet takes the velocity from.
    void move_structure(const Pose& pose) override { structure_->setWorldTransform(to_bullet(pose)); }

    void add_joint(const JointDefinition& joint) override {
        joints_.push_back(std::make_unique<FixedJoint>(joint, body(joint.a), body(joint.b)));
        world_.addConstraint(joints_.back()->constraint());
    }

    void remove_joint(JointId joint) override {
        std::unique_ptr<FixedJoint>& removed = joints_[joint.index()];
        if (!removed) return;
        world_.remove_in_order(removed->constraint());
        removed.reset();
    }

    void set_piece(BodyId id, int piece) override { body(id).setUserIndex2(piece); }

    void place(BodyId id, const BodyState& state) override {
        btRigidBody& placed = body(id);
        const btTransform transform(to_bullet(state.rotation), to_bullet(state.position));
        placed.setWorldTransform(transform);
        placed.setInterpolationWorldTransform(transform);  // what Bullet takes the structure's velocity from
        placed.setLinearVelocity(to_bullet(state.velocity));
        placed.setAngularVelocity(to_bullet(state.angular_velocity));
        placed.setInterpolationLinearVelocity(placed.getLinearVelocity());
        placed.setInterpolationAngularVelocity(placed.getAngularVelocity());
        placed.updateInertiaTensor();
        if (dispatcher_.getNumManifolds() > 0) {  // contacts: there are none before the first step
            broadphase_.getOverlappingPairCache()->cleanProxyFromPairs(placed.getBroadphaseHandle(), &dispatcher_);
        }
        world_.updateSingleAabb(&placed);
    }

    void apply(BodyId id, const Wrench& wrench) override {
        body(id).applyCentralForce(to_bullet(wrench.force));
        body(id).applyTorque(to_bullet(wrench.moment));
    }

    void step() override {
        world_.stepSimulation(definition_.time_step, 0);  // 0: this step as it is, no sub-steps
        read_contacts();
    }

    BodyState state(BodyId id) const override {
        const btRigidBody& source = bodies_[id.index()];
        const btTransform& transform = source.getWorldTransform();
        return {.position = from_bullet(transform.getOrigin()),
                .rotation = from_bullet(transform.getBasis()),
                .velocity = from_bullet(source.getLinearVelocity()),
                .angular_velocity = from_bullet(source.getAngularVelocity())};
    }

    JointReaction reaction(JointId joint) const override {
        const std::unique_ptr<FixedJoint>& live = joints_[joint.index()];
        return live ? live->reaction() : JointReaction{};
    }

    std::span<const SolverContact> contacts() const override { return contacts_; }
    int sweeps() const override { return definition_.iterations; }

  private:
    btRigidBody& body(BodyId id) { return bodies_[id.index()]; }

    /// Worlds in different threads share one datum, which is never read: Bullet's counter of bodies.
    btRigidBody& add(const btRigidBody::btRigidBodyConstructionInfo& parts, int flags) {
        const auto number = static_cast<int>(bodies_.size());
        btRigidBody& added = bodies_.emplace_back(parts);
        added.setCollisionFlags(added.getCollisionFlags() | flags);
        added.setActivationState(DISABLE_DEACTIVATION);  // floes as slow as the tow would fall asleep
        added.setUserIndex(number);
        return added;
    }

    /// Needs SOLVER_USE_WARMSTARTING (else Bullet does not keep the impulses) and one friction direction.
    void read_contacts() {
        contacts_.clear();
        for (const btPersistentManifold* manifold : world_.solved_manifolds()) {
            for (int i = 0; i < manifold->getNumContacts(); ++i) {
                const btManifoldPoint& point = manifold->getContactPoint(i);
                contacts_.push_back({.a = static_cast<std::uint32_t>(body_id_of(*manifold->getBody0())),
                                     .b = static_cast<std::uint32_t>(body_id_of(*manifold->getBody1())),
                                     .on_a = array_of(point.getPositionWorldOnA()),
                                     .on_b = array_of(point.getPositionWorldOnB()),
                                     .normal = array_of(point.m_normalWorldOnB),
                                     .distance = point.getDistance(),
                                     .friction = point.m_combinedFriction,
                                     .impulse = point.m_appliedImpulse,
                                     .slide = array_of(point.m_lateralFrictionDir1),
                                     .friction_impulse = point.m_appliedImpulseLateral1,
                                     .solid = solid_at(*manifold, point)});
            }
        }
    }

    // Members are destroyed in reverse order: the world before what it refers to.
    WorldDefinition definition_;
    MaterialFriction friction_;
    btDefaultCollisionConfiguration configuration_;
    PieceDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    std::deque<IceShape> shapes_;
    std::deque<SolidShape> solids_;
    btCompoundShape structure_shape_;
    std::deque<btRigidBody> bodies_;
    btRigidBody* structure_ = nullptr;
    std::vector<std::unique_ptr<FixedJoint>> joints_;  // null once removed
    OrderedDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<SolverContact> contacts_;  // of the last step
};

}  // namespace

std::unique_ptr<Engine> make_bullet_engine(const WorldDefinition& definition) {
    return std::make_unique<BulletEngine>(definition);
}

}  // namespace floes
