#include "findings/overview.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "findings/answer.hpp"
#include "findings/cases.hpp"
#include "findings/moored.hpp"
#include "findings/page_one.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"

namespace floes {

namespace {

constexpr std::size_t most_changes = 6;

/// How cases were compared that begin from other floes than the reference.
std::string apart_words(const Summary& summary, const std::vector<ApartRow>& apart, std::size_t compared) {
    if (apart.empty()) return "";
    std::vector<std::size_t> cases;
    for (const ApartRow& one : apart) cases.push_back(one.second);
    return fmt::format(" {} from other floes: differences are of means (Welch), not by arrangement.",
                       cases.size() == compared
                           ? "Cases begin"
                           : label_list(summary, cases) + (cases.size() == 1 ? " begins" : " begin"));
}

std::string heading(const Evidence& evidence) {
    const Summary& summary = evidence.summary;
    const bool equal = std::ranges::all_of(
        summary.cases, [&](const CaseSummary& row) { return row.members == summary.cases.front().members; });
    std::string text = fmt::format("Campaign {}: {}", summary.title, counted(summary.counts().members, "member"));
    if (!equal) return text + fmt::format(" in {}.\n", counted(std::ssize(summary.cases), "case"));
    return text + fmt::format(", {} x {}.\n", counted(std::ssize(summary.cases), "case"),
                              counted(summary.cases.front().members, "arrangement"));
}

/// Behind the columns that a row begins with: how many arrangements are done, and the loads.
void add_columns(const std::vector<LoadColumn>& loads, Results& table) {
    table.columns.push_back({.words = "n"});
    for (const LoadColumn& load : loads) table.columns.push_back(load.column());
}

void add_loads(const std::vector<LoadColumn>& loads, const CaseSummary& row, std::vector<Datum>& line) {
    line.emplace_back(row.done == row.members ? Datum(row.done)
                                              : Datum(fmt::format("{} of {}", row.done, row.members)));
    for (const LoadColumn& load : loads) line.emplace_back(estimate_of(row, load.quantity));
}

/// One row a case, with the difference to the reference where there is another case; `apart`: cases that begin from
/// other floes than it.
Results case_rows(const Evidence& evidence, const std::vector<LoadColumn>& loads, const std::vector<ApartRow>& apart) {
    const Summary& summary = evidence.summary;
    const std::size_t reference = evidence.base();
    const bool compared = evidence.compared();
    std::vector<PairRow> pairs;
    Results table{.columns = {{.words = "case"}}};
    add_columns(loads, table);
    if (compared) {
        pairs = compare_with(evidence, reference, loads.front().quantity, most_overview_rows);
        ResultColumn difference = loads.front().column();
        difference.words = fmt::format("mean - {}", summary.label_of(reference));
        difference.form = ResultColumn::Form::difference;
        table.columns.push_back(std::move(difference));
    }
    for (std::size_t k = 0; k < std::min(summary.cases.size(), most_overview_rows); ++k) {
        std::vector<Datum> line{summary.label_of(k)};
        add_loads(loads, summary.cases[k], line);
        if (compared) {
            const auto pair = std::ranges::find(pairs, k, &PairRow::second);
            const auto means = std::ranges::find(apart, k, &ApartRow::second);
            if (k == reference) {
                line.emplace_back(Absent{});
            } else if (pair != pairs.end()) {
                line.emplace_back(pair->difference());
            } else {
                line.push_back(means != apart.end() ? Datum(means->difference()) : Undefined{});
            }
        }
        table.add(std::move(line));
    }
    return table;
}

/// A row for each point, its values in columns.
Results point_rows(const DesignPoints& points, const Summary& summary, const std::vector<LoadColumn>& loads) {
    const bool bases =
        std::ranges::any_of(points.rows, [&](const PointRow& row) { return row.base != points.rows.front().base; });
    Results table;
    if (bases) table.columns.push_back({.words = "case"});
    for (const KeyWords& words : axis_words(points)) table.columns.push_back({.words = words.heading()});
    add_columns(loads, table);
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        std::vector<Datum> line;
        if (bases) line.emplace_back(points.rows[k].base);
        for (const auto& value : points.rows[k].values) line.emplace_back(value_text(value));
        add_loads(loads, summary.cases[k], line);
        table.add(std::move(line));
    }
    return table;
}

/// Points with the least and the largest mean load, and in the notes where they lie.
void add_extreme_points(const Summary& summary, const std::vector<LoadColumn>& loads, Section& section) {
    const auto points = extreme_points(summary);
    if (points.empty()) return;
    Results table{.columns = {{.words = "point"}}};
    add_columns(loads, table);
    for (const auto& [words, k] : points) {
        std::vector<Datum> line{words};
        add_loads(loads, summary.cases[k], line);
        table.add(std::move(line));
        section.notes.push_back(fmt::format("The {} is at {}.", words, summary.label_of(k)));
    }
    section.results.push_back(std::move(table));
}

}  // namespace

