#pragma once
// A joint in Bullet and what it reports. Only for files inside this module.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>

#include "world/definitions.hpp"
#include "world/state.hpp"

namespace floes {

class FixedJoint {
  public:
    FixedJoint(const JointDefinition& definition, btRigidBody& a, btRigidBody& b);
    FixedJoint(const FixedJoint&) = delete;  // the constraint holds the address of the feedback
    FixedJoint& operator=(const FixedJoint&) = delete;

    btTypedConstraint* constraint() { return &constraint_; }

    /// From the last solve, at the pivot, in the joint's frame at that solve.
    JointReaction reaction() const;

  private:
    btFixedConstraint constraint_;
    btJointFeedback feedback_{};
};

}  // namespace floes
