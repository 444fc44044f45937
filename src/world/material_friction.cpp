#include "world/material_friction.hpp"

#include <cmath>

namespace floes {

MaterialFriction material_friction(const ContactLaw& law) {
    if (law.ice_ice_friction == 0) return {0, 0};
    const double ice = std::sqrt(law.ice_ice_friction);
    return {ice, law.ice_structure_friction / ice};
}

}  // namespace floes
