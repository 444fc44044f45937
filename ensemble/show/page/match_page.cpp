#include "page/match_page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/units.hpp"
#include "match/match_sections.hpp"
#include "page/html_parts.hpp"
#include "page/match_grid.hpp"
#include "page/section_html.hpp"

namespace floes {
namespace {

std::string titled(const Section& told) {
    return section(told.title, section_html(told, told.title));
}

std::string pairs(const MatchPageData& told) {
    return section(
        "What is left, for each pair of inputs",
        figure(match_grid(told.data, told.found),
               fmt::format("Of {} points of the inputs' ranges. Below the diagonal: the smallest implausibility of the "
                           "points in each cell, whatever the other inputs; the line is where it passes {:g}, beyond "
                           "which a point is ruled out; dots are the points simulated. Above the diagonal: share of "
                           "the points in each cell that is not ruled out. On the diagonal: that share along one "
                           "input. The cross is the best point.",
                           told.found.sampled, ruled_out_above)));
}

std::string trail(const std::vector<MatchTrail>& waves) {
    Table table{{"up to wave", "points simulated", "not ruled out, %"}};
    for (const MatchTrail& wave : waves)
        table.push_back({wave.file, fmt::format("{}", wave.points),
                         std::isnan(wave.share) ? "-" : fmt::format("{:.3g}", wave.share / unit::percent)});
    return titled({.title = "Wave by wave", .table = std::move(table)});
}

}  // namespace

std::string match_page(const MatchPageData& told) {
    const std::vector<Section> sections = match_sections(told.data, told.targets, told.found);
    std::string body = "<h1>What the measured loads leave possible</h1>\n" + titled(sections.at(0)) +
                       titled(sections.at(1)) + pairs(told) + titled(sections.at(2));
    for (const Section& one : told.predictions) body += titled(one);
    body += titled(check_section(told.targets));
    if (told.trail.size() > 1) body += trail(told.trail);
    body += section("How it was computed", fmt::format("<pre>{}</pre>\n", html_escaped(told.command)));
    return html_page("What the measured loads leave possible", "", body);
}

}  // namespace floes
