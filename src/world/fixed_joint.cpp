#include "world/fixed_joint.hpp"

#include "world/conversion.hpp"

namespace floes {

namespace {

btTransform frame_in(const btRigidBody& body, const JointDefinition& definition) {
    return body.getWorldTransform().inverse() * to_bullet(Pose{definition.pivot, definition.frame});
}

}  // namespace

FixedJoint::FixedJoint(const JointDefinition& definition, btRigidBody& a, btRigidBody& b)
    : constraint_(a, b, frame_in(a, definition), frame_in(b, definition)) {
    // Set for all six axes: Bullet uses the first row's CFM for every axis without one of its own.
    for (int axis = 0; axis < 6; ++axis) {
        constraint_.setParam(BT_CONSTRAINT_STOP_CFM, definition.cfm, axis);
        constraint_.setParam(BT_CONSTRAINT_STOP_ERP, definition.erp, axis);
    }
    constraint_.setJointFeedback(&feedback_);
}

JointReaction FixedJoint::reaction() const {
    // The feedback is in world axes, the torque about the centre of mass of a. The constraint keeps the transform with
    // which it was solved; the body's own has moved on.
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

}  // namespace floes
