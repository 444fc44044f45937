#pragma once
// Convex bodies with flat faces: the hull of points, what lies within planes, and their measures. Lengths in m.

#include <optional>
#include <span>
#include <vector>

#include "core/vector.hpp"

namespace floes {

/// What lies inside has normal · p <= offset; the normal has length 1.
struct Plane {
    Vec3 normal = Vec3::UnitY();
    double offset = 0;

    double height(const Vec3& point) const { return normal.dot(point) - offset; }  ///< m, outside positive
};

/// Closed and convex. Without corners: it encloses nothing.
struct Polyhedron {
    std::vector<Vec3> corners;
    std::vector<std::vector<int>> faces;  ///< indices of corners, counter-clockwise as seen from outside
    std::vector<Plane> planes;            ///< of the faces

    bool empty() const { return faces.empty(); }
    /// The corner farthest along `direction`, which need not be a unit vector.
    Vec3 farthest(const Vec3& direction) const;
    double volume() const;  ///< m³
    Vec3 centroid() const;  ///< of a body that is not empty
    /// The body whose faces lie `depth` inside these; empty where it is nowhere as thick as twice that.
    Polyhedron inside(double depth) const;
    Polyhedron scaled(double factor) const;  ///< factor > 0
    /// The part of it with normal · p <= offset. A corner nearer to the plane than `slack` m is in it, on both sides.
    Polyhedron cut(const Plane& plane, double slack = 0) const;
    /// Its section at the height y, counter-clockwise in (x, z); empty where it has none.
    std::vector<Vec2> section(double y) const;

    friend bool operator==(const Polyhedron& a, const Polyhedron& b) { return a.corners == b.corners; }
};

/// The smallest convex body that holds all points; empty if they lie in a plane. A point counts as in a face that it
/// stands out of by less than 2e-7 of the body's size, which is what is left of a plane in STL's single precision; so
/// faces are whole polygons, however they were cut into triangles. Throws InputError when rounding leaves no body.
Polyhedron convex_hull(std::span<const Vec3> points);

/// What lies inside all planes. `within`: a point inside each of them, or it is empty. Throws InputError when it has no
/// end in some direction.
Polyhedron intersection(std::span<const Plane> planes, const Vec3& within);

/// The convex outline of points in a plane, counter-clockwise.
std::vector<Vec2> convex_outline(std::vector<Vec2> points);
double area_of(std::span<const Vec2> outline);  ///< m², positive counter-clockwise

}  // namespace floes
