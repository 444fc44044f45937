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

/// Whether each floe is a sheet that can be cut into elements.
bool are_floes(const std::vector<Outline>& outlines, double thickness) {
    return std::ranges::all_of(outlines, [&](const Outline& one) {
        return one.size() >= 3 && one.size() + 8 <= most_corners && inner_radius(one) > thickness / 2;
    });
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
        found = are_floes(cells.outlines, scenario.floe.thickness);
    }
    if (!found)
        throw InputError(fmt::format(
            "shapes.relaxations = {} left a Voronoi cell that is narrower than the ice is thick after its edges moved "
            "in by {:.4g} m, in each of {} attempts; relax more, raise field.concentration_percent or take larger "
            "floes",
            scenario.shapes.relaxations, cells.offset, attempts));
    if (2 * cells.offset < scenario.arrangement.clearance || cells.offset < scenario.arrangement.clearance)
        throw InputError(fmt::format(
            "Voronoi cells at field.concentration_percent = {:g} are {:.4g} m apart and {:.4g} m from the walls, less "
            "than arrangement.clearance_m = {:g}; lower one of the two",
            100 * field.concentration, 2 * cells.offset, cells.offset, scenario.arrangement.clearance));
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const Outline& cell = cells.outlines[i];
        const Measures measures = measures_of(cell);
        PlanarPose& pose = floes[i].pose;
        pose = {measures.centroid.x, measures.centroid.z, yaw_of(long_axis(measures))};
        const Turn turn = turn_of(pose.yaw);
        give(floes[i].shape, tidied(cell, shortest_edge * std::sqrt(measures.area)), measures.centroid,
             {turn.cos, -turn.sin});
    }
}

}  // namespace

void shape_floes(const Scenario& scenario, const Draw& draw, std::vector<SingleFloe>& floes) {
    const Shapes& shapes = scenario.shapes;
    if (shapes.kind == ShapeKind::voronoi) return grow_cells(scenario, draw, floes);
    if (shapes.kind != ShapeKind::polygon) return;
    RandomStream random(draw.seed, draw.number, StreamId::polygons, 0);
    for (SingleFloe& floe : floes) {
        const Outline outline =
            polygon_about(floe.shape.length, floe.shape.breadth, shapes.corners, shapes.irregularity, random);
        const Measures measures = measures_of(outline);
        give(floe.shape, tidied(outline, shortest_edge * std::sqrt(measures.area)), measures.centroid,
             long_axis(measures));
    }
}

}  // namespace floes
