#include "structure/convex_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace floes {

std::optional<std::string> Frustum::fault() const {
    if (!(top_height > bottom_height))
        return fmt::format("the height of a frustum is {}; it must be above 0 m", top_height - bottom_height);
    if (!(bottom_radius >= 0 && top_radius >= 0))
        return fmt::format("the smaller radius of a frustum is {}; it must be at least 0 m",
                           std::fmin(bottom_radius, top_radius));
    if (!(bottom_radius + top_radius > 0)) return "the larger radius of a frustum is 0; it must be above 0 m";
    return std::nullopt;
}

Vec3 Frustum::farthest(const Vec3& direction) const {
    const double across = std::sqrt(direction.x() * direction.x() + direction.z() * direction.z());
    const double bottom = bottom_radius * across + bottom_height * direction.y();
    const double top = top_radius * across + top_height * direction.y();
    const double radius = top > bottom ? top_radius : bottom_radius;
    const double height = top > bottom ? top_height : bottom_height;
    if (across == 0) return {radius, height, 0};
    return {radius * direction.x() / across, height, radius * direction.z() / across};
}

Frustum Frustum::inside(double depth) const {
    const double rise = top_height - bottom_height;
    const double spread = top_radius - bottom_radius;
    const double inset = depth * std::hypot(rise, spread) / rise;  // along the radius
    Frustum core = *this;
    core.bottom_radius = std::max(0.0, bottom_radius - inset);
    core.top_radius = std::max(0.0, top_radius - inset);
    // Where the wall meets the axis the tip moves along it.
    if (bottom_radius < inset) core.bottom_height += std::min(rise, (inset - bottom_radius) * rise / std::abs(spread));
    if (top_radius < inset) core.top_height -= std::min(rise, (inset - top_radius) * rise / std::abs(spread));
    return core;
}

}  // namespace floes
