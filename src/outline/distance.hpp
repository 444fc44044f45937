#pragma once
// How far two convex polygons are apart.

#include "outline/polygon.hpp"

namespace floes {

/// Least distance between points of two convex polygons, m; separation() where they overlap.
double distance_between(Corners a, Corners b);

}  // namespace floes
