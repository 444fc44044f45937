#pragma once
// Bullet's constraint solver replaced by ours (solver/lane_system.hpp): joints are not Bullet's at all, contacts come
// as Bullet's manifolds and get their impulses back. Only for files inside this room.

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <optional>
#include <span>
#include <vector>

#include "solver/lane_system.hpp"
#include "world/definitions.hpp"
#include "world/state.hpp"

namespace floes {

class LaneSolver final : public btSequentialImpulseConstraintSolver {
  public:
    /// law: of all contacts; the coefficients of friction come with each. lanes: floes side by side at most, one of
    /// lane_widths(); 0: as many as the processor has. solver: lanes or direct.
    LaneSolver(const ContactLaw& law, int lanes, SolverKind solver);

    /// Bodies are numbered from 0 in the order in which they are added. crushing_pressure: Pa; 0: that of the law.
    void add_body(double crushing_pressure) {
        crushing_pressures_.push_back(crushing_pressure);
        waters_.emplace_back();
    }

    /// Water that the body carries from the next solve on; with the direct solver only.
    void set_water(std::size_t body, const CarriedWater& water);

    /// Joints are numbered from 0 in the order in which they are added, and solved in that order within a floe.
    void add_joint(const JointDefinition& definition, const btRigidBody& a, const btRigidBody& b);
    void remove_joint(std::size_t joint);

    /// A body fell asleep or woke: from the next solve on. Bodies that sleep (Bullet's isActive is false) are fixed in
    /// place, and their joints are left out.
    void lay_out_anew() { stale_ = true; }

    /// Tells the solver a pose and velocity of the body that it did not compute itself.
    void place(std::size_t body, const btRigidBody& state);

    /// Of the last solve; zero before it and after removal.
    JointReaction reaction(std::size_t joint) const;

    /// Solves, and moves the bodies to the end of the step. bodies: all of the world, each at the place of its id;
    /// their pose and velocity are read once, from then on only the force (weight apart) and what kinematic bodies do.
    /// Bullet's own joints are not solved.
    btScalar solveGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                        int manifold_count, btTypedConstraint** joints, int joint_count,
                        const btContactSolverInfo& info, btIDebugDraw* draw, btDispatcher* dispatcher) override;

  private:
    bool in_system(std::size_t joint) const;
    void lay_out(std::span<btCollisionObject* const> bodies);
    void read_forces(std::span<btCollisionObject* const> bodies);
    void read_contacts(std::span<btPersistentManifold* const> manifolds, const btContactSolverInfo& info);
    void write_contacts(std::span<btPersistentManifold* const> manifolds) const;
    void push_apart(std::span<btCollisionObject* const> bodies, const btContactSolverInfo& info);
    void write_bodies(std::span<btCollisionObject* const> bodies) const;

    ContactLaw law_;
    int width_;
    SolverKind solver_;
    std::vector<double> crushing_pressures_;  ///< by body
    std::vector<CarriedWater> waters_;        ///< likewise
    std::vector<SolverJoint> joints_;
    std::vector<bool> removed_;
    std::optional<LaneSystem> system_;          ///< of the bodies and joints there were when it was laid out
    std::vector<std::size_t> joint_in_system_;  ///< of every joint; not_in_system while its floe sleeps
    bool stale_ = true;                         ///< bodies, joints or who sleeps have changed since then
    std::vector<SolverContact> contacts_;
    std::vector<SolverContact> last_;  ///< of the solve before, for the friction that the cone starts from
};

}  // namespace floes
