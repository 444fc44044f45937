#include "structure/polyhedron.hpp"

#include <algorithm>
#include <cmath>

namespace floes {
namespace {

/// Volume and first moments of the tetrahedra from the first corner to the triangles of the faces.
std::pair<double, Vec3> measures(const Polyhedron& body) {
    double volume = 0;
    Vec3 moment = Vec3::Zero();
    const Vec3 apex = body.empty() ? Vec3::Zero() : body.corners.front();
    for (const std::vector<int>& face : body.faces) {
        const auto corner = [&](std::size_t k) -> const Vec3& {
            return body.corners[static_cast<std::size_t>(face[k])];
        };
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            const Vec3 a = corner(0) - apex;
            const Vec3 b = corner(k) - apex;
            const Vec3 c = corner(k + 1) - apex;
            const double part = a.dot(b.cross(c)) / 6;
            volume += part;
            moment += part * (a + b + c) / 4;
        }
    }
    return {volume, moment};
}

}  // namespace

Vec3 Polyhedron::farthest(const Vec3& direction) const {
    const Vec3* best = &corners.front();
    double reach = best->dot(direction);
    for (const Vec3& corner : corners) {
        const double here = corner.dot(direction);
        if (here <= reach) continue;
        reach = here;
        best = &corner;
    }
    return *best;
}

double Polyhedron::volume() const {
    return measures(*this).first;
}

Vec3 Polyhedron::centroid() const {
    const auto [volume, moment] = measures(*this);
    return corners.front() + moment / volume;
}

Polyhedron Polyhedron::inside(double depth) const {
    if (empty()) return {};
    std::vector<Plane> within = planes;
    for (Plane& plane : within) plane.offset -= depth;
    return intersection(within, centroid());
}

Polyhedron Polyhedron::scaled(double factor) const {
    Polyhedron other = *this;
    for (Vec3& corner : other.corners) corner *= factor;
    for (Plane& plane : other.planes) plane.offset *= factor;
    return other;
}

Polyhedron Polyhedron::cut(const Plane& plane, double slack) const {
    std::vector<Vec3> kept;
    for (const Vec3& corner : corners)
        if (plane.height(corner) <= slack) kept.push_back(corner);
    if (kept.size() == corners.size()) return *this;
    if (std::ranges::all_of(kept, [&](const Vec3& corner) { return plane.height(corner) >= -slack; })) return {};
    for (const std::vector<int>& face : faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& a = corners[static_cast<std::size_t>(face[k])];
            const Vec3& b = corners[static_cast<std::size_t>(face[(k + 1) % face.size()])];
            const double low = plane.height(a);
            const double high = plane.height(b);
            if (low < -slack && high > slack) kept.emplace_back(a + (b - a) * (low / (low - high)));
        }
    }
    return convex_hull(kept);
}

std::vector<Vec2> Polyhedron::section(double y) const {
    std::vector<Vec2> crossed;
    for (const std::vector<int>& face : faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Vec3& a = corners[static_cast<std::size_t>(face[k])];
            const Vec3& b = corners[static_cast<std::size_t>(face[(k + 1) % face.size()])];
            if (a.y() == y) crossed.emplace_back(a.x(), a.z());
            if ((a.y() < y) == (b.y() < y) || a.y() == y || b.y() == y) continue;
            const double share = (y - a.y()) / (b.y() - a.y());
            crossed.emplace_back(a.x() + share * (b.x() - a.x()), a.z() + share * (b.z() - a.z()));
        }
    }
    return convex_outline(std::move(crossed));
}

// Andrew's monotone chain.
std::vector<Vec2> convex_outline(std::vector<Vec2> points) {
    const auto less = [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); };
    std::ranges::sort(points, less);
    points.erase(std::ranges::unique(points).begin(), points.end());
    if (points.size() < 3) return {};
    const auto turns = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0;
    };
    std::vector<Vec2> outline;
    const auto add_chain = [&](auto begin, auto end) {
        const std::size_t start = outline.size();
        for (auto point = begin; point != end; ++point) {
            while (outline.size() >= start + 2 && !turns(outline[outline.size() - 2], outline.back(), *point))
                outline.pop_back();
            outline.push_back(*point);
        }
        outline.pop_back();
    };
    add_chain(points.begin(), points.end());
    add_chain(points.rbegin(), points.rend());
    return outline.size() < 3 ? std::vector<Vec2>{} : outline;
}

double area_of(std::span<const Vec2> outline) {
    double twice = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2& a = outline[k];
        const Vec2& b = outline[(k + 1) % outline.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

}  // namespace floes
