#include "theory/lindqvist.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {
namespace {

double crushing(const IceHull& hull, const LevelIce& ice) {
    const double phi = hull.stem_angle;
    const double cos_psi = std::cos(hull.normal_angle());
    const double push = std::tan(phi) + hull.friction * std::cos(phi) / cos_psi;
    const double slide = 1 - hull.friction * std::sin(phi) / cos_psi;
    return 0.5 * ice.bending_strength * ice.thickness * ice.thickness * push / slide;
}

double bending(const IceHull& hull, const LevelIce& ice) {
    const double psi = hull.normal_angle();
    const double nu = ice.poisson_ratio;
    const double stiffness =
        ice.elastic_modulus / (12 * (1 - nu * nu) * ice.gravity * ice.water_density);  // lc⁴ / h³, m
    const double push =
        std::tan(psi) + hull.friction * std::cos(hull.stem_angle) / (std::sin(hull.entrance_angle) * std::cos(psi));
    return 27.0 / 64.0 * ice.bending_strength * hull.breadth * std::pow(ice.thickness, 1.5) / std::sqrt(stiffness) *
           push * (1 + 1 / std::cos(psi));
}

double submergence(const IceHull& hull, const LevelIce& ice) {
    const double b = hull.breadth;
    const double t = hull.draught;
    const double sin_phi = std::sin(hull.stem_angle);
    const double cot_alpha = std::cos(hull.entrance_angle) / std::sin(hull.entrance_angle);
    const double covered = 0.7 * hull.length - t / std::tan(hull.stem_angle) - b * cot_alpha / 4 +
                           t * std::cos(hull.stem_angle) * std::cos(hull.normal_angle()) *
                               std::sqrt(1 / (sin_phi * sin_phi) + cot_alpha * cot_alpha);
    return (ice.water_density - ice.density) * ice.gravity * ice.thickness * b *
           (t * (b + t) / (b + 2 * t) + hull.friction * covered);
}

}  // namespace

double IceHull::normal_angle() const {
    return std::atan(std::tan(stem_angle) / std::sin(entrance_angle));
}

LindqvistLoad lindqvist_load(const IceHull& hull, const LevelIce& ice, double speed) {
    if (!(hull.friction * std::sin(hull.stem_angle) < std::cos(hull.normal_angle())))
        throw InputError(
            fmt::format("Lindqvist's formula has no load for a wall of {:.4g}° from the horizontal and friction {:g}: "
                        "ice jams on it and does not bend; it needs a smaller angle or less friction.",
                        hull.stem_angle * 180 / std::numbers::pi, hull.friction));
    const double breaking = 1 + 1.4 * speed / std::sqrt(ice.gravity * ice.thickness);
    const double sliding = 1 + 9.4 * speed / std::sqrt(ice.gravity * hull.length);
    return {crushing(hull, ice) * breaking, bending(hull, ice) * breaking, submergence(hull, ice) * sliding};
}

}  // namespace floes
