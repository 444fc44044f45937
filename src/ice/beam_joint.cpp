#include "ice/beam_joint.hpp"

namespace floes {

double ElasticIce::flexural_rigidity() const {
    return elastic_modulus * thickness * thickness * thickness / (12 * (1 - poisson_ratio * poisson_ratio));
}

ElasticIce elastic_ice(const Scenario& scenario) {
    return {scenario.ice.elastic_modulus, scenario.ice.poisson_ratio, scenario.ice.thickness,
            scenario.joint.damping_ratio};
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

std::optional<JointSpring> joint_spring(const Scenario& scenario) {
    if (scenario.joint.model == JointModel::cfm) return std::nullopt;
    return beam_joint(elastic_ice(scenario), scenario.floe.element, scenario.floe.element);
}

}  // namespace floes
