#pragma once
// At which points a face of the ice lies on the structure: where the two faces that look at each other most squarely
// overlap, seen along the contact's normal. Of a round wall that is the line along which it is straight. Lengths in m,
// in the axes of the solid.

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
    /// Those of cores whose gap is this one. None, where no face of theirs touches another.
    BearingPoints(const SolidCore& solid, const PrismCorners& prism, const SolidGap& found);

    std::span<const BearingPoint> all() const { return {points_.data(), count_}; }

  private:
    void on_flat(const Polyhedron& solid, const PrismCorners& prism, const Vec3& normal);
    void on_round(const Frustum& solid, const PrismCorners& prism, const Vec3& normal);

    static constexpr std::size_t room = 2 * most_corners;
    std::array<BearingPoint, room> points_;
    std::size_t count_ = 0;
};

}  // namespace floes
