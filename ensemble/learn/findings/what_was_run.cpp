#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/wording.hpp"

namespace floes {
namespace {

Figure side_view(const Scenario& scenario) {
    const Shape& shape = scenario.structure.shape;
    const double reach = 1.6 * shape.largest_radius();
    const double low = shape.bottom() - 0.08;
    const double high = shape.top() + 0.08;
    Figure figure{.description = "Section of the structure with the water's surface and the ice",
                  .x = {"m", -reach, reach},
                  .y = {"height above the water, m", low, high},
                  .size = to_scale(2 * reach, high - low, 720),
                  .caption = "Section of the structure (first case) and the ice on the water, to scale."};
    figure.area({{-reach, low}, {reach, low}, {reach, 0}, {-reach, 0}}, "water");
    const double draught = scenario.floe.thickness * scenario.ice.density / scenario.water.density;
    const double freeboard = scenario.floe.thickness - draught;
    for (const double sign : {-1.0, 1.0}) {
        const double near = sign * (shape.waterline_radius() + 0.02);
        figure.area({{near, -draught}, {sign * reach, -draught}, {sign * reach, freeboard}, {near, freeboard}}, "ice");
    }
    Figure::Points outline;
    for (const Vec2& point : shape.section()) outline.emplace_back(point.x(), point.y());
    figure.area(std::move(outline), "structure");
    figure.level(0, "dashed");
    return figure;
}

Figure floe_and_joints(const Scenario& scenario) {
    const FloeShape& floe = scenario.floe;
    const double margin = 0.15 * std::max(floe.length, floe.breadth);
    Figure figure{
        .description = "One floe seen from above: square elements and the joints at the middle of their edges",
        .x = {"along the floe, m", -margin, floe.length + margin},
        .y = {"across, m", -margin, floe.breadth + margin},
        .size = to_scale(floe.length + 2 * margin, floe.breadth + 2 * margin, 420),
        .caption =
            fmt::format("A floe of {:g} m × {:g} m: elements of {:g} m, {:g} m thick; dots are breakable joints.",
                        floe.length, floe.breadth, floe.element, scenario.floe.thickness)};
    const double side = floe.element;
    for (int i = 0; i < floe.elements_long(); ++i)
        for (int k = 0; k < floe.elements_broad(); ++k)
            figure.cell((i + 0.015) * side, (k + 0.015) * side, 0.97 * side, 0.97 * side, 1, "ice");
    for (int i = 0; i < floe.elements_long(); ++i) {
        for (int k = 0; k < floe.elements_broad(); ++k) {
            if (i + 1 < floe.elements_long()) figure.dot((i + 1) * side, (k + 0.5) * side, "c1", 4);
            if (k + 1 < floe.elements_broad()) figure.dot((i + 0.5) * side, (k + 1) * side, "c1", 4);
        }
    }
    return figure;
}

}  // namespace

Section what_was_run(Evidence& evidence) {
    int done = 0;
    int failed = 0;
    int missing = 0;
    for (const CaseSummary& row : evidence.summary.cases) {
        done += row.done;
        failed += row.failed_members;
        missing += row.missing_members;
    }
    const Scenario& first = evidence.campaign.cases.front().scenario;
    return {.before = fmt::format("{}, each over up to {} of {}: {} done, {} set aside as failed, {} not computed.\n",
                                  counted(std::ssize(evidence.summary.cases), "case"),
                                  counted(evidence.campaign.arrangements, "random arrangement"),
                                  counted(first.field.floes, "floe"), counted(done, "simulation"), failed, missing),
            .figures = {side_view(first), floe_and_joints(first)}};
}

}  // namespace floes
