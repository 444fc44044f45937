#include "page/match_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/units.hpp"
#include "match/match_sections.hpp"
#include "page/html_parts.hpp"
#include "page/match_figures.hpp"
#include "page/match_grid.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// A section of the text output, with `figures` below its table. The first line of the text is the title.
std::string as_on_paper(const Section& told, const std::string& figures) {
    std::istringstream lines(told.before);
    std::string title;
    std::getline(lines, title);
    std::string body;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) body += paragraph(line);
    if (!told.table.empty()) body += html_table(told.table);
    const std::size_t reasons = std::min(told.after.find("Not used: "), told.after.size());
    if (reasons > 0) body += note(told.after.substr(0, reasons));
    std::istringstream rest(told.after.substr(reasons));
    std::vector<std::string> unused;
    for (std::string line; std::getline(rest, line);) unused.push_back(line);
    if (!unused.empty()) body += listed(unused);
    return section(title, body + figures);
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

std::string checks(const std::vector<EmulatedTarget>& targets) {
    std::string drawn;
    for (const EmulatedTarget& target : targets) {
        if (!target.emulated()) continue;
        const std::string fault = target.mean().fault();
        drawn += figure(left_out_figure(target), fault.empty() ? "" : target.target().name() + ": " + fault);
    }
    if (drawn.empty()) return section("Checks of the emulators", paragraph("No target has an emulator."));
    return section("Checks of the emulators",
                   "<div class=\"panels\">\n" + drawn + "</div>\n" +
                       note("Each point of the design as simulated, against its prediction from the other points with "
                            "two standard deviations of a new value there; on the line both agree. Of a right emulator "
                            "one in twenty bars misses the line (orange). Green: the measured value."));
}

std::string trail(const std::vector<MatchTrail>& waves) {
    Table table{{"up to wave", "points simulated", "not ruled out, %"}};
    for (const MatchTrail& wave : waves)
        table.push_back({wave.file, fmt::format("{}", wave.points),
                         std::isnan(wave.share) ? "-" : fmt::format("{:.3g}", wave.share / unit::percent)});
    return section("Wave by wave", html_table(table));
}

}  // namespace

std::string match_page(const MatchPageData& told) {
    const std::vector<Section> sections = match_sections(told.data, told.targets, told.found);
    const bool any =
        std::ranges::any_of(told.found.verdicts, [](const TargetVerdict& one) { return one.rules_out > 0; });
    const std::string ruled_out =
        any ? figure(ruled_out_figure(told.targets, told.found), "What each target rules out of the inputs' ranges.")
            : paragraph("No target rules anything out.");
    const std::string inputs =
        figure(inputs_figure(told.data, told.found),
               "Each input's range, and from where to where it is not ruled out. A narrow region "
               "can lie aslant, so that no input alone is narrow: see the pairs below.");
    std::string body = "<h1>What the measured loads leave possible</h1>\n" + as_on_paper(sections.at(0), ruled_out) +
                       as_on_paper(sections.at(1), inputs) + pairs(told) + as_on_paper(sections.at(2), "");
    for (const Section& one : told.predictions) body += as_on_paper(one, "");
    body += checks(told.targets);
    if (told.trail.size() > 1) body += trail(told.trail);
    body += section("How it was computed", fmt::format("<pre>{}</pre>\n", html_escaped(told.command)));
    return html_page("What the measured loads leave possible", "", body);
}

}  // namespace floes
