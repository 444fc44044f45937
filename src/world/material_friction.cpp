#include "world/material_friction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"

namespace floes {

MaterialFriction material_friction(const ContactLaw& law) {
    const double ice_ice = law.ice_ice_friction;
    const double ice_structure = law.ice_structure_friction;
    // Bullet limits a combined coefficient to 10.
    for (const double coefficient : {ice_ice, ice_structure}) {
        if (!(coefficient >= 0 && coefficient <= 10)) {
            throw InputError(fmt::format("A friction coefficient of {} is out of range; it must lie between 0 and 10.",
                                         coefficient));
        }
    }
    if (ice_ice == 0 && ice_structure == 0) return {0, 0};
    if (ice_ice == 0) {
        throw InputError(
            fmt::format("An ice-ice friction of 0 cannot be combined with an ice-structure friction of {}, because "
                        "friction is a product of two materials; use a small ice-ice friction such as 1e-6.",
                        ice_structure));
    }
    const double ice = std::sqrt(ice_ice);
    return {ice, ice_structure / ice};
}

}  // namespace floes
