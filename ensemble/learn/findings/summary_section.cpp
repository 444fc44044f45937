#include "findings/summary_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "core/wording.hpp"
#include "findings/conditions.hpp"
#include "findings/load_columns.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

constexpr std::size_t most_reasons = 10;  // shown; `floes status` has all of them

// -- text: a row for each quantity, a column for each case

template <typename MakeCell>
void add_line(const Summary& summary, std::string label, MakeCell make_cell, Table& table) {
    std::vector<Cell>& line = table.emplace_back(std::vector<Cell>{std::move(label)});
    for (const CaseSummary& row : summary.cases) line.push_back(make_cell(row));
}

void add_counts(const Summary& summary, Table& table) {
    using Row = const CaseSummary&;
    const auto add = [&](const char* label, auto value) {
        add_line(
            summary, label, [&](Row row) { return Cell{fmt::format("{:g}", static_cast<double>(value(row)))}; }, table);
    };
    add_line(
        summary, "case",
        [&](Row row) { return summary.label_of(static_cast<std::size_t>(&row - summary.cases.data())); }, table);
    add("E, MPa", [](Row row) { return row.about.elastic_modulus / unit::megapascal; });
    if (std::ranges::any_of(summary.cases, [](Row row) { return !std::isnan(row.about.cfm); }))
        add("Σ", [](Row row) { return row.about.cfm; });
    add("arrangements", [](Row row) { return row.members; });
    add("  done", [](Row row) { return row.done; });
    add("  failed", [](Row row) { return row.failed_members; });
    add("  not steady", [](Row row) { return row.not_steady; });
}

/// Decimals for the largest estimate.
int decimals_of(const Summary& summary, const Quantity& quantity) {
    if (quantity.percent || quantity.count) return 1;
    double largest = 0;
    for (const CaseSummary& row : summary.cases) {
        const double estimate = std::abs(row.of(quantity).estimate);
        if (estimate > largest) largest = estimate;  // false for NaN
    }
    return decimals_for(largest);
}

void add_estimate(const Summary& summary, const Quantity& quantity, Table& table) {
    const int decimals = decimals_of(summary, quantity);
    const auto range = [&](const CaseSummary& row, double low, double high) {
        return printable_bracket(quantity, row.of(quantity).estimate, {low, high}, row.done, decimals);
    };
    add_line(
        summary, std::string{quantity.label.view()},
        [&](const CaseSummary& row) {
            const Estimate& found = row.of(quantity);
            return Cell{fixed(quantity.factor() * found.estimate, decimals), range(row, found.low, found.high)};
        },
        table);
    // Failures by mode are not in Table 3, so the estimate is enough here; JSON and CSV have the rest.
    if (quantity.shown < Shown::in_table3) return;
    const auto add_range = [&](const char* label, auto limits) {
        add_line(
            summary, label,
            [&](const CaseSummary& row) {
                const Limits found = limits(row.of(quantity));
                return Cell{"", range(row, found.low, found.high)};
            },
            table);
        if (std::ranges::none_of(table.back(),
                                 [](const Cell& cell) { return cell.range.value_or("").starts_with('['); }))
            table.pop_back();  // they say nothing of any case
    };
    const auto at_least = [&](int arrangements) {
        return std::ranges::any_of(summary.cases, [=](const CaseSummary& row) { return row.done >= arrangements; });
    };
    if (at_least(fewest_for_bca)) add_range("  bootstrap", [](const Estimate& found) { return found.bca; });
    add_range("  one further run", [](const Estimate& found) {
        return Limits{found.prediction_low, found.prediction_high};
    });
}

/// Whether it counts what happened in no member, such as joints that fail in a mode without a criterion. The first of
/// several counts, whose label is not indented, is always shown.
bool never_happened(const Summary& summary, const Quantity& quantity) {
    return quantity.count && quantity.label.view().starts_with(' ') &&
           std::ranges::none_of(summary.cases, [&](const CaseSummary& row) { return row.of(quantity).estimate > 0; });
}

