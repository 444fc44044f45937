#include "outline/endless_cells.hpp"

#include <algorithm>
#include <utility>

namespace floes {
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

void EndlessCells::take(std::size_t count) {
    cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace floes