Section overview_section(Evidence& evidence) {
    const Summary& summary = evidence.summary;
    const std::vector<LoadColumn> loads = load_columns(summary);
    Section section{.before = heading(evidence) + warning_lines(warnings_of(evidence.sample, summary)) + "\n"};
    if (!simulated_of(evidence).empty()) {
        PageOne page = find_page_one(evidence);
        section.results = std::move(page.table.results);
        section.notes = std::move(page.table.notes);
        section.after = "\n" + page.table.after + "\n";
        return section;
    }
    const bool design = evidence.campaign.design.active();
    const bool many = summary.cases.size() > most_overview_rows;
    std::string compared;  // how, if not arrangement by arrangement
    if (design) {
        if (many) {
            add_extreme_points(summary, loads, section);
        } else {
            section.results.push_back(point_rows(find_points(evidence.campaign), summary, loads));
        }
        std::ranges::move(change_sentences(sensitivity_of(evidence), evidence.units, most_changes),
                          std::back_inserter(section.notes));
    } else if (const std::optional<ModelWidth> width = find_model_width(evidence)) {
        section.results.push_back(variations_table(summary, *width, most_overview_rows));
        section.notes.push_back(width_sentence(width, evidence.units));
        if (const std::size_t all = width->variations.size(); all > most_overview_rows)
            section.notes.push_back(fmt::format("{} smaller changes: --parts model.", all - most_overview_rows));
        section.after = "\n" + load_columns_text(summary) + "\n";
        return section;
    } else {
        const std::vector<ApartRow> apart =
            compare_apart(evidence, evidence.base(), loads.front().quantity, most_overview_rows);
        section.results.push_back(case_rows(evidence, loads, apart));
        compared = apart_words(summary, apart, std::min(summary.cases.size(), most_overview_rows) - 1);
    }
    section.after = "\n" + load_columns_text(summary) + compared + "\n";
    if (many && !design)
        section.notes.push_back(fmt::format("{} more cases: --full.", summary.cases.size() - most_overview_rows));
    return section;
}

Section next_commands(const Evidence& evidence, const std::string& program) {
    const std::string file = shell_word(evidence.file.string());
    const std::optional<int> worst = most_loaded_member(evidence);
    std::vector<std::pair<std::string, std::string>> commands;
    commands.emplace_back(fmt::format("{} report {}", program, file), "everything on one page");
    const bool moored = std::ranges::any_of(evidence.campaign.cases, [](const Case& one) {
        return one.scenario.moorings.give_way() && one.scenario.analysis.keep_history;
    });
    if (worst)
        commands.emplace_back(fmt::format("{} replay {} --worst -o worst.html", program, file),
                              "the largest load, in a browser");
    if (worst && moored)
        commands.emplace_back(fmt::format("{} replay {} --worst --of mooring_force -o force.png", program, file),
                              "the largest mooring force over 1 s; --of offset, tension");
    if (moored)
        commands.emplace_back(fmt::format("{} design {} --of mooring_force", program, file),
                              "the design force of the moorings; --of offset");
    commands.emplace_back(fmt::format("{} summarize {} --full", program, file), "every figure");
    std::size_t widest = 0;
    for (const auto& [command, what] : commands) widest = std::max(widest, command.size());
    std::string text = fmt::format("In {}. Next:\n", evidence.file.string());
    for (const auto& [command, what] : commands) text += fmt::format("  {:{}}  {}\n", command, widest, what);
    return {.before = text};
}

}  // namespace floes
