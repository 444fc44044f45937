#pragma once
// Drawings of single floes with their elements and joints.

#include <vector>

#include "findings/evidence.hpp"
#include "tables/figure.hpp"

namespace floes {

/// Once for all cases whose floes are alike: the floe, or where floes differ the smallest, the middle one and the
/// largest of the case's first arrangement.
std::vector<Figure> single_floes(Evidence& evidence);

}  // namespace floes
