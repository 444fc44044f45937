#pragma once
// The hybrid model over the elastic modulus, as output.

#include "tables/section.hpp"
#include "theory/hybrid_curve.hpp"

namespace floes {

/// A line for each modulus for people and in CSV; in JSON with the crossing, the wall and KPR's coefficients.
Section hybrid_section(const HybridCurve& curve);

}  // namespace floes
