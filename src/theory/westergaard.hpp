#pragma once
// The largest stress in a wide plate on water under a load on a small circle: at its edge, and far from edges.
// Westergaard (Public Roads 7, 1926; edge formula as revised in Trans. ASCE 113, 1948; cited from memory). With k = ρ_w
// g and P downwards, the stress is tension in the lower fibre:
//
//   edge      σ = 0.529 (1 + 0.54 ν) (P/T²) [log10(E T³ / (k b⁴)) - 0.71]    along the edge
//   interior  σ = 0.275 (1 + ν)      (P/T²)  log10(E T³ / (k b⁴))            in every direction
//
// b: radius of the loaded circle as a thick plate feels it: a, but not below 0.325 T.

#include "theory/plate.hpp"

namespace floes {

/// Pa, for a load (N) on a circle of radius b (m) that touches the edge of a half plate.
double edge_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b);

/// Pa, for a load (N) on a circle of radius b (m) far from edges.
double interior_load_stress(const FloatingPlate& plate, double elastic_modulus, double load, double b);

/// b (m) of a circle of radius a (m) on a plate that is T (m) thick: √(1.6 a² + T²) - 0.675 T below a = 1.724 T, else
/// a.
double felt_radius(double a, double thickness);

/// By how much the stress grows, Pa, when the load (N) is on a circle a tenth as wide: the singular part of both
/// formulas.
double edge_stress_per_decade(double load, double thickness, double poisson_ratio);
double interior_stress_per_decade(double load, double thickness, double poisson_ratio);

}  // namespace floes
