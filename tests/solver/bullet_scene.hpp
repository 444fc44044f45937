#pragma once
// A small ice field in plain Bullet: floes of 3 x 3 elements with fixed joints, pushed together by a moving box against
// a wall. Each solve of Bullet can be compared with what a LaneSystem makes of the same input.

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <functional>
#include <memory>
#include <vector>

#include "solver/lane_system.hpp"

namespace floes::testing {

/// Bullet's solver, with a look at its input.
class WatchedSolver : public btSequentialImpulseConstraintSolver {
  public:
    std::function<void(std::span<btPersistentManifold*>)> before;

    btScalar solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                        int manifold_count, btTypedConstraint** joints, int joint_count,
                        const btContactSolverInfo& info, btIDebugDraw* draw, btDispatcher* dispatcher) override {
        if (before) before({manifolds, static_cast<std::size_t>(manifold_count)});
        return btSequentialImpulseConstraintSolver::solveGroup(bodies, body_count, manifolds, manifold_count, joints,
                                                               joint_count, info, draw, dispatcher);
    }
};

/// All bodies in one group, joints in the order in which they were added.
class OneGroupWorld : public btDiscreteDynamicsWorld {
  public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
    std::vector<btPersistentManifold*> manifolds;

  private:
    void calculateSimulationIslands() override {}
    void solveConstraints(btContactSolverInfo& info) override;
};

struct SceneOptions {
    int floes = 11;
    double cfm = 0.016;
    double split_depth = 0.04;
};

class BulletScene {
  public:
    explicit BulletScene(const SceneOptions& options);

    void step();

    /// What solves the same step in lanes: system of all bodies and joints, its state set.
    LaneSystem lane_system(int width) const;
    std::vector<SolverContact> contacts(std::span<btPersistentManifold*> manifolds) const;
    ContactLaw law() const;

    static constexpr double time_step = 0.02;
    static constexpr int iterations = 50;
    static constexpr double warm_starting = 0.85;  ///< Bullet's default
    WatchedSolver solver;
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    std::vector<std::unique_ptr<btFixedConstraint>> joints;
    std::vector<std::unique_ptr<btJointFeedback>> feedback;

    std::vector<btTransform> before_step;  ///< pose of each body

    std::span<btPersistentManifold* const> manifolds() const { return world_.manifolds; }

  private:
    btRigidBody& add_box(btBoxShape& shape, double mass, const btTransform& pose);
    void add_floe(const btTransform& pose, double cfm);
    void join(std::size_t a, std::size_t b, const btTransform& frame, double cfm);

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btBoxShape element_{{0.1, 0.0165, 0.1}};
    btBoxShape wall_{{0.5, 0.5, 3}};
    btRigidBody* pusher_ = nullptr;
    int steps_ = 0;
    OneGroupWorld world_{&dispatcher_, &broadphase_, &solver, &configuration_};
};

}  // namespace floes::testing
