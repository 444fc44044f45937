#pragma once
// Rectangles on the water and whether two of them overlap: the separating-axis test. Two convex polygons are disjoint
// exactly if their projections on the normal of one of their sides are; here there are four directions.

#include <cmath>

#include "core/turn.hpp"
#include "core/vector.hpp"

namespace floes {

/// Half the sides of a rectangle, m: length along its own x, breadth along its own z.
struct Rectangle {
    double half_length = 0;
    double half_breadth = 0;

    /// The same with every side moved outward by margin (m).
    Rectangle grown(double margin) const { return {half_length + margin, half_breadth + margin}; }
    double half_diagonal() const { return std::sqrt(half_length * half_length + half_breadth * half_breadth); }
};

/// Half the extent of a turned rectangle along world x and z, m.
struct Extent {
    double x = 0;
    double z = 0;
};

inline Extent extent(const Rectangle& shape, Turn turn) {
    const double c = std::abs(turn.cos);
    const double s = std::abs(turn.sin);
    return {shape.half_length * c + shape.half_breadth * s, shape.half_length * s + shape.half_breadth * c};
}

/// The own x and z axes of a turned rectangle in the world's (x, z), of length 1.
inline Vec2 along(Turn turn) {
    return {turn.cos, -turn.sin};
}
inline Vec2 across(Turn turn) {
    return {turn.sin, turn.cos};
}

/// From the middle of a turned rectangle to its corner that lies farthest along direction, m.
inline Vec2 corner(const Rectangle& shape, Turn turn, const Vec2& direction) {
    const Vec2 a = along(turn);
    const Vec2 b = across(turn);
    return std::copysign(shape.half_length, direction.dot(a)) * a +
           std::copysign(shape.half_breadth, direction.dot(b)) * b;
}

/// Half the widths of two equal rectangles together, along the own x and z of either: they are apart exactly if their
/// centres are at least so far apart along one of these four directions.
inline Extent joint_extent(const Rectangle& shape, Turn first, Turn second) {
    const double cos_between = std::abs(first.cos * second.cos + first.sin * second.sin);
    const double sin_between = std::abs(first.cos * second.sin - first.sin * second.cos);
    return {shape.half_length + shape.half_length * cos_between + shape.half_breadth * sin_between,
            shape.half_breadth + shape.half_length * sin_between + shape.half_breadth * cos_between};
}

/// Whether two equal rectangles overlap. The second lies at (dx, dz) from the first (m). Touching is not overlap. A
/// rectangle turned by yaw about +y has its own x axis along (cos yaw, -sin yaw) of the world's (x, z).
inline bool overlap(const Rectangle& shape, Turn first, Turn second, double dx, double dz) {
    const Extent reach = joint_extent(shape, first, second);
    const auto apart = [&](Turn turn) {
        return std::abs(turn.cos * dx - turn.sin * dz) >= reach.x || std::abs(turn.sin * dx + turn.cos * dz) >= reach.z;
    };
    return !apart(first) && !apart(second);
}

}  // namespace floes
