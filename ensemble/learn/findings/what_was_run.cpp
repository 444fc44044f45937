#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "campaign/name_list.hpp"
#include "core/wording.hpp"
#include "findings/common_ground.hpp"
#include "findings/single_floes.hpp"

namespace floes {
namespace {

constexpr std::size_t most_drawn = 12;  // hulls

/// "E30, E60", for the label of one drawing among others; empty of the only one.
std::string names_of(const std::vector<std::size_t>& cases, std::size_t drawings, const Summary& summary) {
    if (drawings < 2) return "";
    std::vector<std::string> names;
    for (const std::size_t k : cases) names.push_back(summary.label_of(k));
    return name_list(names) + ": ";
}

Figure side_view(const Scenario& scenario, const std::string& names, double widest) {
    const Shape& shape = scenario.structure.shape;
    const double reach = 1.6 * shape.largest_radius();
    const double low = shape.bottom() - 0.08;
    const double high = shape.top() + 0.08;
    Figure figure{.description = "Section of the structure with the water's surface and the ice",
                  .x = {names + "m", -reach, reach},
                  .y = {"height, m", low, high},
                  .size = to_scale(2 * reach, high - low, widest)};
    figure.area({{-reach, low}, {reach, low}, {reach, 0}, {-reach, 0}}, "water");
    const double draught = scenario.floe.thickness * scenario.ice.density / scenario.water.density;
    const double freeboard = scenario.floe.thickness - draught;
    for (const double sign : {-1.0, 1.0}) {
        const double near = sign * (shape.waterline_ahead() + 0.02);
        figure.area({{near, -draught}, {sign * reach, -draught}, {sign * reach, freeboard}, {near, freeboard}}, "ice");
    }
    for (const std::vector<Vec2>& piece : shape.side_view()) {
        Figure::Points outline;
        for (const Vec2& point : piece) outline.emplace_back(point.x(), point.y());
        figure.area(std::move(outline), "structure");
    }
    figure.level(0, "dashed");
    return figure;
}

/// Every hull once, with the names of its cases.
std::vector<Figure> hulls(const Campaign& campaign, const Summary& summary) {
    const auto groups = alike(campaign, [](const Scenario& one) -> const Shape& { return one.structure.shape; });
    const std::size_t drawn = std::min(groups.size(), most_drawn);
    std::vector<Figure> figures;
    for (std::size_t k = 0; k < drawn; ++k)
        figures.push_back(side_view(campaign.cases[groups[k].front()].scenario, names_of(groups[k], drawn, summary),
                                    drawn == 1 ? 720 : 400));
    const std::string thickness = [&] {
        std::vector<double> values;
        for (const Case& one : campaign.cases) values.push_back(one.scenario.floe.thickness);
        return range_text(values);
    }();
    figures.back().caption =
        fmt::format("The structure from abeam and the ice on the water, to scale; the ice is {} m thick{}.", thickness,
                    thickness.find("to") == std::string::npos ? "" : ", drawn as in the first case of each");
    if (drawn < groups.size())
        figures.back().caption += fmt::format(" {} of {} hulls are drawn.", drawn, groups.size());
    return figures;
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
    std::vector<Figure> figures = hulls(evidence.campaign, evidence.summary);
    for (Figure& figure : single_floes(evidence)) figures.push_back(std::move(figure));
    return {.before = fmt::format("{}, each over up to {}: {} done, {} set aside as failed, {} not computed.\n",
                                  counted(std::ssize(evidence.summary.cases), "case"),
                                  counted(evidence.campaign.arrangements, "random arrangement"),
                                  counted(done, "simulation"), failed, missing) +
                      field_words(evidence.campaign) + "\n",
            .figures = std::move(figures)};
}

}  // namespace floes
