#pragma once
// Coulomb friction in Bullet is the product of the two bodies' material coefficients, so the two coefficients of
// contact fix the two materials: ice = sqrt(f_ii), structure = f_is / sqrt(f_ii).

#include "solver/contact_law.hpp"

namespace floes {

struct MaterialFriction {
    double ice = 0;
    double structure = 0;
};

/// The material coefficients that give the law's coefficients of contact. Throws InputError for one outside 0 to 10,
/// and when that of ice on ice is 0 but that on the structure is not: no product gives that.
MaterialFriction material_friction(const ContactLaw& law);

}  // namespace floes
