#pragma once
// Contacts of the default physics, with their numbers.

#include "solver/contact_law.hpp"

namespace floes::test {

/// Pressure, Pa, and coefficients of friction between floes and on the structure.
inline ContactLaw crushing_ice(double pressure, double ice_ice, double ice_structure) {
    return {.ice_ice_friction = ice_ice,
            .ice_structure_friction = ice_structure,
            .split_impulse = false,
            .friction = Friction::cone,
            .normal = NormalLaw::crushing,
            .crushing_pressure = pressure,
            .internal_edges = false};
}

}  // namespace floes::test
