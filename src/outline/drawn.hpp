#pragma once
// Outlines that are drawn: cells of a Voronoi diagram, and polygons about an ellipse. Each has a random stream of its
// own. The same bits with any C library: no functions but square roots.

#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "outline/polygon.hpp"

namespace floes {

/// A rectangle of water, m.
struct WaterArea {
    double low_x = 0;
    double low_z = 0;
    double length = 0;   ///< along x
    double breadth = 0;  ///< along z
};

/// The Voronoi cell of one of some points in the area; by_x: all of them, sorted.
Outline voronoi_cell(const WaterArea& area, Corners by_x, std::size_t point);

/// The Voronoi cells of `count` points thrown into the area. After each of `relaxations` steps of Lloyd's the points
/// are at the centroids of their cells: none leaves cells of very unequal areas, many make them all much alike.
/// Two draws a point.
std::vector<Outline> voronoi_cells(const WaterArea& area, int count, int relaxations, RandomStream& random);

/// The polygons with all edges moved inwards by one distance such that together they cover `area`, m²; and that
/// distance. Polygons that it leaves nothing of are empty.
struct Shrunk {
    std::vector<Outline> outlines;
    double offset = 0;
};
Shrunk shrunk_to(const std::vector<Outline>& outlines, double area);

/// A polygon with corners on an ellipse of these proportions, scaled to the area length x breadth and about its
/// centroid. Corners are evenly spread, each moved at random by up to `irregularity` / 2 of the way to its neighbours.
/// corners >= 3, irregularity 0 to 0.9.
Outline polygon_about(double length, double breadth, int corners, double irregularity, RandomStream& random);

}  // namespace floes
