#include "structure/part_areas.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>

#include "structure/planes.hpp"

namespace floes {
namespace {

/// Flat and convex.
using Polygon = std::vector<Vec3>;

/// What of it has normal · p <= offset.
Polygon cut(const Polygon& polygon, const Plane& plane) {
    Polygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3& a = polygon[k];
        const Vec3& b = polygon[(k + 1) % polygon.size()];
        const double from = plane.height(a);
        const double to = plane.height(b);
        if (from <= 0) kept.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.emplace_back(a + (b - a) * (from / (from - to)));
    }
    return kept;
}

Plane opposite(const Plane& plane) {
    return {-plane.normal, -plane.offset};
}

double area(const Polygon& polygon) {
    Vec3 twice = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        twice += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
    return 0.5 * twice.norm();
}

/// A face, or what is left of it in view, and its plane.
struct View {
    std::vector<Polygon> left;
    Plane plane;
};

/// Takes from a face what lies in or against `other`, which may be its own neighbour. `first`: where both have the same
/// surface it is the other's.
void hide(View& face, const Polyhedron& other, bool first, double slack) {
    const auto own = [&](const Plane& one) { return same_plane(one, face.plane, slack); };
    if (!first && std::ranges::any_of(other.planes, own)) return;
    std::vector<Polygon> kept;
    for (Polygon& whole : face.left) {
        std::vector<Polygon> outside;
        Polygon within = whole;
        for (const Plane& plane : other.planes) {
            const auto height = [&](const Vec3& point) { return plane.height(point); };
            const auto [low, high] = std::ranges::minmax(within, {}, height);
            if (height(high) <= slack) continue;
            if (height(low) >= -slack) {
                within.clear();
                break;
            }
            outside.push_back(cut(within, opposite(plane)));
            within = cut(within, plane);
        }
        if (within.empty())
            kept.push_back(std::move(whole));
        else
            std::ranges::move(outside, std::back_inserter(kept));
    }
    face.left = std::move(kept);
}

void add_faces(std::span<const ConvexSolid> pieces, std::size_t number, const Vec2& heights, double slack,
               std::vector<double>& areas) {
    const ConvexSolid& piece = pieces[number];
    const auto& body = std::get<Polyhedron>(piece.form);
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        Polygon corners;
        for (const int k : body.faces[f]) corners.push_back(body.corners[static_cast<std::size_t>(k)]);
        corners = cut(cut(corners, {Vec3::UnitY(), heights.y()}), {-Vec3::UnitY(), -heights.x()});
        if (corners.empty()) continue;
        View face{{std::move(corners)}, body.planes[f]};
        for (std::size_t k = 0; k < pieces.size() && !face.left.empty(); ++k)
            if (k != number) hide(face, std::get<Polyhedron>(pieces[k].form), k < number, slack);
        const int part = piece.face_parts.empty() ? piece.part : piece.face_parts[f];
        for (const Polygon& one : face.left) areas[static_cast<std::size_t>(part)] += area(one);
    }
}

double area_of(const ConvexSolid& leg, double low, double high) {
    const auto& round = std::get<Frustum>(leg.form);
    const double bottom = round.bottom_height + leg.place.y();
    const double top = round.top_height + leg.place.y();
    const auto disk = [](double radius) { return std::numbers::pi * radius * radius; };
    double area = 0;
    if (low <= bottom && bottom <= high) area += disk(round.bottom_radius);
    if (low <= top && top <= high) area += disk(round.top_radius);
    const double from = std::max(low, bottom);
    const double to = std::min(high, top);
    if (from >= to) return area;
    const double a = round.radius_at(from - leg.place.y());
    const double b = round.radius_at(to - leg.place.y());
    return area + std::numbers::pi * (a + b) * std::hypot(to - from, b - a);
}

}  // namespace

std::vector<double> part_areas(const Shape& shape, double low, double high) {
    if (shape.is_of_revolution()) return {};
    const std::vector<ConvexSolid> pieces = shape.solids();
    std::vector<double> areas(shape.parts().size());
    if (shape.kind() == HullKind::four_legs) {  // they stand apart
        for (const ConvexSolid& leg : pieces) areas[static_cast<std::size_t>(leg.part)] += area_of(leg, low, high);
        return areas;
    }
    const double slack = flat * size_of(pieces);
    for (std::size_t k = 0; k < pieces.size(); ++k) add_faces(pieces, k, {low, high}, slack, areas);
    return areas;
}

}  // namespace floes
