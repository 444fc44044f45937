#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/averaged_table.hpp"
#include "findings/conditions.hpp"
#include "findings/design_load_section.hpp"
#include "findings/pairs_section.hpp"
#include "findings/paper_table3.hpp"
#include "findings/sensitivity_section.hpp"
#include "page/answer.hpp"
#include "page/html_parts.hpp"
#include "page/moments_section.hpp"
#include "page/report_figures.hpp"
#include "page/where_section.hpp"

namespace floes {
namespace {

std::string what_was_run(const ReportData& data) {
    const Summary& summary = data.summary;
    int done = 0;
    int failed = 0;
    int missing = 0;
    for (const CaseSummary& row : summary.cases) {
        done += row.done;
        failed += row.failed_members;
        missing += row.missing_members;
    }
    std::string body = paragraph(fmt::format(
        "{}, each over up to {} of {}: {} done, {} set aside as failed, {} not computed.",
        counted(std::ssize(summary.cases), "case"), counted(data.campaign.arrangements, "random arrangement"),
        counted(data.campaign.cases.front().scenario.field.floes, "floe"), counted(done, "simulation"), failed,
        missing));
    const Scenario& scenario = data.campaign.cases.front().scenario;
    body +=
        figure(section_figure(scenario), "Section of the structure (first case) and the ice on the water, to scale.");
    body +=
        figure(joint_figure(scenario),
               fmt::format("A floe of {:g} m × {:g} m: elements of {:g} m, {:g} m thick; dots are breakable joints.",
                           scenario.floe.length, scenario.floe.breadth, scenario.floe.element, scenario.floe.thickness));
    return body;
}

bool has_paper_rows(const Campaign& campaign) {
    return std::ranges::any_of(campaign.cases, [](const Case& one) { return paper_row(one) != nullptr; });
}

std::string loads(const ReportData& data) {
    std::string body;
    if (const Table averaged = averaged_table(data.summary); averaged.size() > 1) {
        body += html_table(averaged);
        body += note(
            "Surge load averaged over the time given: mean over arrangements of the segment maxima, with its 95 % "
            "confidence and prediction intervals. The maxima below, without an averaging time, are of single steps" +
            std::string{has_rigid_contacts(data.summary)
                            ? ": a rigid contact gives its impulse within one step, so they depend on the time step."
                            : "."});
    }
    body += html_table(table3(data.campaign, data.summary));
    body += note(
        "Mean over arrangements with its 95 % confidence interval; below it the 95 % prediction interval of one "
        "further arrangement." +
        std::string{has_paper_rows(data.campaign)
                        ? " The paper's figures are one run each, and the experiment's maximum is one value."
                        : ""});
    body +=
        figure(strips_figure(data, quantity("mean_load")),
               "Each dot is one arrangement. Below the dots: mean, its 95 % confidence interval (thick), and the 95 % "
               "prediction interval of one further run (dashed).");
    body += figure(strips_figure(data, quantity("mean_maximum")), "The same for the mean of the segments' maxima.");
    body += figure(strips_figure(data, quantity("failure_ratio")), "The same for the share of broken floes.");
    return body;
}

std::string over_time(const ReportData& data) {
    if (data.histories.empty())
        return section("Load over time",
                       paragraph("No figure: the file has no load histories of an arrangement that is done in every "
                                 "case."));
    std::string caption =
        "One arrangement, every case, shifted upwards (the paper's Fig. 6). Dashed: start of the analysis window.";
    if (std::ranges::any_of(data.table.cases, [](const CaseRow& one) { return one.analysis.history_stride > 1; }))
        caption += " The file holds means over several steps, whose peaks are lower than the measured ones.";
    return section("Load over time", figure(histories_figure(data), caption));
}

std::string comparisons(const ReportData& data) {
    const Summary& summary = data.summary;
    if (summary.cases.size() < 2) return "";
    const std::string title = "Do the cases differ?";
    if (!data.pairs) return section(title, paragraph(unasked_text(summary)));
    const std::string left_out = left_out_text(summary, *data.pairs);
    if (data.pairs->empty()) return section(title, paragraph(left_out));
    std::string body = html_table(pairs_page_table(summary, *data.pairs));
    if (!left_out.empty()) body += paragraph(left_out);
    body += note(
        "Cases share their arrangements, so they are compared arrangement by arrangement. p: paired t test and "
        "Wilcoxon signed-rank test, Holm-adjusted over all pairs of a quantity.");
    body += figure(pairs_figure(data, quantity("mean_load")), "Mean load: differences within an arrangement.");
    body +=
        figure(pairs_figure(data, quantity("mean_maximum")), "Mean maximum load: differences within an arrangement.");
    return section(title, body);
}

std::string sensitivity(const ReportData& data) {
    if (!data.sensitivity) return "";
    const Sensitivity& found = *data.sensitivity;
    std::string body = found.rows.empty() ? "" : html_table(sensitivity_table(found));
    for (const std::string& sentence : sensitivity_notes(found)) body += note(sentence);
    body +=
        "<details><summary>Points of the design</summary>" + html_table(points_table(*data.points)) + "</details>\n";
    return section("What decides the load?", body);
}

std::string return_levels(const ReportData& data) {
    const Table table = extremes_page_table(data.summary, *data.extremes);
    return table.size() > 1 ? html_table(table) : "";
}

std::string extremes(const ReportData& data) {
    std::string body;
    if (data.extremes)
        body +=
            figure(
                exceedance_figure(data),
                "Dots: maxima of all segments, of single steps, which are no design loads. Lines: Gumbel, dashed: GEV, "
                "fitted by maximum likelihood.") +
            return_levels(data);
    body += figure(levels_figure(data),
                   "Share of the time in the window with a surge load above the levels that the members counted at "
                   "every step: mean over arrangements with its 95 % interval.");
    return body.empty() ? "" : section("Extremes", body);
}

/// The design loads by every method, and what they rest on.
std::string design_loads(const ReportData& data) {
    if (data.designs.empty()) return "";
    std::string body;
    for (const Section& part : design_load_sections(data.summary, data.designs, data.asked))
        body += html_table(part.table) + note(part.after);
    return section(fmt::format("Design load: averaged over {:g} s, in {:g} h", data.asked.averaging,
                               data.asked.exposure / unit::hour),
                   body);
}

std::string failures(const ReportData& data) {
    if (data.breaks.empty()) return section("Broken floes", paragraph("No joint failed in any member."));
    return section("Broken floes",
                   figure(failures_figure(data),
                          "Failed joints so far, mean over arrangements: solid line bending, dashed shear, "
                          "dotted compression."));
}

std::string largest(const ReportData& data) {
    if (data.largest_member < 0 || !data.moments.empty()) return "";  // its picture stands above
    const MemberRow& member = data.table.members[static_cast<std::size_t>(data.largest_member)];
    return section(
        "The arrangement with the largest load",
        figure(
            arrangement_figure(data),
            fmt::format("Member {}, case {}: largest load {:.1f} N, mean {:.1f} N, {:.1f} % of the floes broke "
                        "(marked).",
                        data.largest_member, data.summary.cases[static_cast<std::size_t>(member.case_index)].about.name,
                        member.load.maximum, member.load.mean, member.failure_ratio / unit::percent)) +
            fmt::format("<p>To watch it: <code>{}</code></p>\n",
                        html_escaped(replay_command(data, data.largest_member))));
}

std::string theory(const ReportData& data) {
    std::string body;
    if (data.hybrid)
        body += figure(hybrid_figure(data),
                       "The hybrid model of Eqs. (6)-(7) (the paper's Fig. 8). KPR's coefficient k1 is chosen so that "
                       "both limits cross at 10 MPa as in the paper: its line is a calibration, not a prediction.");
    body += figure(modulus_figure(data),
                   "Elastic modulus of this ice in a plate test over Σ (the paper's Fig. 2), on a sheet of 13 x 13 "
                   "elements.");
    return body.empty() ? "" : section("Elastic modulus and closed formulas", body);
}

/// Table and notes as in text.
std::string further_parts(const ReportData& data) {
    std::string sections;
    for (const auto& [title, told] : data.further)
        sections +=
            section(title, (told.table.empty() ? paragraph(told.before + told.missing) : html_table(told.table)) +
                               note(told.after));
    return sections;
}

std::string provenance(const ReportData& data) {
    std::string rows;
    for (const auto& [name, value] : data.origin.facts)
        rows +=
            fmt::format("<tr><td>{}</td><td class=\"words\">{}</td></tr>\n", html_escaped(name), html_escaped(value));
    return section(
        "How it was computed",
        fmt::format("<p>To repeat this campaign, save the configuration below as <code>{}.toml</code> and run</p>\n"
                    "<pre>{}</pre>\n<div class=\"wide\"><table>{}</table></div>\n"
                    "<details><summary>Configuration</summary><pre>{}</pre></details>\n",
                    html_escaped(data.summary.title), html_escaped(data.command), rows,
                    html_escaped(data.origin.configuration)));
}

}  // namespace

std::string report_page(const ReportData& data) {
    const std::string title = "Loads of managed ice floes: " + data.summary.title;
    return html_page(
        data.summary.title + ": loads of managed ice floes", "",
        fmt::format("<h1>{}</h1>\n", html_escaped(title)) + answer_section("The answer", data) + moments_section(data) +
            section("Loads", loads(data)) + "<h1 class=\"appendix\">Appendix</h1>\n" +
            section("What was run", what_was_run(data)) + sensitivity(data) + comparisons(data) + over_time(data) +
            where_the_load_acts(data) + design_loads(data) + extremes(data) + further_parts(data) +
            section("Uncertainty of the mean",
                    figure(convergence_figure(data), "Mean load of the first n arrangements with its 95 % interval.")) +
            failures(data) + where_floes_fail(data) + largest(data) + theory(data) + provenance(data));
}

}  // namespace floes
