// What acts at the joints of floes that are polygons.

#include <utility>

#include "ice/stress_field.hpp"

namespace floes {

void StressField::put_prism(std::size_t number, BodyId body, const Corner& axis, PressedPrism prism) {
    if (number == elements_.size()) {
        add_element(body, {});
        elements_[number].prism = prisms_.size();
        prisms_.emplace_back();
    }
    const std::size_t at = elements_[number].prism;
    elements_[number] = made_of(body, {});
    elements_[number].prism = at;
    const Corner size = size_of(prism.corners);
    prisms_[at] = {std::move(prism), axis, size};
}

void StressField::put_prism_joint(std::size_t number, JointId id, std::size_t a, const PrismJoint& at_a, std::size_t b,
                                  const PrismJoint& at_b) {
    const JointAxis axis = at_a.axis() == 0 ? JointAxis::x : JointAxis::z;
    const Joint joint{id, a, b, axis, join_prism(a, number, at_a), join_prism(b, number, at_b)};
    if (number < joints_.size()) {
        joints_[number] = joint;
        live_[number] = true;
        return;
    }
    joints_.push_back(joint);
    live_.push_back(true);
    reactions_.emplace_back();
}

/// The joint's number among those of the prism.
std::size_t StressField::join_prism(std::size_t element, std::size_t joint, const PrismJoint& at) {
    Prism& prism = prisms_[elements_[element].prism];
    prism.ice.joints.push_back(at);
    prism.joints.push_back(joint);
    ++prism.live;
    elements_[element].most_stress = most_contact_stress(prism.ice);
    return prism.joints.size() - 1;
}

void StressField::leave_prisms(const Joint& joint) {
    for (const auto& [element, on] : {std::pair(joint.a, joint.on_a), std::pair(joint.b, joint.on_b)}) {
        Prism& prism = prisms_[elements_[element].prism];
        prism.ice.joints[on].live = false;
        --prism.live;
    }
}

/// Half of the mean over both elements: what the joints on either side of one carry, over its extent along the normal.
/// A side that has joints on a part of it has that part of the moment, as free faces have none.
double StressField::across_in_prism(const Joint& joint, bool at_b) const {
    const Prism& prism = prisms_[elements_[at_b ? joint.b : joint.a].prism];
    const PrismJoint& own = prism.ice.joints[at_b ? joint.on_b : joint.on_a];
    double sum = 0;
    for (std::size_t k = 0; k < prism.joints.size(); ++k)
        if (prism.ice.joints[k].axis() != own.axis()) sum += reactions_[prism.joints[k]].bending;
    return own.length / (own.axis() == 0 ? prism.size.x : prism.size.z) * sum / 4;
}

std::optional<LocalStress> StressField::added_in_prism(const Joint& joint, bool at_b, const Press& press) const {
    const Prism& prism = prisms_[elements_[at_b ? joint.b : joint.a].prism];
    const PrismStress found = contact_stress(prism.ice, press);
    const std::size_t axis = joint.axis == JointAxis::x ? 0 : 1;
    if (found.joint[axis] != (at_b ? joint.on_b : joint.on_a)) return std::nullopt;
    // The joint's z is the floe's where its x is along the floe's x; turned to z, it is the other way.
    return LocalStress{found.stress[axis], found.stress[1 - axis], axis == 0 ? found.shear : -found.shear};
}

}  // namespace floes
