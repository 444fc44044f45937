#pragma once
// The hybrid model over the elastic modulus for a scenario: Fig. 8.

#include <optional>
#include <span>
#include <vector>

#include "scenario/scenario.hpp"
#include "theory/hybrid.hpp"

namespace floes {

/// Loads at one modulus, N.
struct HybridPoint {
    double elastic_modulus = 0;        ///< Pa
    double characteristic_length = 0;  ///< of a floating plate of this modulus, m
    LindqvistLoad limit_stress;        ///< by component
    double limit_momentum = 0;
    double load = 0;  ///< the smaller of the two limits
};

struct HybridCurve {
    IceHull hull;
    KprCoefficients coefficients;
    std::vector<HybridPoint> points;
    std::optional<double> crossing;  ///< Pa; none when floes are pushed aside at any modulus
};

/// The ship dimensions of Lindqvist's formula for a body of revolution: breadth and length are the waterline diameter,
/// the ice meets the wall squarely (α = 90 degrees), and the wall angle is the one just above the waterline (Table 2).
/// Throws InputError if the wall is vertical or overhangs there.
IceHull hull_of(const Scenario& scenario);

/// The ice of the scenario's floes, without a modulus.
LevelIce level_ice_of(const Scenario& scenario);

/// The model without KPR coefficients. Throws InputError as hull_of() and lindqvist_load() do.
HybridModel hybrid_model(const Scenario& scenario);

/// The curve at these moduli (Pa, > 0), in their order.
HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli);

}  // namespace floes
