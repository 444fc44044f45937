#pragma once
// An infinite elastic plate floating on a liquid, loaded at its centre: w0 from E, and E from the slope dP/dw0.
// Hertz (1884); Wyman (1950) for the circular load. k = ρ_w g (N/m³), D = E h³/(12 (1 - ν²)) (N m), l = (D/k)^(1/4)
// (m).

namespace floes {

/// The plate without its stiffness. SI.
struct FloatingPlate {
    double thickness;               ///< h, m
    double water_density = 1000.0;  ///< ρ_w, kg/m³
    double gravity = 9.81;          ///< m/s²
    double poisson_ratio = 0.3;     ///< ν

    double foundation() const;                                   ///< k, N/m³
    double flexural_rigidity(double elastic_modulus) const;      ///< D, N m; E in Pa
    double characteristic_length(double elastic_modulus) const;  ///< l, m
};

/// dP/dw0 (N/m) under a load spread over a circle of radius a (m), w0 at its centre:
/// w0 = P/(π a² k) [1 + (a/l) ker'(a/l)].
double patch_load_slope(const FloatingPlate& plate, double elastic_modulus, double radius);

/// E (Pa) from the slope (N/m) of a point load: 3/16 (1 - ν²)/(ρ_w g h³) slope².
double modulus_from_point_slope(const FloatingPlate& plate, double slope);

/// E (Pa) from the slope (N/m) of a load on a circle of radius a (m). Throws InputError unless the slope exceeds the
/// buoyancy of the loaded circle itself, π a² k: no plate is softer.
double modulus_from_patch_slope(const FloatingPlate& plate, double slope, double radius);

}  // namespace floes
