#include "scenario/shaped_floes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
    for (std::size_t i = 0; i < floes.size(); ++i) lay_cell(floes[i], cells.outlines[i]);
}

}  // namespace

bool is_floe(Corners outline, double thickness) {
    return outline.size() >= 3 && outline.size() + 8 <= most_corners && inner_radius(outline) > thickness / 2;
}

void lay_cell(SingleFloe& floe, const Outline& cell) {
    const Measures measures = measures_of(cell);
    floe.pose = {measures.centroid.x, measures.centroid.z, yaw_of(long_axis(measures))};
    const Turn turn = turn_of(floe.pose.yaw);
    give(floe.shape, tidied(cell, shortest_edge * std::sqrt(measures.area)), measures.centroid, {turn.cos, -turn.sin});
}

void check_gap(const Scenario& scenario, double offset) {
    const double clearance = scenario.arrangement.clearance;
    if (offset >= clearance) return;  // from the walls; apart from each other they are twice as far
    throw InputError(fmt::format(
        "Voronoi cells at field.concentration_percent = {:g} are {:.4g} m apart and {:.4g} m from the walls, less "
        "than arrangement.clearance_m = {:g}; lower one of the two",
        100 * scenario.field.concentration, 2 * offset, offset, clearance));
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
