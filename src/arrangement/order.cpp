#include "arrangement/order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/turn.hpp"

namespace floes {

namespace {

/// Cosine and sine of four times the yaw, from products only.
Vec2 fourfold(double yaw) {
    const auto [c, s] = turn_of(yaw);
    const double c2 = c * c - s * s;
    const double s2 = 2 * s * c;
    return {c2 * c2 - s2 * s2, 2 * s2 * c2};
}

using Polygon = std::vector<Vec2>;

Polygon corners(const Rectangle& shape, const PlanarPose& pose) {
    const Turn turn = turn_of(pose.yaw);
    const Vec2 a = shape.half_length * along(turn);
    const Vec2 b = shape.half_breadth * across(turn);
    const Vec2 middle(pose.x, pose.z);
    return {middle + a + b, middle - a + b, middle - a - b, middle + a - b};
}

/// The part of a convex polygon at which normal . point <= bound (Sutherland and Hodgman).
Polygon cut(const Polygon& polygon, const Vec2& normal, double bound) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& here = polygon[i];
        const Vec2& next = polygon[(i + 1) % polygon.size()];
        const double room_here = bound - normal.dot(here);
        const double room_next = bound - normal.dot(next);
        if (room_here >= 0) kept.push_back(here);
        if ((room_here >= 0) != (room_next >= 0))
            kept.push_back(here + room_here / (room_here - room_next) * (next - here));
    }
    return kept;
}

double area_of(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& here = polygon[i];
        const Vec2& next = polygon[(i + 1) % polygon.size()];
        twice += here.x() * next.y() - here.y() * next.x();
    }
    return 0.5 * std::abs(twice);
}

}  // namespace

double fourfold_order(std::span<const PlanarPose> poses) {
    Vec2 sum(0, 0);
    for (const PlanarPose& pose : poses) sum += fourfold(pose.yaw);
    return std::sqrt(sum.x() * sum.x() + sum.y() * sum.y()) / static_cast<double>(poses.size());
}

double local_order(std::span<const PlanarPose> poses) {
    constexpr std::size_t nearest = 4;
    if (poses.size() == 1) return 1;
    std::vector<Vec2> angles;
    for (const PlanarPose& pose : poses) angles.push_back(fourfold(pose.yaw));
    double sum = 0;
    std::vector<std::pair<double, std::size_t>> others;  // squared distance, number
    for (std::size_t i = 0; i < poses.size(); ++i) {
        others.clear();
        for (std::size_t j = 0; j < poses.size(); ++j) {
            const double dx = poses[j].x - poses[i].x;
            const double dz = poses[j].z - poses[i].z;
            if (j != i) others.emplace_back(dx * dx + dz * dz, j);
        }
        const auto count = std::min(nearest, others.size());
        std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(count));
        double of_floe = 0;
        for (std::size_t k = 0; k < count; ++k) of_floe += angles[i].dot(angles[others[k].second]);
        sum += of_floe / static_cast<double>(count);
    }
    return sum / static_cast<double>(poses.size());
}

double coverage(const Walls& area, std::span<const Rectangle> shapes, std::span<const PlanarPose> poses) {
    double covered = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        Polygon inside = cut(corners(shapes[i], poses[i]), {1, 0}, area.low_x + area.length);
        inside = cut(inside, {-1, 0}, -area.low_x);
        inside = cut(inside, {0, 1}, area.low_z + area.breadth);
        inside = cut(inside, {0, -1}, -area.low_z);
        covered += area_of(inside);
    }
    return covered / (area.length * area.breadth);
}

}  // namespace floes
