#include "ice/beam_joint.hpp"

namespace floes {

JointSpring beam_joint(double elastic_modulus, double poisson_ratio, double thickness, double side,
                       double damping_ratio) {
    const double rigidity =
        elastic_modulus * thickness * thickness * thickness / (12 * (1 - poisson_ratio * poisson_ratio));
    const double shear_modulus = elastic_modulus / (2 * (1 + poisson_ratio));
    const double area = side * side;
    const double shear_flexibility = 12 * rigidity / (5.0 / 6.0 * shear_modulus * thickness * area);
    return {.force = {elastic_modulus * thickness, 12 * rigidity / (area * (1 + shear_flexibility)),
                      2 * shear_modulus * thickness},
            .moment = {rigidity, elastic_modulus * thickness * area / 12, rigidity},
            .damping_ratio = damping_ratio};
}

std::optional<JointSpring> joint_spring(const Scenario& scenario) {
    if (scenario.joint.model == JointModel::cfm) return std::nullopt;
    const Ice& ice = scenario.ice;
    return beam_joint(ice.elastic_modulus, ice.poisson_ratio, ice.thickness, scenario.floe.element,
                      scenario.joint.damping_ratio);
}

}  // namespace floes
