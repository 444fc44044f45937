#pragma once
// Coulomb friction in Bullet is the product of the two bodies' material coefficients, so the two coefficients of
// contact fix the two materials: ice = sqrt(f_ii), structure = f_is / sqrt(f_ii).

#include "solver/contact_law.hpp"

namespace floes {

struct MaterialFriction {
    double ice = 0;
    double structure = 0;
};

/// The material coefficients that give the coefficients of contact of a law that World accepts.
MaterialFriction material_friction(const ContactLaw& law);

}  // namespace floes
