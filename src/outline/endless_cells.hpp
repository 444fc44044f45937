#pragma once
// The cells of a Voronoi diagram that does not end: of points that become known strip after strip along x, between two
// sides and from a wall on.
//
// A cell is certain once no point beyond the known ones can come near enough to change it: each of its corners lies as
// near to its own point as to the edge of what is known. A step of Lloyd's hands the centroids of certain cells on, as
// the points of the next diagram; those of all others lie beyond the foremost point of a cell that may still change. So
// each diagram is known up to an edge of its own, some two cells behind that of the one before, and every cell comes
// out as it would if all points had been known from the beginning. There is no seam.

#include <cstddef>
#include <span>
#include <vector>

#include "outline/drawn.hpp"
#include "outline/polygon.hpp"

namespace floes {

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
    void take(std::size_t count);

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
