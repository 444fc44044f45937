#include "ice/polygon_floe.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

std::shared_ptr<const CutFloe> cut_of(const FloeShape& shape) {
    if (!shape.is_polygon()) return nullptr;
    return std::make_shared<const CutFloe>(cut_into_elements(shape.outline, shape.element));
}

JointSpring polygon_joint(const CutJoint& joint, const FloeShape& shape, const Material& material) {
    return beam_joint(elastic_ice(shape, material), joint.length, joint.span);
}

Quat turned_to(const Corner& axis) {
    // By half the angle φ of (x, z) = (cos φ, -sin φ), from roots only.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + axis.x)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - axis.x)));
    return Quat(cosine, 0, axis.z > 0 ? -sine : sine, 0).normalized();
}

}  // namespace floes
