#pragma once
// Loads by closed formulas, as output: the hybrid model over the elastic modulus, and level ice on the wall by the
// formulas of ISO 19906. The report's section of them is in sections.hpp.

#include <span>

#include "scenario/scenario.hpp"
#include "tables/section.hpp"
#include "theory/level_ice.hpp"

namespace floes {

/// A line for each modulus for people and in CSV; in JSON with the crossing, the wall and KPR's coefficients.
Section hybrid_section(const HybridCurve& curve);

/// What ISO's formulas need beside the scenario.
struct SlopingRequest {
    Rubble rubble;
    double crushing_strength = 2.2e6;  ///< C_R, Pa: that of IceFloe's example
};

/// What the scenario says of it: friction of ice on ice, and rubble of three thicknesses, as in IceFloe's example,
/// which is no steeper than the wall. Throws InputError as hull_of() does.
Rubble rubble_on(const Scenario& scenario);

/// A line for each modulus (Pa) with the parts of the load, and the load of crushing; a sentence where the formula has
/// none for the wall. `units` of the sentences. Throws InputError as check_rubble() and hull_of() do.
Section sloping_section(const Scenario& scenario, std::span<const double> moduli, const SlopingRequest& request,
                        const Units& units);

}  // namespace floes
