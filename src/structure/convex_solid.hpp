#pragma once
// A convex solid of the structure, as the world collides with it, in the structure's own axes: x ahead, y up from the
// waterline, z to starboard.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vector.hpp"
#include "structure/polyhedron.hpp"

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
    double volume_below(double height) const;                   ///< of what lies below the height, m³
    std::vector<Vec2> section(double height, int sides) const;  ///< outline in (x, z); round ones as regular polygons
    /// Points whose hull it is, round ones with regular polygons of `sides` sides round them.
    std::vector<Vec3> corners(int sides) const;

    friend bool operator==(const ConvexSolid&, const ConvexSolid&) = default;
};

}  // namespace floes
