#pragma once
// When faces of the pieces of a body lie in one plane. For this room only.

#include <cmath>
#include <span>

#include "structure/convex_solid.hpp"

namespace floes {

/// Of a body's size: what lies nearer than this to a plane is in it.
inline constexpr double flat = 1e-6;

/// The diagonal of the box that holds the corners of all, which are polyhedra, m.
inline double size_of(std::span<const ConvexSolid> pieces) {
    Vec3 low = std::get<Polyhedron>(pieces.front().form).corners.front();
    Vec3 high = low;
    for (const ConvexSolid& piece : pieces) {
        for (const Vec3& corner : std::get<Polyhedron>(piece.form).corners) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    }
    return (high - low).norm();
}

/// Whether two planes that face the same way are one.
inline bool same_plane(const Plane& a, const Plane& b, double slack) {
    return a.normal.dot(b.normal) > 1 - flat && std::abs(a.offset - b.offset) <= slack;
}

}  // namespace floes
