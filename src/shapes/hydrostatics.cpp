#include "shapes/hydrostatics.hpp"

#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "shapes/hull_sizes.hpp"

namespace floes {

namespace {

/// A solid as a polyhedron, round walls as regular polygons with the circles' area.
Polyhedron polyhedron_of(const ConvexSolid& solid) {
    std::vector<Vec3> corners = solid.corners(round_sides);
    if (std::holds_alternative<Frustum>(solid.form)) {
        constexpr double angle = 2 * std::numbers::pi / round_sides;
        const double wider = std::sqrt(angle / std::sin(angle));
        for (Vec3& corner : corners) {
            corner.x() = solid.place.x() + wider * (corner.x() - solid.place.x());
            corner.z() = solid.place.z() + wider * (corner.z() - solid.place.z());
        }
    }
    return convex_hull(corners);
}

/// Area, first and second moments of polygons in a plane, in its coordinates (u, v).
struct PlaneMoments {
    double area = 0, u = 0, v = 0, uu = 0, vv = 0;

    void add(const std::vector<Vec2>& corners) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2& a = corners[i];
            const Vec2& b = corners[(i + 1) % corners.size()];
            const double twice = a.x() * b.y() - b.x() * a.y();
            area += twice / 2;
            u += twice * (a.x() + b.x()) / 6;
            v += twice * (a.y() + b.y()) / 6;
            uu += twice * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 12;
            vv += twice * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 12;
        }
    }
};

}  // namespace

Hydrostatics hydrostatics(const Shape& shape, const Plane& water) {
    const Vec3 along = (Vec3::UnitX() - water.normal.x() * water.normal).normalized();
    FLOES_EXPECTS(water.normal.y() > 0 && along.allFinite());
    const Vec3 across = along.cross(water.normal);
    const Vec3 origin = water.offset * water.normal;
    Hydrostatics found;
    PlaneMoments cut_out;
    std::vector<ConvexSolid> wet;
    for (const ConvexSolid& solid : shape.solids()) {
        Polyhedron below = polyhedron_of(solid).cut(water);
        if (below.empty()) continue;
        const double volume = below.volume();
        found.volume += volume;
        found.buoyancy += volume * below.centroid();
        wet.emplace_back(std::move(below));
    }
    if (wet.empty()) return found;
    found.buoyancy /= found.volume;
    const double slack = plane_rounding * size_of(wet);
    for (const ConvexSolid& solid : wet) {
        const auto& body = std::get<Polyhedron>(solid.form);
        for (std::size_t face = 0; face < body.faces.size(); ++face) {
            if (!same_plane(body.planes[face], water, slack)) continue;
            std::vector<Vec2> corners;
            for (const int corner : body.faces[face]) {
                const Vec3 from = body.corners[static_cast<std::size_t>(corner)] - origin;
                corners.emplace_back(from.dot(across), from.dot(along));
            }
            cut_out.add(corners);
        }
    }
    found.waterplane = cut_out.area;
    if (!(cut_out.area > 0)) return found;
    const double u = cut_out.u / cut_out.area;
    const double v = cut_out.v / cut_out.area;
    found.flotation = origin + u * across + v * along;
    found.about_length = cut_out.uu - cut_out.area * u * u;
    found.about_breadth = cut_out.vv - cut_out.area * v * v;
    return found;
}

}  // namespace floes
