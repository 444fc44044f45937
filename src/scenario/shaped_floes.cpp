#include "scenario/shaped_floes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/turn.hpp"
#include "outline/drawn.hpp"
#include "outline/elements.hpp"

namespace floes {
namespace {

constexpr double shortest_edge = 1e-4;  // of the root of the area; shorter ones go

/// The outline about its centroid, in axes turned by `axis`.
void give(FloeShape& shape, Corners outline, const Corner& centre, const Corner& axis) {
    shape.outline = in_axes(outline, centre, axis);
    const Corner size = size_of(shape.outline);
    shape.length = size.x;
    shape.breadth = size.z;
}

/// Along its long axis, in single precision, so that it does not show that C libraries differ in the last bits.
double yaw_of(const Corner& axis) {
    return static_cast<float>(std::atan2(-axis.z, axis.x));
}

void grow_cells(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    constexpr int attempts = 20;
    const Field& field = scenario.field;
    const double breadth = 2 * field.half_width;
    const double length = scenario.field_length();
    RandomStream random(draw.seed, draw.number, StreamId::voronoi, 0);
    Shrunk cells;
    bool found = false;
    for (int attempt = 0; attempt < attempts && !found; ++attempt) {
        cells = shrunk_to(voronoi_cells({field.begin, -field.half_width, length, breadth},
                                        static_cast<int>(floes.size()), scenario.shapes.relaxations, random),
                          field.concentration * length * breadth);
        found = std::ranges::all_of(cells.outlines,
                                    [&](const Outline& one) { return is_floe(one, scenario.floe.thickness); });
    }
    if (!found)
        throw InputError(fmt::format(
            "shapes.relaxations = {} left a Voronoi cell that is narrower than the ice is thick after its edges moved "
            "in by {:.4g} m, in each of {} attempts; relax more, raise field.concentration_percent or take larger "
            "floes",
            scenario.shapes.relaxations, cells.offset, attempts));
    check_gap(scenario, cells.offset);
    for (std::size_t i = 0; i < floes.size(); ++i) lie_as(floes[i], cells.outlines[i]);
}

}  // namespace

bool is_floe(Corners outline, double thickness) {
    return outline.size() >= 3 && outline.size() <= most_outline_corners && inner_radius(outline) > thickness / 2;
}

void lie_as(SingleFloe& floe, Corners outline) {
    const Measures measures = measures_of(outline);
    floe.pose = {measures.centroid.x, measures.centroid.z, yaw_of(long_axis(measures))};
    const Turn turn = turn_of(floe.pose.yaw);
    give(floe.shape, tidied(outline, shortest_edge * std::sqrt(measures.area)), measures.centroid,
         {turn.cos, -turn.sin});
}

void check_gap(const Scenario& scenario, double offset) {
    const double clearance = scenario.arrangement.clearance;
    if (offset >= clearance) return;  // from the walls; apart from each other they are twice as far
    throw InputError(fmt::format(
        "Voronoi cells at field.concentration_percent = {:g} are {:.4g} m apart and {:.4g} m from the walls, less "
        "than arrangement.clearance_m = {:g}; lower one of the two",
        100 * scenario.field.concentration, 2 * offset, offset, clearance));
}

std::vector<SingleFloe> floes_as_traced(const Scenario& scenario) {
    const TracedOutlines& traced = scenario.shapes.traced;
    const Corner origin{scenario.field.begin + scenario.arrangement.clearance, 0};
    std::vector<SingleFloe> floes;
    for (const Outline& one : traced.outlines) {
        Outline placed;
        for (const Corner& corner : one) placed.push_back(origin + traced.scale * corner);
        if (area_of(placed) < 0) std::ranges::reverse(placed);
        lie_as(floes.emplace_back(SingleFloe{{}, scenario.floe, scenario.material()}), placed);
    }
    return floes;
}

std::vector<FloeShape> traced_shapes(const Scenario& scenario) {
    const std::vector<SingleFloe> stock = floes_as_traced(scenario);
    std::vector<std::size_t> by_area(stock.size());
    std::iota(by_area.begin(), by_area.end(), std::size_t{0});
    std::ranges::stable_sort(by_area, {}, [&](std::size_t i) { return stock[i].shape.area(); });
    const auto floes = static_cast<std::size_t>(scenario.field.floes);
    std::vector<FloeShape> shapes;
    for (std::size_t i = 0; i < floes && !stock.empty(); ++i)
        shapes.push_back(stock[by_area[(2 * i + 1) * stock.size() / (2 * floes)]].shape);
    return shapes;
}

std::vector<double> traced_added(const TracedOutlines& traced) {
    std::vector<double> added;
    for (std::size_t i = 0; i < traced.areas.size(); ++i)
        added.push_back(std::abs(area_of(traced.outlines[i])) / traced.areas[i] - 1);
    return added;
}

std::string outline_name(const TracedOutlines& traced, std::size_t number) {
    std::istringstream names(traced.names);
    std::string name;
    for (std::size_t k = 0; k <= number; ++k)
        if (!std::getline(names >> std::ws, name, ',')) return fmt::format("outline {}", number + 1);
    return fmt::format("outline {} \"{}\"", number + 1, name);
}

void shape_floes(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    const Shapes& shapes = scenario.shapes;
    if (shapes.kind == ShapeKind::voronoi && draw.part == 0) grow_cells(scenario, draw, floes);
    if (shapes.kind != ShapeKind::polygon) return;
    RandomStream random(draw.seed, draw.number, StreamId::polygons, draw.part);
    for (SingleFloe& floe : floes) {
        const Outline outline =
            polygon_about(floe.shape.length, floe.shape.breadth, shapes.corners, shapes.irregularity, random);
        const Measures measures = measures_of(outline);
        give(floe.shape, tidied(outline, shortest_edge * std::sqrt(measures.area)), measures.centroid,
             long_axis(measures));
    }
}

}  // namespace floes
