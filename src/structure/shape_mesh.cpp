// The surface of a shape, for whoever draws it.

#include <cmath>
#include <numbers>

#include "structure/shape.hpp"

namespace floes {

Vec3 SurfaceMesh::normal(const std::vector<int>& polygon) const {
    Vec3 twice_area = Vec3::Zero();  // Newell's sum
    const Vec3& first = points[static_cast<std::size_t>(polygon.front())];
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec3 a = points[static_cast<std::size_t>(polygon[k])] - first;
        const Vec3 b = points[static_cast<std::size_t>(polygon[k + 1])] - first;
        twice_area += a.cross(b);
    }
    const double size = twice_area.norm();
    return size > 0 ? Vec3(twice_area / size) : Vec3(Vec3::Zero());
}

namespace {

SurfaceMesh mesh_of(const std::vector<ProfilePoint>& profile, int sides) {
    const int rings = static_cast<int>(profile.size());
    SurfaceMesh mesh;
    for (const ProfilePoint& ring : profile) {
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides;
            mesh.points.emplace_back(ring.radius * std::cos(angle), ring.height, ring.radius * std::sin(angle));
        }
    }
    // Points of a ring run from x to z: clockwise as seen from above.
    std::vector<int> keel;
    std::vector<int> deck;
    for (int side = 0; side < sides; ++side) {
        keel.push_back(side);
        deck.push_back(rings * sides - 1 - side);
    }
    mesh.polygons = {keel, deck};
    for (int ring = 0; ring + 1 < rings; ++ring) {
        for (int side = 0; side < sides; ++side) {
            const int low = ring * sides;
            const int next = (side + 1) % sides;
            mesh.polygons.push_back({low + side, low + side + sides, low + next + sides, low + next});
        }
    }
    return mesh;
}

void add(SurfaceMesh& all, const SurfaceMesh& one, const Vec3& place) {
    const int first = static_cast<int>(all.points.size());
    for (const Vec3& point : one.points) all.points.emplace_back(point + place);
    for (std::vector<int> polygon : one.polygons) {
        for (int& corner : polygon) corner += first;
        all.polygons.push_back(std::move(polygon));
    }
}

}  // namespace

SurfaceMesh Shape::mesh(int sides) const {
    if (is_of_revolution()) return mesh_of(in_force().points(), sides);
    SurfaceMesh all;
    for (const ConvexSolid& solid : pieces().solids) {
        if (const auto* round = std::get_if<Frustum>(&solid.form))
            add(all,
                mesh_of({{round->bottom_height, round->bottom_radius}, {round->top_height, round->top_radius}}, sides),
                solid.place);
        else
            add(all, {std::get<Polyhedron>(solid.form).corners, std::get<Polyhedron>(solid.form).faces}, solid.place);
    }
    return all;
}

}  // namespace floes
