#pragma once
// Floes that are polygons, drawn.

#include <vector>

#include "scenario/floes.hpp"

namespace floes {

/// Gives each floe the outline that [shapes] draws for it, and cells of a Voronoi diagram their places. Outlines depend
/// on the campaign's seed, the arrangement's number and what [shapes], [sizes], [floe] and [field] say. Throws
/// InputError if cells are too small, or lie nearer than the clearance.
void shape_floes(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes);

}  // namespace floes
