#include "shapes/hydrostatics.hpp"

#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "shapes/hull_sizes.hpp"
#include "shapes/moorings.hpp"
#include "shapes/polygon.hpp"

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

}  // namespace

Hydrostatics hydrostatics(const Shape& shape, const Plane& water) {
    const Vec3 along = (Vec3::UnitX() - water.normal.x() * water.normal).normalized();
    FLOES_EXPECTS(water.normal.y() > 0 && along.allFinite());
    const Vec3 across = along.cross(water.normal);
    const Vec3 origin = water.offset * water.normal;
    Hydrostatics found;
    std::vector<Measures> cut_out;  // in u across and v along the hull, within the water's surface
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
            Outline corners;
            for (const int corner : body.faces[face]) {
                const Vec3 from = body.corners[static_cast<std::size_t>(corner)] - origin;
                corners.push_back({from.dot(across), from.dot(along)});
            }
            cut_out.push_back(measures_of(corners));
        }
    }
    Corner centre;
    for (const Measures& one : cut_out) {
        found.waterplane += one.area;
        centre = centre + one.area * one.centroid;
    }
    if (!(found.waterplane > 0)) return found;
    centre = 1 / found.waterplane * centre;
    found.flotation = origin + centre.x * across + centre.z * along;
    for (const Measures& one : cut_out) {
        const Corner away = one.centroid - centre;
        found.about_length += one.xx + one.area * away.x * away.x;
        found.about_breadth += one.zz + one.area * away.z * away.z;
        found.product += one.xz + one.area * away.x * away.z;
    }
    return found;
}

Mat6 water_stiffness(const Hydrostatics& at_rest, double density, double gravity, double mass, double height) {
    const auto heave = static_cast<int>(Motion::heave);
    const auto pitch = static_cast<int>(Motion::pitch);
    const auto roll = static_cast<int>(Motion::roll);
    const double area = at_rest.waterplane;
    const double x = at_rest.flotation.x();
    const double z = at_rest.flotation.z();
    const double couple = density * at_rest.volume * at_rest.buoyancy.y() - mass * height;
    // A point of the waterplane rises by heave + pitch x - roll z.
    Mat6 found = Mat6::Zero();
    found(heave, heave) = density * area;
    found(pitch, pitch) = density * (at_rest.about_breadth + area * x * x) + couple;
    found(roll, roll) = density * (at_rest.about_length + area * z * z) + couple;
    found(heave, pitch) = found(pitch, heave) = density * area * x;
    found(heave, roll) = found(roll, heave) = -density * area * z;
    found(pitch, roll) = found(roll, pitch) = -density * (at_rest.product + area * x * z);
    return gravity * found;
}

}  // namespace floes
