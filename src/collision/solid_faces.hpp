#pragma once
// At which points ice lies on the structure where they meet in more than a point: two faces at the corners of what they
// share, seen along the contact's normal, and an edge of the one on a face of the other, or the line along which a
// round wall is straight, at both ends. Lengths in m, in the axes of the solid.

#include <array>
#include <span>

#include "collision/solid_gap.hpp"

namespace floes {

struct BearingPoint {
    Vec3 on_prism = Vec3::Zero();  ///< of its core
    double gap = 0;                ///< to the core of the solid along the normal; negative where they overlap
};

class BearingPoints {
  public:
    /// Those of cores whose gap is this one. None, where they meet in a point.
    BearingPoints(const SolidCore& solid, const PrismCorners& prism, const SolidGap& found);

    std::span<const BearingPoint> all() const { return {points_.data(), count_}; }

  private:
    void on_flat(const SolidCore& solid, const PrismCorners& prism, const Vec3& normal);
    void on_wall(const Frustum& solid, const PrismCorners& prism, const Vec3& normal);
    void on_end(const Frustum& solid, const PrismCorners& prism, bool top);
    void add(const Vec3& on_prism, double gap) {
        if (count_ < points_.size()) points_[count_++] = {on_prism, gap};
    }

    static constexpr std::size_t room = 2 * most_corners;
    std::array<BearingPoint, room> points_;
    std::size_t count_ = 0;
};

}  // namespace floes
