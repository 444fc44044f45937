#pragma once
// A clamped beam loaded at its tip, dry and floating: the strength measured by a cantilever test.

namespace floes {

/// Nominal flexural strength (Pa) of a dry cantilever that fails under tip load P (N) at distance L (m) from the
/// failing section of breadth b and thickness h (m): 6 P L/(b h²).
double nominal_flexural_strength(double load, double length, double breadth, double thickness);

/// P L/M0 of a floating cantilever: the result of the nominal formula divided by the strength at the root. Hetényi
/// (1946), beam on an elastic foundation: M0 = (P/λ)(sinh λL cos λL + cosh λL sin λL)/(cosh² λL + cos² λL), λ = (3 k/(E
/// h³))^(1/4), k = ρ_w g. At least 1; 1 for a stiff or short beam. SI.
double floating_cantilever_factor(double elastic_modulus, double length, double thickness, double foundation);

}  // namespace floes
