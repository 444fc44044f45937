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

SurfaceMesh Shape::mesh(int sides) const {
    const int rings = static_cast<int>(profile_.size());
    SurfaceMesh mesh;
    for (const ProfilePoint& ring : profile_) {
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

}  // namespace floes
