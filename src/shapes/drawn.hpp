#pragma once
// Outlines that are drawn: cells of a Voronoi diagram, and polygons about an ellipse. Each has a random stream of its
// own. The same bits with any C library: no functions but square roots.

#include <cstddef>
#include <span>
#include <vector>

#include "core/random.hpp"
#include "shapes/polygon.hpp"

namespace floes {

/// A rectangle of water, m.
struct WaterArea {
    double low_x = 0;
    double low_z = 0;
    double length = 0;   ///< along x
    double breadth = 0;  ///< along z
};

/// Points anywhere in the area. Two draws each.
std::vector<Corner> thrown_points(const WaterArea& area, std::size_t count, RandomStream& random);

/// The Voronoi cell of one of some points in the area; by_x: all of them, sorted.
Outline voronoi_cell(const WaterArea& area, Corners by_x, std::size_t point);

/// Those of all points, in their order.
std::vector<Outline> voronoi_cells(const WaterArea& area, Corners points);

/// The Voronoi cells of `count` points thrown into the area. After each of `relaxations` steps of Lloyd's the points
/// are at the centroids of their cells: none leaves cells of very unequal areas, many make them all much alike.
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

// The cells of a Voronoi diagram that does not end: of points that become known strip after strip along x, between two
// sides and from a wall on.
//
// A cell is certain once no point beyond the known ones can come near enough to change it: each of its corners lies as
// near to its own point as to the edge of what is known. A step of Lloyd's hands the centroids of certain cells on, as
// the points of the next diagram; those of all others lie beyond the foremost point of a cell that may still change. So
// each diagram is known up to an edge of its own, some two cells behind that of the one before, and every cell comes
// out as it would if all points had been known from the beginning. There is no seam.

class EndlessCells {
  public:
    /// area: the first strip; it begins at the wall. The others follow it, each as long. relaxations: steps of Lloyd's.
    EndlessCells(const WaterArea& area, int relaxations);

    /// The points of the next strip.
    void add(std::span<const Corner> points);

    /// Cells that are certain and come before all that are not, by the x of their centroids.
    std::size_t ready() const;
    const Outline& cell(std::size_t number) const { return cells_[number].outline; }
    double middle_x(std::size_t number) const { return cells_[number].centroid.x; }

    /// Forgets the first so many.
    void take(std::size_t count) { cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count)); }

  private:
    struct Point {
        Corner at;
        bool certain = false;  // its cell is, and the point no longer asks for it
        double last_x = 0;     // of that cell
    };
    struct Diagram {
        std::vector<Point> points;  // sorted, without those that no uncertain cell can touch any more
        double known;               // x: all points behind it are there
    };
    struct Cell {
        Corner centroid;
        Outline outline;
    };
    std::vector<Cell> settle(Diagram& diagram, double& known_next) const;

    WaterArea strip_;
    double begin_;                   // x of the wall
    double end_;                     // x, of all strips so far
    std::vector<Diagram> diagrams_;  // after 0, 1, ... steps
    std::vector<Cell> cells_;        // certain ones of the last, sorted
    double cells_known_;             // x: all cells with centroids behind it are there
};

}  // namespace floes
