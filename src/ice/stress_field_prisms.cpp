// What acts at the joints of floes that are polygons.

#include <utility>

#include "ice/stress_field.hpp"

namespace floes {

void StressField::add_prism(BodyId body, const Corner& axis, PressedPrism prism) {
    add_element(body, {});
    elements_.back().prism = prisms_.size();
    const Corner size = size_of(prism.corners);
    prisms_.push_back({std::move(prism), axis, size});
}

void StressField::add_prism_joint(JointId id, std::size_t a, const PrismJoint& at_a, std::size_t b,
                                  const PrismJoint& at_b) {
    const std::size_t number = joints_.size();
    const auto join = [&](std::size_t element, const PrismJoint& at) {
        Prism& prism = prisms_[elements_[element].prism];
        prism.ice.joints.push_back(at);
        prism.joints.push_back(number);
        ++prism.live;
        elements_[element].most_stress = most_contact_stress(prism.ice);
        return prism.joints.size() - 1;
    };
    const std::size_t on_a = join(a, at_a);
    const std::size_t on_b = join(b, at_b);
    joints_.push_back({id, a, b, at_a.axis() == 0 ? JointAxis::x : JointAxis::z, on_a, on_b});
    live_.push_back(true);
    reactions_.emplace_back();
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
