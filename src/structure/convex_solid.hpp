#pragma once
// A convex solid of the structure, as the world collides with it. Heights are above the waterline, the axis is
// vertical.

#include <optional>
#include <string>

#include "core/vector.hpp"

namespace floes {

/// The frustum of a cone between two heights, m: top_height > bottom_height, radii not negative and not both zero.
struct Frustum {
    double bottom_height = 0;
    double bottom_radius = 0;
    double top_height = 0;
    double top_radius = 0;

    /// Why it encloses no volume, as "the height of a frustum is 0; it must be above 0 m"; nothing if it does.
    std::optional<std::string> fault() const;

    /// The point farthest along `direction`, which need not be a unit vector, m from the axis at the waterline.
    Vec3 farthest(const Vec3& direction) const;

    /// The frustum whose wall lies `depth` (m) inside this one, measured along the wall's normal; its ends stay where
    /// they are unless the wall meets the axis before them. It may enclose no volume.
    Frustum inside(double depth) const;

    /// With all lengths multiplied by `factor`, above 0.
    Frustum scaled(double factor) const {
        return {factor * bottom_height, factor * bottom_radius, factor * top_height, factor * top_radius};
    }

    friend bool operator==(const Frustum&, const Frustum&) = default;
};

/// What solids of the structure are. The world asks a solid for fault(), farthest(), inside() and scaled(), and for
/// nothing else.
using ConvexSolid = Frustum;

}  // namespace floes
