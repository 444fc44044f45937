#include "page/where_section.hpp"

#include <fmt/format.h>

#include "core/units.hpp"
#include "page/html_parts.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// Share of the depth at which the water stands.
double waterline(const Shape& shape) {
    return -shape.bottom() / (shape.top() - shape.bottom());
}

Table shares(const ReportData& data) {
    Table table{{"share of the mean load, %", "within 30° of ahead", "within 60°", "lower half of the draught",
                 "upper half", "above water", "normal forces, N"}};
    for (const CaseLoadMap& found : data.load_maps) {
        const double water = waterline(data.campaign.cases[found.case_index].scenario.structure.shape);
        const auto percent = [](double share) { return fixed(share / unit::percent, 0); };
        double normal = 0;
        for (const double one : found.mean.normal) normal += one;
        table.push_back({data.summary.cases[found.case_index].about.name, percent(found.share_within(30)),
                         percent(found.share_within(60)), percent(found.share_between(0, water / 2)),
                         percent(found.share_between(water / 2, water)), percent(found.share_between(water, 1)),
                         fixed(normal, 1)});
    }
    return table;
}

std::string left_out(const ReportData& data) {
    std::size_t done = 0;
    for (const CaseSummary& row : data.summary.cases) done += row.done > 0 ? 1 : 0;
    return done > data.drawn_cases.size()
               ? fmt::format(" Only the {} cases with the largest mean loads are shown.", data.drawn_cases.size())
               : "";
}

}  // namespace

std::string where_the_load_acts(const ReportData& data) {
    if (data.drawn_cases.empty()) return "";
    const std::string title = "Where the load acts";
    if (data.load_maps.empty())
        return section(title, paragraph("No figure: members computed before layout 1.7 do not say it."));
    return section(
        title,
        html_table(shares(data)) +
            note("Normal forces: mean sum of their magnitudes, in whatever direction they press on the wall." +
                 left_out(data)) +
            panels(
                load_map_figures(data),
                "Mean surge load on the wall, unrolled, mean over members: N in each cell of 10° by a twelfth of the "
                "depth. All cases have the same colours. Blue: drags the structure along.") +
            panels({load_rose_figure(data), load_profile_figure(data)},
                   "The same by angle, seen from above with the tow to the right, and by height.") +
            figure(load_along_tow_figure(data),
                   "Mean surge load in 24 equal parts of the window, mean over arrangements with its 95 % interval, "
                   "where there "
                   "are four or more."));
}

std::string where_floes_fail(const ReportData& data) {
    const std::vector<std::string> figures = joint_failure_figures(data);
    if (figures.empty()) return "";
    return section("Where floes fail",
                   panels(figures,
                          "How often each joint failed, % of all floes of all members; floes lie at every "
                          "angle to the tow. All cases have the same colours." +
                              left_out(data)) +
                       listed(joint_failure_sentences(data)));
}

}  // namespace floes
