#include "world/froude_units.hpp"

namespace floes {

WorldDefinition FroudeUnits::to_own(WorldDefinition definition) const {
    definition.time_step /= time_;
    definition.contact.split_impulse_depth /= length_;
    definition.contact.crushing_pressure *= length_ * length_;
    return definition;
}

ElementDefinition FroudeUnits::to_own(ElementDefinition element) const {
    for (Corner& corner : element.corners) corner = {corner.x / length_, corner.z / length_};
    element.half_thickness /= length_;
    element.crushing_pressure *= length_ * length_;
    element.pose = to_own(element.pose);
    return element;
}

FixedBoxDefinition FroudeUnits::to_own(FixedBoxDefinition box) const {
    box.half_extents /= length_;
    box.pose = to_own(box.pose);
    return box;
}

SlidingBoxDefinition FroudeUnits::to_own(SlidingBoxDefinition box) const {
    box.half_extents /= length_;
    box.position = to_own(box.position);
    return box;
}

JointDefinition FroudeUnits::to_own(JointDefinition joint) const {
    joint.pivot /= length_;
    if (joint.spring) {
        for (double& stiffness : joint.spring->force) stiffness *= length_;
        for (double& stiffness : joint.spring->moment) stiffness /= length_;
    }
    return joint;
}

CarriedWater FroudeUnits::to_own(CarriedWater water) const {
    for (double* first : {&water.x, &water.z}) *first /= length_;
    for (double* second : {&water.yaw, &water.xx, &water.xz, &water.zz}) *second /= length_ * length_;
    return water;
}

BodyState FroudeUnits::to_own(const BodyState& state) const {
    return {to_own(state.position), state.rotation, state.velocity / time_, state.angular_velocity * time_};
}

BodyState FroudeUnits::to_si(const BodyState& state) const {
    return {state.position * length_, state.rotation, state.velocity * time_, state.angular_velocity / time_};
}

JointReaction FroudeUnits::to_si(JointReaction reaction) const {
    for (double* moment : {&reaction.torsion, &reaction.in_plane_bending, &reaction.bending}) *moment *= length_;
    return reaction;
}

}  // namespace floes
