#pragma once
// Beams and plates of ice in closed form, dry and on water.

namespace floes {

// A clamped beam: the strength measured by a cantilever test, dry and floating; how far it bends and how it swings.

/// Nominal flexural strength (Pa) of a dry cantilever that fails under tip load P (N) at distance L (m) from the
/// failing section of breadth b and thickness h (m): 6 P L/(b h²).
double nominal_flexural_strength(double load, double length, double breadth, double thickness);

/// P L/M0 of a floating cantilever: the result of the nominal formula divided by the strength at the root. Hetényi
/// (1946), beam on an elastic foundation: M0 = (P/λ)(sinh λL cos λL + cosh λL sin λL)/(cosh² λL + cos² λL), λ = (3 k/(E
/// h³))^(1/4), k = ρ_w g. At least 1; 1 for a stiff or short beam. SI.
double floating_cantilever_factor(double elastic_modulus, double length, double thickness, double foundation);

/// Deflection (m) of a cantilever under a load P (N) at distance a (m) from its clamp, there: P a³/(3 E I), E I =
/// stiffness (N m²).
double cantilever_deflection(double load, double distance, double stiffness);

/// Lowest frequency (1/s) of a uniform cantilever of length L (m), E I = stiffness (N m²) and m = mass per length
/// (kg/m): 1.8751² sqrt(E I/m)/(2 π L²), Euler and Bernoulli.
double cantilever_frequency(double length, double stiffness, double mass_per_length);

// An infinite elastic plate floating on a liquid, loaded at its centre: w0 from E, and E from the slope dP/dw0.
// Hertz (1884); Wyman (1950) for the circular load. k = ρ_w g (N/m³), D = E h³/(12 (1 - ν²)) (N m), l = (D/k)^(1/4)
// (m).

/// The plate without its stiffness. SI.
struct FloatingPlate {
    double thickness;               ///< h, m
    double water_density = 1000.0;  ///< ρ_w, kg/m³
    double gravity = 9.81;          ///< m/s²
    double poisson_ratio = 0.3;     ///< ν

    double foundation() const { return water_density * gravity; }  ///< k, N/m³
    double flexural_rigidity(double elastic_modulus) const;        ///< D, N m; E in Pa
    double characteristic_length(double elastic_modulus) const;    ///< l, m
};

/// dP/dw0 (N/m) under a load spread over a circle of radius a (m), w0 at its centre:
/// w0 = P/(π a² k) [1 + (a/l) ker'(a/l)].
double patch_load_slope(const FloatingPlate& plate, double elastic_modulus, double radius);

/// E (Pa) from the slope (N/m) of a point load: 3/16 (1 - ν²)/(ρ_w g h³) slope².
double modulus_from_point_slope(const FloatingPlate& plate, double slope);

/// E (Pa) from the slope (N/m) of a load on a circle of radius a (m). Throws InputError unless the slope exceeds the
/// buoyancy of the loaded circle itself, π a² k: no plate is softer.
double modulus_from_patch_slope(const FloatingPlate& plate, double slope, double radius);

// The Kelvin function that a plate on a liquid needs (Abramowitz & Stegun 9.9; DLMF 10.61, 10.65).

/// Largest argument for which the power series below keeps 10 digits.
inline constexpr double kelvin_series_limit = 8.0;

/// ker'(x), x in (0, kelvin_series_limit]; ker'(x) -> -1/x as x -> 0. Throws InputError outside.
double kelvin_ker_prime(double x);

// The largest stress in a wide plate on water under a load on a small circle: at its edge, and far from edges.
// Westergaard (Public Roads 7, 1926; edge formula as revised in Trans. ASCE 113, 1948; cited from memory). With k = ρ_w
// g and P downwards, the stress is tension in the lower fibre:
//
//   edge      σ = 0.529 (1 + 0.54 ν) (P/T²) [log10(E T³ / (k b⁴)) - 0.71]    along the edge
//   interior  σ = 0.275 (1 + ν)      (P/T²)  log10(E T³ / (k b⁴))            in every direction
//
// b: radius of the loaded circle as a thick plate feels it: a, but not below 0.325 T.

/// b (m) of a circle of radius a (m) on a plate that is T (m) thick: √(1.6 a² + T²) - 0.675 T below a = 1.724 T, else
/// a.
double felt_radius(double a, double thickness);

/// By how much the stress grows, Pa, when the load (N) is on a circle a tenth as wide: the singular part of both
/// formulas.
double edge_stress_per_decade(double load, double thickness, double poisson_ratio);
double interior_stress_per_decade(double load, double thickness, double poisson_ratio);

}  // namespace floes
