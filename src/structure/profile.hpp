#pragma once
// The towed structure as a body of revolution about a vertical axis, given by its profile: radius over height.
// The profile may flare, narrow or step, so the body need not be convex; frusta() cuts it into pieces that are.

#include <vector>

#include "core/frustum.hpp"
#include "scenario/scenario.hpp"

namespace floes {

class Profile {
  public:
    /// `points`: at least two, heights never falling (equal heights make a flat ring), radii >= 0, some radius above 0,
    /// from below the waterline (height 0) to above it, radius there above 0. Throws InputError otherwise.
    explicit Profile(std::vector<ProfilePoint> points);

    /// Radius in m at `height` (m above the waterline), 0 outside [bottom(), top()]; at a flat ring the larger radius.
    double radius_at(double height) const;
    double waterline_radius() const { return radius_at(0); }
    double bottom() const { return points_.front().height; }
    double top() const { return points_.back().height; }
    double draught() const { return -bottom(); }
    double maximum_radius() const;

    /// One convex frustum for each segment that encloses volume: flat rings and bare lines on the axis have none.
    std::vector<Frustum> frusta() const;

    /// Angle of the wall from the horizontal for each segment, rad: under 90 degrees it flares upward (and bends ice
    /// down), 90 degrees is vertical, over 90 degrees it narrows upward; a flat ring has 0 or 180 degrees.
    std::vector<double> wall_angles() const;

  private:
    std::vector<ProfilePoint> points_;
};

}  // namespace floes
