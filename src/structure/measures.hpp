#pragma once
// Measures of solids that together are a body. For this room only.

#include <span>

#include "structure/convex_solid.hpp"

namespace floes {

/// Sides of the polygons that stand for circles in outlines; a tenth of a percent of the area is lost.
inline constexpr int round_sides = 72;

/// Of what at least one of them holds, m³, by the lengths that they cover on lines along x through a grid of
/// lines_across x lines_across cells. Exact for one solid, or for solids whose boxes do not meet. Where one of several
/// is round it is the sum of theirs, as if they did not overlap.
double union_volume(std::span<const ConvexSolid> solids);

}  // namespace floes
