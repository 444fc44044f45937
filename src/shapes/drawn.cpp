#include "shapes/drawn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/contract.hpp"
#include "core/turn.hpp"

namespace floes {

std::vector<Corner> thrown_points(const WaterArea& area, std::size_t count, RandomStream& random) {
    std::vector<Corner> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.uniform(area.low_x, area.low_x + area.length);
        points.push_back({x, random.uniform(area.low_z, area.low_z + area.breadth)});
    }
    return points;
}

/// Corners nearer than this share of the cell's reach are one: whoever lies beside it has to see the same edges,
/// however wide the area is.
constexpr double exact = 1e-6;

Outline voronoi_cell(const WaterArea& area, Corners by_x, std::size_t point) {
    const Corner& own = by_x[point];
    const double right = area.low_x + area.length;
    const double high = area.low_z + area.breadth;
    Outline cell{{area.low_x, area.low_z}, {right, area.low_z}, {right, high}, {area.low_x, high}};
    double reach = reach_of(in_axes(cell, own, {1, 0}));
    // Neighbours in the order of their distance along x, until none can matter.
    const auto meet = [&](std::size_t other) {
        const Corner apart = by_x[other] - own;
        const double distance = std::sqrt(dot(apart, apart));
        if (distance > 2 * reach || !(distance > 0)) return;
        const Corner normal = (1 / distance) * apart;
        const Outline left = clipped(cell, {normal, dot(normal, own) + 0.5 * distance});
        if (left.empty() || left == cell) return;
        cell = left;
        reach = reach_of(in_axes(cell, own, {1, 0}));
    };
    const auto along = [&](std::size_t other) { return std::abs(by_x[other].x - own.x); };
    std::size_t before = point;
    std::size_t next = point + 1;
    for (;;) {
        const bool back = before > 0 && along(before - 1) <= 2 * reach;
        const bool on = next < by_x.size() && along(next) <= 2 * reach;
        if (!back && !on) return tidied(cell, exact * reach);
        if (back && (!on || along(before - 1) < along(next)))
            meet(--before);
        else
            meet(next++);
    }
}

std::vector<Outline> voronoi_cells(const WaterArea& area, Corners points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t n) { return points[n]; });
    std::vector<Corner> by_x;
    for (const std::size_t n : order) by_x.push_back(points[n]);
    std::vector<Outline> cells(points.size());
    for (std::size_t place = 0; place < order.size(); ++place) cells[order[place]] = voronoi_cell(area, by_x, place);
    return cells;
}

namespace {

double sum_of_areas(const std::vector<Outline>& outlines) {
    double sum = 0;
    for (const Outline& one : outlines)
        if (!one.empty()) sum += area_of(one);
    return sum;
}

std::vector<Outline> all_eroded(const std::vector<Outline>& outlines, double offset) {
    std::vector<Outline> left;
    for (const Outline& one : outlines) left.push_back(eroded(one, offset));
    return left;
}

}  // namespace

std::vector<Outline> voronoi_cells(const WaterArea& area, int count, int relaxations, RandomStream& random) {
    FLOES_EXPECTS(count >= 1 && relaxations >= 0);
    std::vector<Corner> points = thrown_points(area, static_cast<std::size_t>(count), random);
    std::vector<Outline> cells = voronoi_cells(area, points);
    for (int step = 0; step < relaxations; ++step) {
        for (std::size_t i = 0; i < points.size(); ++i) points[i] = measures_of(cells[i]).centroid;
        cells = voronoi_cells(area, points);
    }
    return cells;
}

Shrunk shrunk_to(const std::vector<Outline>& outlines, double area) {
    FLOES_EXPECTS(area > 0);
    double low = 0;
    double high = 0;
    for (const Outline& one : outlines) high = std::max(high, 0.5 * std::min(size_of(one).x, size_of(one).z));
    for (int halving = 0; halving < 200; ++halving) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high) break;
        (sum_of_areas(all_eroded(outlines, middle)) >= area ? low : high) = middle;
    }
    return {all_eroded(outlines, low), low};
}

Outline polygon_about(double length, double breadth, int corners, double irregularity, RandomStream& random) {
    FLOES_EXPECTS(length > 0 && breadth > 0 && corners >= 3 && irregularity >= 0);
    Outline outline;
    for (int k = 0; k < corners; ++k) {
        const double way = (k + irregularity * (random.uniform() - 0.5)) / corners;
        const Turn at = turn_of(2 * std::numbers::pi * way);
        outline.push_back({length * at.cos, breadth * at.sin});
    }
    const Measures measures = measures_of(outline);
    const double scale = std::sqrt(length * breadth / measures.area);
    for (Corner& one : outline) one = scale * (one - measures.centroid);
    return outline;
}

namespace {

/// Whether points beyond `known` are too far to cut a cell.
bool is_certain(Corners cell, const Corner& point, double known) {
    return std::ranges::all_of(cell, [&](const Corner& corner) {
        const Corner apart = corner - point;
        const double room = known - corner.x;
        return room > 0 && dot(apart, apart) <= room * room;
    });
}

}  // namespace

EndlessCells::EndlessCells(const WaterArea& area, int relaxations)
    : strip_(area),
      begin_(area.low_x),
      end_(area.low_x),
      diagrams_(static_cast<std::size_t>(relaxations) + 1, {{}, area.low_x}),
      cells_known_(area.low_x) {}

void EndlessCells::add(std::span<const Corner> points) {
    end_ += strip_.length;
    Diagram* diagram = &diagrams_.front();
    diagram->known = end_;
    for (const Corner& point : points) diagram->points.push_back({point});
    for (std::size_t step = 1; step < diagrams_.size(); ++step) {
        Diagram& next = diagrams_[step];
        for (const Cell& cell : settle(*diagram, next.known)) next.points.push_back({cell.centroid});
        diagram = &next;
    }
    for (Cell& cell : settle(*diagram, cells_known_)) cells_.push_back(std::move(cell));
    std::ranges::sort(cells_, {}, &Cell::centroid);
}

/// The cells that became certain; known_next: where the cells that may still change began, and where they begin now.
std::vector<EndlessCells::Cell> EndlessCells::settle(Diagram& diagram, double& known_next) const {
    if (diagram.points.empty()) return {};  // too early for so many steps
    std::ranges::sort(diagram.points, {}, &Point::at);
    std::vector<Corner> by_x;
    for (const Point& point : diagram.points) by_x.push_back(point.at);
    // None of the cells that are looked at reaches behind known_next.
    const double low = std::max(begin_, known_next - strip_.breadth);
    const WaterArea area{low, strip_.low_z, end_ - low, strip_.breadth};
    std::vector<Cell> certain;
    double known = end_;
    for (std::size_t i = 0; i < diagram.points.size(); ++i) {
        Point& point = diagram.points[i];
        if (point.certain) continue;
        Outline cell = voronoi_cell(area, by_x, i);
        const auto [first, last] = std::ranges::minmax(cell, {}, &Corner::x);
        if (!is_certain(cell, point.at, diagram.known)) {
            known = std::min(known, first.x);
            continue;
        }
        point.certain = true;
        point.last_x = last.x;
        certain.push_back({measures_of(cell).centroid, std::move(cell)});
    }
    known_next = known;
    std::erase_if(diagram.points, [&](const Point& point) { return point.certain && point.last_x < known; });
    return certain;
}

std::size_t EndlessCells::ready() const {
    const auto is_next = [&](const Cell& cell) { return cell.centroid.x < cells_known_; };
    return static_cast<std::size_t>(std::ranges::count_if(cells_, is_next));
}

}  // namespace floes
