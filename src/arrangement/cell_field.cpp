#include "arrangement/cell_field.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "arrangement/check.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "scenario/shaped_floes.hpp"

namespace floes {
namespace {

WaterArea strip_of(const Scenario& scenario) {
    const Field& field = scenario.field;
    return {field.begin, -field.half_width, scenario.field_length(), 2 * field.half_width};
}

}  // namespace

CellField::CellField(const Scenario& scenario, std::uint64_t seed, std::uint32_t number)
    : scenario_(scenario),
      seed_(seed),
      number_(number),
      strip_(strip_of(scenario)),
      diagram_(strip_, scenario.shapes.relaxations) {}

void CellField::throw_points() {
    RandomStream random(seed_, number_, StreamId::voronoi, ++thrown_);
    std::vector<Corner> points;
    for (int i = 0; i < scenario_.field.floes; ++i) {
        const double x = random.uniform(strip_.low_x, strip_.low_x + strip_.length);
        points.push_back({x, random.uniform(strip_.low_z, strip_.low_z + strip_.breadth)});
    }
    diagram_.add(points);
    strip_.low_x += strip_.length;
}

/// The floes of the next cells; taken: how many cells they are of, those that are left out included.
std::vector<Outline> CellField::opened(std::size_t count, std::size_t& taken) {
    constexpr int attempts = 20;
    const double thickness = scenario_.floe.thickness;
    Shrunk floes;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        std::vector<Outline> kept;
        double area = 0;
        for (taken = 0; kept.size() < count; ++taken) {
            while (diagram_.ready() < taken + 2) throw_points();  // and the one beyond, which says where the part ends
            const Outline& cell = diagram_.cell(taken);
            area += area_of(cell);
            if (is_floe(eroded(cell, floes.offset), thickness)) kept.push_back(cell);
        }
        floes = shrunk_to(kept, scenario_.field.concentration * area);
        check_gap(scenario_, floes.offset);
        if (std::ranges::all_of(floes.outlines, [&](const Outline& one) { return is_floe(one, thickness); }))
            return floes.outlines;
    }
    throw InputError(fmt::format(
        "shapes.relaxations = {} left a Voronoi cell that is narrower than the ice is thick after its edges "
        "moved in by {:.4g} m; relax more, raise field.concentration_percent or take larger floes",
        scenario_.shapes.relaxations, floes.offset));
}

FieldPart CellField::next() {
    const FloeSet drawn = floes_of(scenario_, {seed_, number_, ++parts_});
    std::size_t taken = 0;
    const std::vector<Outline> outlines = opened(drawn.size(), taken);
    FieldPart part;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        SingleFloe& floe = part.floes.emplace_back(SingleFloe{{}, drawn.shape(i), drawn.material(i)});
        lie_as(floe, outlines[i]);
    }
    part.end = 0.5 * (diagram_.middle_x(taken - 1) + diagram_.middle_x(taken));
    diagram_.take(taken);
    check_beside_last(part.floes);
    last_ = part.floes;
    return part;
}

void CellField::check_beside_last(const std::vector<SingleFloe>& floes) const {
    std::vector<Outline> outlines;
    std::vector<PlanarPose> poses;
    for (const std::vector<SingleFloe>* part : {&last_, &floes})
        for (const SingleFloe& floe : *part) {
            outlines.push_back(floe.shape.outline);
            poses.push_back(floe.pose);
        }
    const Walls walls{strip_.low_x, strip_.low_z, strip_.length, strip_.breadth};
    expect_none(nearness_fault(walls, outlines, poses, scenario_.arrangement.clearance), parts_, number_);
}

}  // namespace floes
