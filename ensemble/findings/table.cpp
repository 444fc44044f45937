#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/figures.hpp"
#include "findings/formats.hpp"
#include "findings/panels.hpp"

namespace floes {

namespace {

constexpr std::size_t most_reasons = 10;  // shown; `floes status` has all of them

// How a quantity is printed: the factor to its unit on paper, and decimals that suit its largest estimate.
struct Style {
    double factor = 1;
    int decimals = 2;

    std::string text(double value) const { return fixed(value * factor, decimals); }
    std::string range(double low, double high) const { return bracket({low, high}, decimals, factor); }
};

Style style_of(const Summary& summary, const Quantity& quantity) {
    if (quantity.interval == &CaseSummary::failure_ratio) return {1 / unit::percent, 1};
    double largest = 0;
    for (const CaseSummary& row : summary.cases) {
        const double estimate = std::abs((row.*quantity.interval).estimate);
        if (estimate > largest) largest = estimate;  // NaN is not
    }
    return {1, decimals_for(largest)};
}

template <typename MakeCell>
void add_line(const Summary& summary, std::string label, MakeCell make_cell, std::vector<Line>& lines) {
    Line line{std::move(label), {}};
    for (const CaseSummary& row : summary.cases) line.cells.push_back(make_cell(row));
    lines.push_back(std::move(line));
}

void add_counts(const Summary& summary, std::vector<Line>& lines) {
    using Row = const CaseSummary&;
    const auto of = [](auto value) { return Cell{fmt::format("{:g}", static_cast<double>(value)), ""}; };
    add_line(
        summary, "case",
        [](Row row) {
            return Cell{row.about.name, ""};
        },
        lines);
    add_line(
        summary, "E, MPa", [&](Row row) { return of(row.about.elastic_modulus / unit::megapascal); }, lines);
    add_line(
        summary, "Σ", [&](Row row) { return of(row.about.cfm); }, lines);
    add_line(
        summary, "arrangements", [&](Row row) { return of(row.members); }, lines);
    add_line(
        summary, "  done", [&](Row row) { return of(row.done); }, lines);
    add_line(
        summary, "  failed", [&](Row row) { return of(row.failed_members); }, lines);
    add_line(
        summary, "  not steady", [&](Row row) { return of(row.not_steady); }, lines);
}

void add_quantity(const Summary& summary, const Quantity& quantity, Reference reference, std::vector<Line>& lines) {
    const Style style = style_of(summary, quantity);
    const auto estimate = [&](const CaseSummary& row) {
        const Interval& found = row.*quantity.interval;
        return Cell{style.text(found.estimate), style.range(found.low, found.high)};
    };
    const auto further_run = [&](const CaseSummary& row) {
        const Interval& found = row.*quantity.interval;
        return Cell{"", style.range(found.prediction_low, found.prediction_high)};
    };
    const auto bootstrap = [&](const CaseSummary& row) {
        const Limits& found = (row.*quantity.interval).bca;
        return Cell{"", style.range(found.low, found.high)};
    };
    add_line(summary, std::string{quantity.label}, estimate, lines);
    add_line(summary, "  bootstrap", bootstrap, lines);
    add_line(summary, "  one further run", further_run, lines);
    if (!reference) return;
    Line against{fmt::format("  against {}", summary.cases.at(*reference).about.name), {}};
    for (std::size_t index = 0; index < summary.cases.size(); ++index) {
        const double difference = difference_percent(summary, index, *reference, quantity);
        const bool said = index != *reference && std::isfinite(difference);
        against.cells.push_back({said ? fmt::format("{:+.1f} %", difference) : "–", ""});
    }
    lines.push_back(std::move(against));
}

// Failures by mode are no row of Table 3: the estimate will do, the rest is in JSON and CSV.
void add_failures(const Summary& summary, std::vector<Line>& lines) {
    for (const Quantity& quantity : std::span(quantities).subspan(table3_quantities.size())) {
        const Style style{1, 1};
        const auto estimate = [&](const CaseSummary& row) {
            const Estimate& found = row.*quantity.interval;
            return Cell{style.text(found.estimate), style.range(found.low, found.high)};
        };
        add_line(summary, std::string{quantity.label}, estimate, lines);
    }
}

struct Totals {
    int members = 0, done = 0, failed = 0, missing = 0, not_steady = 0;

    explicit Totals(const Summary& summary) {
        for (const CaseSummary& row : summary.cases) {
            members += row.members;
            done += row.done;
            failed += row.failed_members;
            missing += row.missing_members;
            not_steady += row.not_steady;
        }
    }
};

std::string heading(const Summary& summary, const Totals& totals) {
    std::string text = fmt::format("Campaign {}: {} members in {} case{}", summary.title, totals.members,
                                   summary.cases.size(), summary.cases.size() == 1 ? "" : "s");
    if (totals.failed > 0) text += fmt::format(", {} failed", totals.failed);
    text += totals.missing > 0 ? fmt::format(". INCOMPLETE: {} without a result yet.\n", totals.missing) : ".\n";
    for (const std::string& condition : condition_lines(summary)) text += condition + "\n";
    return text;
}

std::string notes(const Summary& summary, const Totals& totals) {
    std::string text =
        "\nOne arrangement is one value. Brackets: where the mean over all arrangements lies, 95 %, by Student's t; "
        "below "
        "it by\nBCa bootstrap, which assumes no shape; then where one further run falls, 95 %. Failure ratio: broken "
        "floes of all floes.\nJoints failed: mean of a run.\n";
    if (totals.missing > 0 && totals.done > 0) {
        text += "Members that end sooner come first: until the campaign is complete the figures lean towards them.\n";
    }
    if (totals.not_steady > 0) {
        text += fmt::format(
            "Not steady: in {} of {} members the load still had a trend in the window; they are in the figures "
            "above.\n",
            totals.not_steady, totals.done);
    }
    for (std::size_t index = 0; index < std::min(summary.failed.size(), most_reasons); ++index) {
        text += fmt::format("Member {} failed: {}\n", summary.failed[index].member, summary.failed[index].reason);
    }
    if (summary.failed.size() > most_reasons) {
        text += fmt::format("… and {} more failed.\n", summary.failed.size() - most_reasons);
    }
    return text;
}

}  // namespace

std::string summary_table(const Summary& summary, int width, Reference reference) {
    const Totals totals{summary};
    std::vector<Line> lines;
    add_counts(summary, lines);
    for (const Quantity& quantity : table3_quantities) add_quantity(summary, quantity, reference, lines);
    add_failures(summary, lines);
    return heading(summary, totals) + "\n" + panels(lines, width) + notes(summary, totals);
}

}  // namespace floes
