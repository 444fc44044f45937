#include "theory/kpr.hpp"

#include <cmath>
#include <numbers>

namespace floes {

KprLoad kpr_load(const KprCoefficients& coefficients, const IceHull& hull, const LevelIce& ice, double floe_length,
                 double speed) {
    constexpr double fullness = std::numbers::pi / 4;
    constexpr double entrance_tangent = 1;  // 45 degrees
    const double half_breadth = hull.breadth / 2;
    const double weight = ice.density * ice.gravity * floe_length * ice.thickness;  // per m of breadth, N/m
    const double froude = speed / std::sqrt(ice.gravity * hull.length);
    return {coefficients.static_part * ice.density * ice.gravity * std::sqrt(floe_length * ice.thickness) *
                half_breadth * half_breadth * (1 + 2 * hull.friction * fullness * hull.length / hull.breadth),
            coefficients.dissipative * weight * hull.breadth * (hull.friction + fullness * entrance_tangent) * froude,
            coefficients.impact * weight * hull.length * entrance_tangent * entrance_tangent * froude * froude};
}

}  // namespace floes
