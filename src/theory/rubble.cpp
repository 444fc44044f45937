#include "theory/rubble.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {
namespace {

/// What is under water of the pile, over what there is of ice.
double keel_share(const PiledIce& pile) {
    return pile.ice_density / pile.water_density / (1 - pile.porosity);
}

/// Area of a keel over its depth squared.
double form(const PiledIce& pile, double wall_angle) {
    if (!(0 < pile.angle && pile.angle < wall_angle))
        throw InputError(
            fmt::format("A pile of {:.4g} rad does not lean against a wall of {:.4g} rad.", pile.angle, wall_angle));
    return 0.5 * (1 / std::tan(pile.angle) - 1 / std::tan(wall_angle));
}

}  // namespace

double PiledIce::lift() const {
    return (1 - porosity) * (water_density - ice_density) * gravity;
}

double PiledIce::weight() const {
    return (1 - porosity) * ice_density * gravity;
}

double keel_depth(const PiledIce& pile, double ice, double wall_angle) {
    return std::sqrt(keel_share(pile) * ice / form(pile, wall_angle));
}

double length_until_grounded(const PiledIce& pile, double thickness, double depth, double wall_angle) {
    return form(pile, wall_angle) * depth * depth / (keel_share(pile) * thickness);
}

RubblePressure rubble_pressure(const PiledIce& pile, double keel, double sail, double friction_angle) {
    const double stress = 0.5 * (pile.lift() * keel * keel + pile.weight() * sail * sail);
    const double tangent = std::tan(std::numbers::pi / 4 - friction_angle / 2);
    const double coefficient = tangent * tangent;
    return {coefficient * stress, stress / coefficient};
}

}  // namespace floes
