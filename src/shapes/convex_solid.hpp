#pragma once
// Convex bodies with flat faces: the hull of points, what lies within planes, and their measures. Lengths in m.

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/vector.hpp"

namespace floes {

/// What lies inside has normal · p <= offset; the normal has length 1.
struct Plane {
    Vec3 normal = Vec3::UnitY();
    double offset = 0;

    double height(const Vec3& point) const { return normal.dot(point) - offset; }  ///< m, outside positive
    Plane opposite() const { return {-normal, -offset}; }
};

/// Closed and convex. Without corners: it encloses nothing.
struct Polyhedron {
    std::vector<Vec3> corners;
    std::vector<std::vector<int>> faces;  ///< indices of corners, counter-clockwise as seen from outside
    std::vector<Plane> planes;            ///< of the faces

    bool empty() const { return faces.empty(); }
    /// Corner k of a face, round it.
    const Vec3& corner(const std::vector<int>& face, std::size_t k) const {
        return corners[static_cast<std::size_t>(face[k % face.size()])];
    }
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
/// faces are whole polygons, however they were cut into triangles. Where that leaves no body, as of many short edges,
/// points are moved by up to a hundred-thousandth of the body's size, where whole numbers decide. Throws InputError
/// when even that leaves none.
Polyhedron convex_hull(std::span<const Vec3> points);

/// What lies inside all planes. `within`: a point inside each of them, or it is empty. Throws InputError when it has no
/// end in some direction.
Polyhedron intersection(std::span<const Plane> planes, const Vec3& within);

/// The convex outline of points in a plane, counter-clockwise.
std::vector<Vec2> convex_outline(std::vector<Vec2> points);
double area_of(std::span<const Vec2> outline);  ///< m², positive counter-clockwise
double area_of(std::span<const Vec3> polygon);  ///< m², of a flat one

// A convex solid of the structure, as the world collides with it, in the structure's own axes: x ahead, y up from the
// waterline, z to starboard.

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

    double radius_at(double height) const;  ///< m, of its wall, continued straight on beyond its ends

    /// With all lengths multiplied by `factor`, above 0.
    Frustum scaled(double factor) const {
        return {factor * bottom_height, factor * bottom_radius, factor * top_height, factor * top_radius};
    }

    friend bool operator==(const Frustum&, const Frustum&) = default;
};

/// A solid and the part of the structure that it belongs to.
struct ConvexSolid {
    std::variant<Frustum, Polyhedron> form;
    Vec3 place = Vec3::Zero();         ///< of the form's origin, m
    int part = 0;                      ///< index of the part
    std::vector<int> face_parts = {};  ///< part of each face of a polyhedron; empty: all are of `part`

    ConvexSolid(const Frustum& frustum, const Vec3& at = Vec3::Zero(), int of_part = 0)
        : form(frustum), place(at), part(of_part) {}
    explicit ConvexSolid(Polyhedron body, int of_part = 0, std::vector<int> parts_of_faces = {})
        : form(std::move(body)), part(of_part), face_parts(std::move(parts_of_faces)) {}

    /// Why it encloses no volume, as a clause; nothing if it does.
    std::optional<std::string> fault() const;

    /// The point of the form farthest along `direction`, which need not be a unit vector, m from its origin.
    Vec3 farthest(const Vec3& direction) const;

    /// Its faces `depth` (m) inside; one that is nowhere so thick stays as it is.
    ConvexSolid inside(double depth) const;

    /// With all lengths multiplied by `factor`, above 0.
    ConvexSolid scaled(double factor) const;

    /// The part at a point of its surface: that of the face which the point is farthest outside of.
    int part_at(const Vec3& point) const;

    double volume() const;                                      ///< m³
    std::vector<Vec2> section(double height, int sides) const;  ///< outline in (x, z); round ones as regular polygons
    /// Points whose hull it is, round ones with regular polygons of `sides` sides round them.
    std::vector<Vec3> corners(int sides) const;

    friend bool operator==(const ConvexSolid&, const ConvexSolid&) = default;
};

// When faces of the pieces of a body lie in one plane. For this module only.

/// Relative to a body's size: what lies nearer than this to a plane is in it.
inline constexpr double plane_rounding = 1e-6;

/// The diagonal of the box that holds the corners of all, which are polyhedra, m.
inline double size_of(std::span<const ConvexSolid> pieces) {
    Box3 box;
    for (const ConvexSolid& piece : pieces) box.extend(box_round(std::get<Polyhedron>(piece.form).corners));
    return box.diagonal().norm();
}

/// Whether two planes that face the same way are one.
inline bool same_plane(const Plane& a, const Plane& b, double slack) {
    return a.normal.dot(b.normal) > 1 - plane_rounding && std::abs(a.offset - b.offset) <= slack;
}

}  // namespace floes
