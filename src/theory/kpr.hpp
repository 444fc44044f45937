#pragma once
// Kashtelyan, Poznyak and Ryvlin (1968): the load of small floes that do not break, as the sum of a static, a
// dissipative (~ speed) and an impact part (~ speed²). The authors fitted the three coefficients to ships; no
// accessible source gives their values, so they are arguments here. SI units, angles in rad.

#include "theory/lindqvist.hpp"

namespace floes {

/// k1, k2, k3: the weights of the parts. They include concentration and channel width.
struct KprCoefficients {
    double static_part = 0;
    double dissipative = 0;
    double impact = 0;
};

struct KprLoad {
    double static_part = 0;  ///< N
    double dissipative = 0;
    double impact = 0;

    double total() const { return static_part + dissipative + impact; }
};

/// Floes of `floe_length` r (m). With Fr = V/√(g L) and the waterline coefficient a_H = π/4 of a circular bow:
///   k1 ρ_i g √(r h) (B/2)² (1 + 2 μ a_H L/B)  +  k2 ρ_i g r h B (μ + a_H tan α₀) Fr  +  k3 ρ_i g r h L tan² α₀ Fr².
/// α₀ = 45 degrees: the mean entrance angle of a circular waterline.
KprLoad kpr_load(const KprCoefficients& coefficients, const IceHull& hull, const LevelIce& ice, double floe_length,
                 double speed);

}  // namespace floes
