#include "solver/slip_friction.hpp"

#include <algorithm>
#include <cmath>

namespace floes {

SlipLaw slip_law(const ContactLaw& law, bool at_structure) {
    const SlipFriction& slip = law.slip;
    if (at_structure) return {slip.ice_structure, law.ice_structure_friction, slip.ice_structure_exponent};
    return {slip.ice_ice, law.ice_ice_friction, slip.ice_ice_exponent};
}

double friction_coefficient(const SlipLaw& law, const SlipFriction& parameters, double slip, double remembered) {
    if (law.effect == SlipEffect::constant || law.coefficient == 0) return law.coefficient;
    const double rate = std::log(std::max(slip, parameters.slowest) / parameters.speed);
    if (law.effect == SlipEffect::power) {
        return std::clamp(law.coefficient * std::exp(-law.exponent * rate), parameters.least, parameters.largest);
    }
    const double state = std::log(std::max(remembered, parameters.slowest) / parameters.speed);
    return std::clamp(law.coefficient + parameters.direct * rate - parameters.evolution * state, parameters.least,
                      parameters.largest);
}

double remembered_slip(const SlipFriction& parameters, double slip, double remembered, double dt) {
    slip = std::max(slip, parameters.slowest);
    if (remembered < 0) return slip;
    return remembered * std::pow(slip / remembered, -std::expm1(-dt / parameters.memory));
}

}  // namespace floes