void add_difference(const Summary& summary, const Quantity& quantity, std::size_t reference, Table& table) {
    std::vector<Cell>& line =
        table.emplace_back(std::vector<Cell>{fmt::format("  against {}", summary.name_of(reference))});
    for (std::size_t index = 0; index < summary.cases.size(); ++index) {
        const double difference = difference_percent(summary, index, reference, quantity);
        const bool said = index != reference && std::isfinite(difference);
        line.emplace_back(said ? fmt::format("{:+.1f} %", difference) : "–");
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
    std::string text = fmt::format("Campaign {}: {} in {}", summary.title, counted(totals.members, "member"),
                                   counted(std::ssize(summary.cases), "case"));
    if (totals.failed > 0) text += fmt::format(", {} failed", totals.failed);
    text += totals.missing > 0 ? fmt::format(". INCOMPLETE: {} without a result yet.\n", totals.missing) : ".\n";
    for (const std::string& condition : condition_lines(summary)) text += condition + "\n";
    return text;
}

std::string notes(const Summary& summary, const Totals& totals) {
    std::string text = fmt::format(
        "\nOne arrangement is one value. Brackets, all 95 %: confidence interval of the mean over all arrangements by "
        "Student's t, or by a mixture where members stand out; below it by BCa bootstrap, which assumes no "
        "distribution; then the prediction interval of one "
        "further run; –: one that would say nothing, of fewer than {} arrangements or too wide. Failure ratio: broken "
        "floes "
        "/ floes. Joints failed: mean per run.\n",
        fewest_for_interval);
    text +=
        has_rigid_contacts(summary)
            ? "Maxima without an averaging time are maxima of single steps: a rigid contact gives its impulse within "
              "one step, so they depend on the time step. Quote averaged maxima, with their averaging time.\n"
            : "Maxima without an averaging time are maxima of single steps. Quote averaged maxima, with their "
              "averaging time.\n";
    if (const std::string unseen = unseen_text(summary, true); !unseen.empty()) text += unseen.substr(1) + "\n";
    if (totals.missing > 0 && totals.done > 0) {
        text += "Short runs finish first: until the campaign is complete, the figures are biased towards them.\n";
    }
    if (totals.not_steady > 0) {
        text += fmt::format(
            "Not steady: in {} of {} the load still had a trend in the window; the figures above include them.\n",
            totals.not_steady, counted(totals.done, "member"));
    }
    for (std::size_t index = 0; index < std::min(summary.failed.size(), most_reasons); ++index) {
        text += fmt::format("Member {} failed: {}\n", summary.failed[index].member, summary.failed[index].reason);
    }
    if (summary.failed.size() > most_reasons) {
        text += fmt::format("… and {} more failed.\n", summary.failed.size() - most_reasons);
    }
    return text;
}

// -- CSV and JSON: a record for each case

using CaseColumn = DataColumn<CaseSummary>;

void add_estimate(const Quantity& quantity, std::vector<CaseColumn>& columns) {
    const std::string name{quantity.name.view()};
    const auto add = [&](const char* part, const std::string& csv, auto value) {
        columns.push_back({Names{csv, fmt::format("{}/{}", name, part)},
                           [&quantity, value](const CaseSummary& row) { return Datum(value(row.of(quantity))); }});
    };
    add("estimate", name, [](const Estimate& found) { return found.estimate; });
    add("low", name + "_low", [](const Estimate& found) { return found.low; });
    add("high", name + "_high", [](const Estimate& found) { return found.high; });
    add("bca_low", name + "_bca_low", [](const Estimate& found) { return found.bca.low; });
    add("bca_high", name + "_bca_high", [](const Estimate& found) { return found.bca.high; });
    add("prediction_low", name + "_prediction_low", [](const Estimate& found) { return found.prediction_low; });
    add("prediction_high", name + "_prediction_high", [](const Estimate& found) { return found.prediction_high; });
    add("standing_out", "",
        [](const Estimate& found) { return found.standing_out > 0 ? Datum(found.standing_out) : Absent{}; });
}

CaseColumn difference_column(const Summary& summary, std::size_t reference, const Quantity& quantity, Names names) {
    return {std::move(names), [&summary, &quantity, reference](const CaseSummary& row) {
                const auto index = static_cast<std::size_t>(&row - summary.cases.data());
                return Datum(difference_percent(summary, index, reference, quantity));
            }};
}

/// "failures_bending" goes to "failures/bending".
CaseColumn total_column(const Quantity& quantity) {
    const std::string key{quantity.key.view()};
    std::string place = key;
    place.at(place.find('_')) = '/';
    return {Names{key, place}, [key](const CaseSummary& row) {
                const auto total = row.totals.find(key);
                return total == row.totals.end() ? Datum(Undefined{}) : Datum(total->second);
            }};
}

std::vector<CaseColumn> case_columns(const Summary& summary, Reference reference) {
    std::vector<CaseColumn> columns{
        {"name", [](const CaseSummary& row) { return row.about.name; }},
        {"cfm", [](const CaseSummary& row) { return row.about.cfm; }},
        {"elastic_modulus_MPa", [](const CaseSummary& row) { return row.about.elastic_modulus / unit::megapascal; }},
        {"members", &CaseSummary::members},
        {"failed_members", &CaseSummary::failed_members},
        {"missing_members", &CaseSummary::missing_members},
        {"not_steady", &CaseSummary::not_steady}};
    for (const Quantity& quantity : shown_in(summary.quantities, Shown::in_summary)) {
        add_estimate(quantity, columns);
        if (reference)
            columns.push_back(difference_column(summary, *reference, quantity,
                                                {fmt::format("{}_difference_percent", quantity.name), ""}));
    }
    for (const Quantity& quantity : summary.quantities)
        if (quantity.count) columns.push_back(total_column(quantity));
    for (const ConditionColumn& condition : condition_columns(summary))
        columns.push_back(
            {condition.names, [condition](const CaseSummary& row) { return condition.value(row.about); }});
    if (reference) {
        for (const Quantity& quantity : shown_in(summary.quantities, Shown::in_summary))
            columns.push_back(difference_column(summary, *reference, quantity,
                                                {"", fmt::format("difference_percent/{}", quantity.name)}));
    }
    return columns;
}

std::vector<DataRows> records_of(const Summary& summary, Reference reference) {
    std::vector<DataColumn<Summary>> about{
        {Names{"", "campaign"}, &Summary::title},
        {Names{"", "complete"}, &Summary::complete},
    };
    if (reference)
        about.push_back({Names{"", "reference"}, [&](const Summary&) { return summary.name_of(*reference); }});
    return {make_object("", summary, about),
            make_rows<CaseSummary>("cases", summary.cases, case_columns(summary, reference))};
}

}  // namespace

Section summary_section(const Summary& summary, Reference reference) {
    const Totals totals{summary};
    Table table;
    add_counts(summary, table);
    for (const Quantity& quantity : shown_in(summary.quantities, Shown::in_summary)) {
        if (never_happened(summary, quantity)) continue;
        add_estimate(summary, quantity, table);
        if (reference && quantity.shown >= Shown::in_pairs) add_difference(summary, quantity, *reference, table);
    }
    return {.before = heading(summary, totals) + "\n",
            .table = std::move(table),
            .after = notes(summary, totals),
            .records = records_of(summary, reference),
            .layout = Section::Layout::panels};
}

}  // namespace floes
