#include "arrangement/order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "arrangement/crowd.hpp"
#include "core/contract.hpp"
#include "core/turn.hpp"
#include "shapes/convex_solid.hpp"

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

std::array<HalfPlane, 4> sides_of(const Walls& area) {
    return {{{{1, 0}, area.low_x + area.length},
             {{-1, 0}, -area.low_x},
             {{0, 1}, area.low_z + area.breadth},
             {{0, -1}, -area.low_z}}};
}

CellArea area_around(std::span<const PlanarPose> poses) {
    const auto [left, right] = std::ranges::minmax(poses, {}, &PlanarPose::x);
    const auto [low, high] = std::ranges::minmax(poses, {}, &PlanarPose::z);
    return {left.x, low.z, right.x - left.x, high.z - low.z};
}

/// Mean spacing of floes spread over an area, or along a line, m.
double mean_spacing(const CellArea& area, std::size_t floes) {
    FLOES_EXPECTS(floes >= 1);
    const auto count = static_cast<double>(floes);
    return std::max(std::sqrt(area.length * area.breadth / count), std::max(area.length, area.breadth) / count);
}

Cells cells_of(std::span<const PlanarPose> poses, const CellArea& area, double reach) {
    Cells cells(area, reach, poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) cells.insert({poses[i].x, poses[i].z, {}, static_cast<int>(i)});
    return cells;
}

}  // namespace

double fourfold_order(std::span<const PlanarPose> poses) {
    Vec2 sum(0, 0);
    for (const PlanarPose& pose : poses) sum += fourfold(pose.yaw);
    return std::sqrt(sum.x() * sum.x() + sum.y() * sum.y()) / static_cast<double>(poses.size());
}

double local_order(std::span<const PlanarPose> poses) {
    const std::size_t nearest = std::min<std::size_t>(4, poses.size() - 1);
    if (nearest == 0) return 1;
    std::vector<Vec2> angles;
    for (const PlanarPose& pose : poses) angles.push_back(fourfold(pose.yaw));
    std::vector<double> of_floe(poses.size());
    std::vector<std::size_t> left(poses.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<std::pair<double, std::size_t>> others;  // squared distance, number
    const CellArea area = area_around(poses);
    // Twice the mean distance between neighbours holds four of most floes. The others are looked for farther off.
    for (double reach = 2 * mean_spacing(area, poses.size()); !left.empty(); reach *= 2) {
        const Cells cells = cells_of(poses, area, reach);
        std::erase_if(left, [&](std::size_t i) {
            others.clear();
            cells.for_each_near(poses[i].x, poses[i].z, [&](const Resident& other) {
                const double dx = other.x - poses[i].x;
                const double dz = other.z - poses[i].z;
                const double squared = dx * dx + dz * dz;
                const auto j = static_cast<std::size_t>(other.floe);
                if (j != i && squared <= reach * reach) others.emplace_back(squared, j);
            });
            if (others.size() < nearest) return false;
            std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(nearest));
            for (std::size_t k = 0; k < nearest; ++k) of_floe[i] += angles[i].dot(angles[others[k].second]);
            of_floe[i] /= static_cast<double>(nearest);
            return true;
        });
    }
    return std::accumulate(of_floe.begin(), of_floe.end(), 0.0) / static_cast<double>(poses.size());
}

double coverage(const Walls& area, std::span<const Outline> outlines) {
    double covered = 0;
    for (Outline inside : outlines) {
        for (const HalfPlane& half : sides_of(area))
            if (!inside.empty()) inside = clipped(inside, half);
        if (!inside.empty()) covered += std::abs(area_of(inside));
    }
    return covered / (area.length * area.breadth);
}

double coverage(const Walls& area, std::span<const Rectangle> shapes, std::span<const PlanarPose> poses) {
    double covered = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        Polygon inside = corners(shapes[i], poses[i]);
        for (const auto& [normal, bound] : sides_of(area)) inside = cut(inside, {normal.x, normal.z}, bound);
        covered += std::abs(area_of(inside));
    }
    return covered / (area.length * area.breadth);
}

}  // namespace floes
