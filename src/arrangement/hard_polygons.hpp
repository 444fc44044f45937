#pragma once
// Monte Carlo of hard convex polygons between walls: sampler.hpp for other shapes than rectangles, with the same moves
// by the same draws. Squares given as outlines take the very steps of squares.

#include <span>
#include <vector>

#include "arrangement/boundary.hpp"
#include "arrangement/cells.hpp"
#include "arrangement/sampler.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"
#include "outline/polygon.hpp"

namespace floes {

/// Whether two convex polygons overlap: separation() below 0. Touching is not overlap.
bool overlap(Corners a, Corners b);

class HardPolygons {
  public:
    /// Outlines about their centroids at least clearance (m) apart, starting at `poses`, one an outline, which must not
    /// overlap. walls: moved inward by the clearance.
    HardPolygons(const Walls& walls, std::span<const Outline> outlines, double clearance,
                 std::span<const PlanarPose> poses);

    /// As HardRectangles'.
    int sweep(const Step& step, RandomStream& random);
    const std::vector<PlanarPose>& poses() const { return poses_; }
    double half_diagonal() const { return widest_; }

  private:
    struct Body {
        Outline own;      // in its own axes
        Outline larger;   // likewise, grown by half the clearance
        Outline corners;  // of the larger one, where it is
        double reach;     // of the larger one, m
    };
    bool try_move(std::size_t polygon, const Step& step, RandomStream& random);
    bool hits_another(const Resident& trial, Corners corners) const;

    Walls walls_;
    std::vector<Body> bodies_;
    double widest_;  // the largest reach, m
    std::vector<PlanarPose> poses_;
    Cells cells_;
    Outline trial_;  // corners of the one that is tried
};

}  // namespace floes
