#pragma once
// The hybrid model over the elastic modulus for a scenario: Fig. 8.

#include <optional>
#include <span>
#include <vector>

#include "scenario/scenario.hpp"
#include "theory/hybrid.hpp"

namespace floes {

/// The load at one modulus, N.
struct HybridPoint {
    double elastic_modulus = 0;        ///< Pa
    double characteristic_length = 0;  ///< of a floating plate of it, m
    LindqvistLoad limit_stress;        ///< in its parts
    double limit_momentum = 0;
    double load = 0;  ///< the smaller one
};

struct HybridCurve {
    IceHull hull;
    KprCoefficients coefficients;
    std::vector<HybridPoint> points;
    std::optional<double> crossing;  ///< Pa; none when floes are pushed aside at any modulus
};

/// What Lindqvist asks of a ship, of a body of revolution: breadth and length are the waterline diameter, the wall is
/// met square (α = 90 degrees), its angle is that from the waterline upwards, which Table 2 gives. Throws InputError
/// when the wall is vertical or leans over there.
IceHull hull_of(const Scenario& scenario);

/// The model without KPR coefficients. Throws InputError as hull_of() and lindqvist_load() do.
HybridModel hybrid_model(const Scenario& scenario);

/// The curve at these moduli (Pa, > 0), in their order.
HybridCurve hybrid_curve(const Scenario& scenario, const HybridModel& model, std::span<const double> moduli);

}  // namespace floes
