#pragma once
// Floes that are polygons, drawn.

#include <vector>

#include "scenario/floes.hpp"

namespace floes {

/// Gives each floe the outline that [shapes] draws for it, and cells of a Voronoi diagram their places. Outlines depend
/// on the campaign's seed, the arrangement's number, the part and what [shapes], [sizes], [floe] and [field] say. Cells
/// of a field without end, which knows no part alone, stay rectangles (arrangement/cell_field.hpp). Throws InputError
/// if cells are too small, or lie nearer than the clearance.
void shape_floes(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes);

/// Whether a convex outline is a sheet of such ice that can be cut into elements.
bool is_floe(Corners outline, double thickness);

/// Makes a floe of a cell, where it lies.
void lay_cell(SingleFloe& floe, const Outline& cell);

/// Throws InputError where cells whose edges moved inwards by `offset` (m) lie nearer than the clearance.
void check_gap(const Scenario& scenario, double offset);

}  // namespace floes
