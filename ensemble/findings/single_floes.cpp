#include "findings/single_floes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "findings/conditions.hpp"
#include "scenario/floes.hpp"

namespace floes {
namespace {

constexpr std::size_t most_figures = 12;  // figures

/// What is drawn of a case: floes by area.
std::vector<FloeShape> drawn_floes(const Campaign& campaign, std::size_t of_case) {
    const Scenario& scenario = campaign.cases[of_case].scenario;
    std::vector<FloeShape> shapes =
        floes_of(scenario, {arrangement_seed(campaign, static_cast<int>(of_case)), 0}).shapes;
    if (!sizes_may_differ(scenario) && !scenario.shapes.any()) return {shapes.front()};
    for (FloeShape& shape : shapes) shape.thickness = scenario.floe.thickness;  // not seen from above
    std::ranges::stable_sort(shapes, {}, &FloeShape::area);
    std::vector<FloeShape> drawn;
    for (const FloeShape& shape : {shapes.front(), shapes[shapes.size() / 2], shapes.back()})
        if (std::ranges::find(drawn, shape) == drawn.end()) drawn.push_back(shape);
    return drawn;
}

void add_floe(Figure& figure, const FloeShape& floe, double x) {
    const CutFloe cut = floe.cut();
    const double left = std::ranges::min(floe.corners(), {}, &Corner::x).x;
    for (const CutElement& element : cut.elements) {
        Figure::Points points;
        for (const Corner& corner : from_axes(element.corners, element.centre, element.axis)) {
            const Corner inside = element.centre + 0.97 * (corner - element.centre);
            points.emplace_back(x + inside.x - left, inside.z);
        }
        figure.area(std::move(points), "ice");
    }
    for (const CutJoint& joint : cut.joints) figure.dot(x + joint.pivot.x - left, joint.pivot.z, "c1", 4);
}

Figure side_by_side(const std::vector<FloeShape>& floes, const std::string& names) {
    double length = 0;
    double breadth = 0;
    for (const FloeShape& floe : floes) {
        length += floe.length;
        breadth = std::max({breadth, floe.breadth, 0.2 * floe.length});
    }
    const double margin = 0.15 * std::max(length / static_cast<double>(floes.size()), breadth);
    length += margin * static_cast<double>(floes.size() - 1);
    const double half = 0.5 * breadth + margin + 0.1 * breadth;
    Figure figure{.description = "Floes seen from above: their elements, and the joints at the middle of common edges",
                  .x = {names + "along the floe, m", -margin, length + margin},
                  .y = {"across, m", -half, half},
                  .size = to_scale(length + 2 * margin, 2 * half, floes.size() > 1 ? 720 : 360)};
    double x = 0;
    for (const FloeShape& floe : floes) {
        add_floe(figure, floe, x);
        x += floe.length + margin;
    }
    return figure;
}

/// The cases with these floes, by name; empty where all have them.
std::string names_of(const std::vector<std::size_t>& cases, bool all, const Summary& summary) {
    if (all) return "";
    std::vector<std::string> names;
    for (const std::size_t k : cases) names.push_back(summary.label_of(k));
    return name_list(names) + ": ";
}

}  // namespace

std::vector<Figure> single_floes(Evidence& evidence) {
    const Campaign& campaign = evidence.campaign;
    std::vector<std::pair<std::vector<FloeShape>, std::vector<std::size_t>>> groups;
    for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
        std::vector<FloeShape> drawn = drawn_floes(campaign, k);
        for (FloeShape& floe : drawn) floe.thickness = 0;  // cases that differ in it alone have one drawing
        const auto known = std::ranges::find(groups, drawn, [](const auto& group) { return group.first; });
        if (known != groups.end())
            known->second.push_back(k);
        else
            groups.push_back({std::move(drawn), {k}});
    }
    const std::size_t count = std::min(groups.size(), most_figures);
    std::vector<Figure> figures;
    for (std::size_t k = 0; k < count; ++k)
        figures.push_back(
            side_by_side(groups[k].first, names_of(groups[k].second, groups.size() == 1, evidence.summary)));
    const std::vector<FloeShape>& first = groups.front().first;
    const bool one_floe = groups.size() == 1 && first.size() == 1;
    figures.back().caption =
        one_floe ? fmt::format("A floe of {:g} m × {:g} m in {} of {:g} m; dots are breakable joints.",
                               first.front().length, first.front().breadth,
                               first.front().cut().squares ? "elements" : "cells", first.front().element)
                 : "Floes and their elements; where floes differ, the smallest, the middle one by area and the largest "
                   "of the first arrangement. Dots are breakable joints.";
    return figures;
}

}  // namespace floes
