#pragma once
// Rectangles on the water and whether two of them overlap: the separating-axis test. Two convex polygons are disjoint
// exactly if their projections on the normal of one of their sides are; here there are four directions.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/turn.hpp"
#include "core/vector.hpp"

namespace floes {

/// Half the sides of a rectangle, m: length along its own x, breadth along its own z.
struct Rectangle {
    double half_length = 0;
    double half_breadth = 0;

    /// The same with every side moved outward by margin (m).
    Rectangle grown(double margin) const { return {half_length + margin, half_breadth + margin}; }
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
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

/// A rectangle and how it is turned.
struct TurnedRectangle {
    Rectangle shape;
    Turn turn;
};

/// Half the widths of two rectangles together, along the own x and z of the first: they are apart exactly if their
/// centres are at least so far apart along one of these directions, or of those of the second.
inline Extent joint_extent(const TurnedRectangle& first, const TurnedRectangle& second) {
    const double cos_between = std::abs(first.turn.cos * second.turn.cos + first.turn.sin * second.turn.sin);
    const double sin_between = std::abs(first.turn.cos * second.turn.sin - first.turn.sin * second.turn.cos);
    return {
        first.shape.half_length + second.shape.half_length * cos_between + second.shape.half_breadth * sin_between,
        first.shape.half_breadth + second.shape.half_length * sin_between + second.shape.half_breadth * cos_between};
}

/// Whether two rectangles overlap. The second lies at (dx, dz) from the first (m). Touching is not overlap. A
/// rectangle turned by yaw about +y has its own x axis along (cos yaw, -sin yaw) of the world's (x, z).
inline bool overlap(const TurnedRectangle& first, const TurnedRectangle& second, double dx, double dz) {
    const auto apart_along = [&](const TurnedRectangle& own, const TurnedRectangle& other) {
        const Extent reach = joint_extent(own, other);
        return std::abs(own.turn.cos * dx - own.turn.sin * dz) >= reach.x ||
               std::abs(own.turn.sin * dx + own.turn.cos * dz) >= reach.z;
    };
    return !apart_along(first, second) && !apart_along(second, first);
}

/// The smallest rectangle that covers each of the shapes, unturned.
inline Rectangle covering(std::span<const Rectangle> shapes) {
    Rectangle all;
    for (const Rectangle& one : shapes) {
        all.half_length = std::max(all.half_length, one.half_length);
        all.half_breadth = std::max(all.half_breadth, one.half_breadth);
    }
    return all;
}

/// The largest half diagonal, m.
inline double widest_reach(std::span<const Rectangle> shapes) {
    double reach = 0;
    for (const Rectangle& one : shapes) reach = std::max(reach, one.half_diagonal());
    return reach;
}

/// The smallest half side, m; infinite without shapes.
inline double least_half_side(std::span<const Rectangle> shapes) {
    double half = std::numeric_limits<double>::infinity();
    for (const Rectangle& one : shapes) half = std::min({half, one.half_length, one.half_breadth});
    return half;
}

}  // namespace floes
