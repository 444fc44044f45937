#include "page/page_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "findings/figures.hpp"
#include "findings/paper_table3.hpp"
#include "findings/sensitivity_text.hpp"
#include "page/plot.hpp"

namespace floes {
namespace {

std::string estimate_cell(const Estimate& estimate, double factor, int decimals) {
    return fmt::format("<td>{}<br><small>{}</small><br><small>{}</small></td>",
                       fixed(factor * estimate.estimate, decimals),
                       bracket({estimate.low, estimate.high}, decimals, factor),
                       bracket({estimate.prediction_low, estimate.prediction_high}, decimals, factor));
}

std::string in_table(const std::string& rows) {
    return "<div class=\"wide\"><table>" + rows + "</table></div>\n";
}

/// The first line is the heading.
std::string plain_table(const std::vector<std::vector<std::string>>& lines) {
    std::string rows;
    for (const std::vector<std::string>& line : lines) {
        const char* cell = rows.empty() ? "th" : "td";
        rows += "<tr>";
        for (const std::string& text : line) rows += fmt::format("<{0}>{1}</{0}>", cell, html_escaped(text));
        rows += "</tr>\n";
    }
    return in_table(rows);
}

/// The paper's run at the case's modulus, where it has one.
const PaperRow* paper_row(const CaseRow& about) {
    const auto found = std::ranges::find_if(paper_table3, [&](const PaperRow& row) {
        return std::abs(row.elastic_modulus_mpa - about.elastic_modulus / unit::megapascal) < 0.5;
    });
    return found == paper_table3.end() ? nullptr : &*found;
}

}  // namespace

std::string table3(const ReportData& data) {
    std::string rows =
        "<tr><th>case</th><th>n</th><th>mean, N</th><th>SD, N</th><th>mean maximum, N</th><th>SD maximum, N</th>"
        "<th>broken floes, %</th></tr>\n";
    const std::vector<CaseSummary>& cases = data.findings.summary.cases;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        const CaseSummary& row = cases[k];
        rows += fmt::format("<tr><td>{}</td><td>{}</td>", html_escaped(row.about.name), row.done) +
                estimate_cell(row.mean, 1, 1) + estimate_cell(row.sd, 1, 1) + estimate_cell(row.mean_maximum, 1, 0) +
                estimate_cell(row.sd_maximum, 1, 0) + estimate_cell(row.failure_ratio, 1 / unit::percent, 1) +
                "</tr>\n";
        const PaperRow* paper = paper_row(row.about);
        const bool again =
            k + 1 < cases.size() && paper_row(cases[k + 1].about) == paper;  // of a design: once is enough
        if (paper != nullptr && !again)
            rows += fmt::format(
                "<tr><td><small>the paper at {:g} MPa</small></td><td>1</td><td>{:.1f}</td><td>{:.1f}</td><td>{:.0f}"
                "</td><td>{:.0f}</td><td>{:.1f}</td></tr>\n",
                paper->elastic_modulus_mpa, paper->mean, paper->sd, paper->mean_maximum, paper->sd_maximum,
                paper->failure_ratio / unit::percent);
    }
    const Experiment experiment;
    rows += fmt::format(
        "<tr><td><small>experiment at 60 MPa</small></td><td></td><td>{:.1f}</td><td></td><td>{:.1f} "
        "<small>(largest)</small></td><td></td><td>{:.0f}</td></tr>\n",
        experiment.mean, experiment.maximum, experiment.failure_ratio / unit::percent);
    return in_table(rows);
}

std::string pairs_table_html(const ReportData& data) {
    const auto& cases = data.findings.summary.cases;
    std::string rows =
        "<tr><th>quantity</th><th>pair</th><th>n</th><th>difference</th><th>95 % interval</th><th>p (t, Holm)</th>"
        "<th>p (Wilcoxon, Holm)</th><th>variance saved, %</th><th>n to resolve it</th></tr>\n";
    for (const PairRow& row : *data.findings.pairs) {
        const bool ratio = quantities[row.quantity].key == "failure_ratio";
        const double factor = ratio ? 1 / unit::percent : 1;
        rows += fmt::format(
            "<tr><td>{}</td><td>{} − {}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}"
            "</td></tr>\n",
            html_escaped(quantities[row.quantity].label), html_escaped(cases[row.second].about.name),
            html_escaped(cases[row.first].about.name), row.found.arrangements, fixed(factor * row.found.difference, 2),
            bracket(row.found.t_interval, 2, factor), html_escaped(p_text(row.t_p_holm)),
            html_escaped(p_text(row.wilcoxon_p_holm)), fixed(row.found.variance_saved / unit::percent, 0),
            row.to_resolve_observed > 0 ? fmt::format("{}", row.to_resolve_observed) : "–");
    }
    return in_table(rows);
}

std::string points_table_html(const DesignPoints& points) {
    return plain_table(points_lines(points));
}

std::string sensitivity_table_html(const Sensitivity& found) {
    std::string rows;
    for (const std::vector<std::string>& line : sensitivity_lines(found)) {
        const char* cell = rows.empty() ? "th" : "td";
        rows += fmt::format("<tr><{0}>{1}</{0}>", cell, html_escaped(line.front()));
        // Each figure with its interval below: side by side they are wider than paper.
        for (std::size_t i = 1; i + 1 < line.size(); i += 2)
            rows += fmt::format("<{0}>{1}<br><small>{2}</small></{0}>", cell, html_escaped(line[i]),
                                html_escaped(line[i + 1]));
        rows += "</tr>\n";
    }
    return in_table(rows);
}

std::string return_levels_table(const ReportData& data) {
    std::string rows = "<tr><th>case</th><th>fit</th><th>p (A²)</th>";
    for (const double period : return_periods) rows += fmt::format("<th>1 in {:g} segments, N</th>", period);
    rows += "</tr>\n";
    bool any = false;
    for (const CaseExtremes& one : *data.findings.extremes) {
        for (const FittedExtreme* fitted : {&one.gumbel, &one.gev}) {
            if (!fitted->fit.valid()) continue;
            any = true;
            rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td>",
                                html_escaped(data.findings.summary.cases[one.case_index].about.name),
                                fitted == &one.gumbel ? "Gumbel" : "GEV",
                                html_escaped(p_text(fitted->goodness.anderson_darling_p)));
            for (const ReturnLevel& level : fitted->levels)
                rows += fmt::format("<td>{:.0f}<br><small>{}</small></td>", level.level, bracket(level.interval, 0));
            rows += "</tr>\n";
        }
    }
    return any ? in_table(rows) : "";
}

}  // namespace floes
