#include "ice/beam_joint.hpp"

namespace floes {

double ElasticIce::flexural_rigidity() const {
    return elastic_modulus * thickness * thickness * thickness / (12 * (1 - poisson_ratio * poisson_ratio));
}

ElasticIce elastic_ice(const FloeShape& shape, const Material& material) {
    return {material.ice.elastic_modulus, material.ice.poisson_ratio, shape.thickness, material.joint.damping_ratio};
}

JointSpring beam_joint(const ElasticIce& ice, double width, double span) {
    const double bending = ice.flexural_rigidity() * width / span;
    const double stretching = ice.elastic_modulus * ice.thickness * width / span;
    const double shear_modulus = ice.elastic_modulus / (2 * (1 + ice.poisson_ratio));
    const double square = span * span;
    const double shear_flexibility =
        12 * ice.flexural_rigidity() / (5.0 / 6.0 * shear_modulus * ice.thickness * square);
    return {.force = {stretching, 12 * bending / (square * (1 + shear_flexibility)),
                      2 * shear_modulus * ice.thickness * width / span},
            .moment = {bending, stretching * width * width / 12, bending},
            .damping_ratio = ice.damping_ratio};
}

std::optional<JointSpring> joint_spring(const FloeShape& shape, const Material& material) {
    if (material.joint.model == JointModel::cfm) return std::nullopt;
    return beam_joint(elastic_ice(shape, material), shape.element, shape.element);
}

}  // namespace floes
