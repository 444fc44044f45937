#include "structure/measures.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "structure/shape.hpp"

namespace floes {
namespace {

constexpr int lines_across = 200;

struct Box {
    Vec3 low, high;
};

Box box_of(const ConvexSolid& solid) {
    Box box;
    for (int k = 0; k < 3; ++k) {
        box.low[k] = (solid.place + solid.farthest(-Vec3::Unit(k)))[k];
        box.high[k] = (solid.place + solid.farthest(Vec3::Unit(k)))[k];
    }
    return box;
}

bool meet(const Box& a, const Box& b) {
    return (a.low.array() < b.high.array()).all() && (b.low.array() < a.high.array()).all();
}

/// Where the line along x through (y, z) lies in a polyhedron.
std::pair<double, double> covered(const Polyhedron& body, double y, double z) {
    double from = -1e300;
    double to = 1e300;
    for (const Plane& plane : body.planes) {
        const double left = plane.offset - plane.normal.y() * y - plane.normal.z() * z;
        const double slope = plane.normal.x();
        if (slope > 1e-12)
            to = std::min(to, left / slope);
        else if (slope < -1e-12)
            from = std::max(from, left / slope);
        else if (left < 0)
            return {0, 0};
    }
    return {from, to};
}

double covered_length(std::vector<std::pair<double, double>>& spans) {
    std::ranges::sort(spans);
    double length = 0;
    double reached = -1e300;
    for (const auto& [from, to] : spans) {
        if (to <= reached) continue;
        length += to - std::max(from, reached);
        reached = to;
    }
    return length;
}

/// Islands of outlines whose bounding boxes meet, each as the box round its outlines.
std::vector<Box> islands(const std::vector<std::vector<Vec2>>& outlines) {
    std::vector<Box> boxes;
    for (const std::vector<Vec2>& outline : outlines) {
        if (outline.empty()) continue;
        Box box{{1e300, -1, 1e300}, {-1e300, 1, -1e300}};
        for (const Vec2& point : outline) {
            box.low = box.low.cwiseMin(Vec3(point.x(), -1, point.y()));
            box.high = box.high.cwiseMax(Vec3(point.x(), 1, point.y()));
        }
        const double slack = 1e-3 * (box.high - box.low).norm();
        for (std::size_t k = 0; k < boxes.size();) {
            Box wider = boxes[k];
            wider.low.array() -= slack;
            wider.high.array() += slack;
            if (!meet(box, wider)) {
                ++k;
                continue;
            }
            box = {box.low.cwiseMin(boxes[k].low), box.high.cwiseMax(boxes[k].high)};
            boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(k));
            k = 0;
        }
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace

double union_volume(std::span<const ConvexSolid> solids) {
    std::vector<Box> boxes;
    for (const ConvexSolid& solid : solids) boxes.push_back(box_of(solid));
    bool apart = true;
    for (std::size_t a = 0; a < boxes.size(); ++a)
        for (std::size_t b = a + 1; b < boxes.size(); ++b) apart = apart && !meet(boxes[a], boxes[b]);
    const bool flat = std::ranges::all_of(
        solids, [](const ConvexSolid& one) { return std::holds_alternative<Polyhedron>(one.form); });
    if (apart || !flat)
        return std::accumulate(solids.begin(), solids.end(), 0.0,
                               [](double sum, const ConvexSolid& one) { return sum + one.volume(); });
    Box all = boxes.front();
    for (const Box& box : boxes) all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
    const double rise = (all.high.y() - all.low.y()) / lines_across;
    const double way = (all.high.z() - all.low.z()) / lines_across;
    double length = 0;
    std::vector<std::pair<double, double>> spans;
    for (int i = 0; i < lines_across; ++i) {
        for (int k = 0; k < lines_across; ++k) {
            const double y = all.low.y() + (i + 0.5) * rise;
            const double z = all.low.z() + (k + 0.5) * way;
            spans.clear();
            for (std::size_t s = 0; s < solids.size(); ++s) {
                if (y < boxes[s].low.y() || y > boxes[s].high.y() || z < boxes[s].low.z() || z > boxes[s].high.z())
                    continue;
                const auto [from, to] = covered(std::get<Polyhedron>(solids[s].form), y, z);
                if (to > from) spans.emplace_back(from, to);
            }
            length += covered_length(spans);
        }
    }
    return length * rise * way;
}

double Shape::volume() const {
    return union_volume(solids());
}

double Shape::displacement() const {
    double volume = 0;
    for (const ConvexSolid& solid : solids()) volume += solid.volume_below(0);
    return volume;
}

double Shape::waterplane_area() const {
    if (is_of_revolution()) {
        const double radius = waterline_radius();
        return std::numbers::pi * radius * radius;
    }
    double area = 0;
    for (const ConvexSolid& solid : pieces().solids) {
        const auto* round = std::get_if<Frustum>(&solid.form);
        if (round != nullptr) {
            const double radius = round->radius_at(-solid.place.y());
            area += std::numbers::pi * radius * radius;
        } else {
            area += area_of(solid.section(0, round_sides));
        }
    }
    return area;
}

std::vector<std::vector<Vec2>> Shape::waterlines() const {
    std::vector<std::vector<Vec2>> outlines;
    if (is_of_revolution()) {
        const double radius = waterline_radius();
        outlines.push_back(ConvexSolid(Frustum{-1, radius, 1, radius}).section(0, round_sides));
        return outlines;
    }
    for (const ConvexSolid& solid : pieces().solids)
        if (auto outline = solid.section(0, round_sides); !outline.empty()) outlines.push_back(std::move(outline));
    return outlines;
}

std::vector<WaterlineEllipse> Shape::waterline_ellipses() const {
    if (is_of_revolution()) return {{0, 0, waterline_radius(), waterline_radius()}};
    std::vector<Box> found = islands(waterlines());
    if (found.size() > most_ellipses) {
        Box all = found.front();
        for (const Box& box : found) all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
        found = {all};
    }
    std::vector<WaterlineEllipse> ellipses;
    for (const Box& box : found) {
        const Vec3 middle = 0.5 * (box.low + box.high);
        const Vec3 half = 0.5 * (box.high - box.low);
        ellipses.push_back({middle.x(), middle.z(), half.x(), half.z()});
    }
    return ellipses;
}

std::vector<std::vector<Vec2>> Shape::side_view() const {
    if (is_of_revolution()) return {in_force().side_view()};
    std::vector<std::vector<Vec2>> outlines;
    for (const ConvexSolid& solid : pieces().solids) {
        std::vector<Vec2> points;
        for (const Vec3& corner : solid.corners(round_sides)) points.emplace_back(corner.x(), corner.y());
        outlines.push_back(convex_outline(std::move(points)));
    }
    return outlines;
}

}  // namespace floes
