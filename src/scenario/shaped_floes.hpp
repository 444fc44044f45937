#pragma once
// Floes that are polygons, drawn.

#include <string>
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

/// Gives the floe an outline, and the place where that lies.
void lie_as(SingleFloe& floe, Corners outline);

/// Throws InputError where cells whose edges moved inwards by `offset` (m) lie nearer than the clearance.
void check_gap(const Scenario& scenario, double offset);

/// Shapes of all floes of shapes.kind = "file": floe i of n has the outline that a share (i + ½)/n of all outlines, by
/// area, is below. So all arrangements have the same floes.
std::vector<FloeShape> traced_shapes(const Scenario& scenario);

/// One floe for each outline, where it was traced, from the near edge of the field on and about its middle line.
std::vector<SingleFloe> floes_as_traced(const Scenario& scenario);

/// Area that each outline gained in becoming convex, over its own in the file; empty if it came from none.
std::vector<double> traced_added(const TracedOutlines& traced);

/// 'outline 3 "A"', as messages name one of the outlines of a file; counted from 1.
std::string outline_name(const TracedOutlines& traced, std::size_t number);

}  // namespace floes
