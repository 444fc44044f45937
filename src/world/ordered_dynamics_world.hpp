#pragma once
// Bullet's world with a solve whose order is a function of ids alone. Only for files inside this module.
//
// Stock Bullet sorts joints by simulation island with an unstable sort, and takes contacts in the order of a
// list that removal scrambles: both depend on all that happened before. Here all is one group, joints come in the order
// in which they were added, and contact manifolds are sorted by (body, body, child shape, child shape).

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace floes {

class OrderedDynamicsWorld final : public btDiscreteDynamicsWorld {
  public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

    /// Takes the joint out and keeps the order of the others (removeConstraint puts the last in its place).
    void remove_in_order(btTypedConstraint* joint);

    /// The contact manifolds of the last solve in their order. Valid until the next step.
    std::span<btPersistentManifold* const> solved_manifolds() const { return manifolds_; }

  private:
    void calculateSimulationIslands() override {}
    void solveConstraints(btContactSolverInfo& info) override;
    void collect_manifolds();

    struct Entry {
        std::tuple<std::int32_t, std::int32_t, std::int32_t, std::int32_t> key;
        btPersistentManifold* manifold;
    };
    std::vector<Entry> entries_;
    std::vector<btPersistentManifold*> manifolds_;
};

}  // namespace floes
