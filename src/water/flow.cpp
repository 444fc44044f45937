#include "water/flow.hpp"

namespace floes {

Vec2 potential_flow(const Vec2& from_axis, double radius, double speed) {
    const double r2 = from_axis.squaredNorm();
    if (r2 == 0) return {speed, 0};
    const double cosine2 = from_axis.x() * from_axis.x() / r2;
    const double sine2 = from_axis.y() * from_axis.y() / r2;
    const double sine_cosine = from_axis.x() * from_axis.y() / r2;
    const double strength = speed * (r2 > radius * radius ? radius * radius / r2 : 1.0);
    return {strength * (cosine2 - sine2), strength * 2 * sine_cosine};
}

}  // namespace floes
