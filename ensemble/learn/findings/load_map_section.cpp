#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/units.hpp"
#include "findings/load_map_figures.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// Share of the depth at which the water stands.
double waterline(const Shape& shape) {
    return -shape.bottom() / (shape.top() - shape.bottom());
}

Table shares(const Evidence& evidence, const std::vector<CaseLoadMap>& maps) {
    Table table{{"share of the mean load, %", "within 30° of ahead", "within 60°", "lower half of the draught",
                 "upper half", "above water", "normal forces, N"}};
    for (const CaseLoadMap& found : maps) {
        const double water = waterline(evidence.campaign.cases[found.case_index].scenario.structure.shape);
        const auto percent = [](double share) { return fixed(share / unit::percent, 0); };
        const double normal = std::accumulate(found.mean.normal.begin(), found.mean.normal.end(), 0.0);
        table.push_back({evidence.summary.label_of(found.case_index), percent(found.share_within(30)),
                         percent(found.share_within(60)), percent(found.share_between(0, water / 2)),
                         percent(found.share_between(water / 2, water)), percent(found.share_between(water, 1)),
                         fixed(normal, 1)});
    }
    return table;
}

}  // namespace

Section load_map_section(Evidence& evidence) {
    const std::vector<std::size_t> drawn = drawn_cases(evidence.summary);
    if (drawn.empty()) return {};
    std::vector<CaseLoadMap> maps = find_load_maps(evidence.file, evidence.table);
    std::erase_if(maps, [&](const CaseLoadMap& found) { return !std::ranges::binary_search(drawn, found.case_index); });
    if (maps.empty()) return {.before = "No figure: the file has no maps of the load.\n"};
    Section section{.table = shares(evidence, maps),
                    .after =
                        "Normal forces: mean sum of their magnitudes, in whatever direction they press on the "
                        "wall." +
                        undrawn_text(evidence.summary),
                    .figures = wall_figures(evidence, maps)};
    section.figures.back().caption =
        "Mean surge load on the wall, unrolled, mean over members: N in each cell of 10° by a twelfth of the depth. "
        "All "
        "cases have the same colours. Blue: drags the structure along.";
    section.figures.push_back(load_rose(evidence, maps));
    section.figures.push_back(load_profile(evidence, maps));
    section.figures.back().caption = "The same by angle, seen from above with the tow to the right, and by height.";
    section.figures.push_back(load_along_tow(evidence, maps));
    section.figures.back().caption =
        "Mean surge load in 24 equal parts of the window, mean over arrangements with its 95 % interval, where there "
        "are four or more.";
    return section;
}

}  // namespace floes
