#pragma once
// A clamped beam: the strength measured by a cantilever test, dry and floating; how far it bends and how it swings.

namespace floes {

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

}  // namespace floes
