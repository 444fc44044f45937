#include "findings/overview_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/wording.hpp"
#include "findings/key_words.hpp"
#include "findings/load_columns.hpp"
#include "findings/model_width.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"
#include "findings/printable.hpp"
#include "findings/sensitivity_section.hpp"
#include "findings/warnings.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

std::string heading(const Evidence& evidence) {
    const Summary& summary = evidence.summary;
    int members = 0;
    bool equal = true;
    for (const CaseSummary& row : summary.cases) {
        members += row.members;
        equal = equal && row.members == summary.cases.front().members;
    }
    std::string text = fmt::format("Campaign {}: {}", summary.title, counted(members, "member"));
    if (!equal) return text + fmt::format(" in {}.\n", counted(std::ssize(summary.cases), "case"));
    return text + fmt::format(", {} x {}.\n", counted(std::ssize(summary.cases), "case"),
                              counted(summary.cases.front().members, "arrangement"));
}

std::string count_cell(const CaseSummary& row) {
    return row.done == row.members ? fmt::format("{}", row.done) : fmt::format("{} of {}", row.done, row.members);
}

std::vector<Cell> load_cells(const std::vector<LoadColumn>& loads, const CaseSummary& row) {
    std::vector<Cell> cells{count_cell(row)};
    for (const LoadColumn& column : loads) cells.emplace_back(column.cell(row));
    return cells;
}

/// "+0.1 ± 1.2"; "+0.1 ± –" of fewer than three arrangements; "+0.0 in all" where all differ as much.
std::string difference_cell(const std::vector<PairRow>& pairs, std::size_t of_case, const LoadColumn& load) {
    const auto pair = std::ranges::find(pairs, of_case, &PairRow::second);
    if (pair == pairs.end()) return "–";
    const Limits& limits = pair->found.interval;
    const double half =
        load.factor * std::max(limits.high - pair->found.difference, pair->found.difference - limits.low);
    const bool said = pair->found.arrangements >= fewest_for_interval;
    const std::string value = fmt::format("{:+.{}f}", load.factor * pair->found.difference, load.decimals);
    if (said && half == 0) return value + " in all";
    return fmt::format("{} ± {}", value, said ? fixed(half, load.decimals) : "–");
}

/// One row a case, with the difference to the reference where there is another case.
Table case_table(const Evidence& evidence, const std::vector<LoadColumn>& loads) {
    const Summary& summary = evidence.summary;
    const std::size_t reference = evidence.reference.value_or(0);
    const bool compared = summary.cases.size() > 1 && (!evidence.campaign.design.active() || evidence.reference);
    std::vector<PairRow> pairs;
    Table table{{"case", "n"}};
    for (const LoadColumn& column : loads) table.front().emplace_back(column.heading());
    if (compared) {
        pairs = compare_with(evidence.table, reference, loads.front().quantity, most_overview_rows);
        table.front().emplace_back(fmt::format("mean - {}, {}", summary.label_of(reference), loads.front().unit));
    }
    for (std::size_t k = 0; k < std::min(summary.cases.size(), most_overview_rows); ++k) {
        std::vector<Cell>& line = table.emplace_back(std::vector<Cell>{summary.label_of(k)});
        for (Cell& cell : load_cells(loads, summary.cases[k])) line.push_back(std::move(cell));
        if (compared) line.emplace_back(k == reference ? "" : difference_cell(pairs, k, loads.front()));
    }
    return table;
}

/// A row for each point, its values in columns.
Table point_table(const DesignPoints& points, const Summary& summary, const std::vector<LoadColumn>& loads) {
    const bool bases =
        std::ranges::any_of(points.rows, [&](const PointRow& row) { return row.base != points.rows.front().base; });
    Table table{{}};
    if (bases) table.front().emplace_back("case");
    for (const KeyWords& words : axis_words(points)) table.front().emplace_back(words.heading());
    table.front().emplace_back("n");
    for (const LoadColumn& column : loads) table.front().emplace_back(column.heading());
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        std::vector<Cell>& line = table.emplace_back();
        if (bases) line.emplace_back(points.rows[k].base);
        for (const auto& value : points.rows[k].values) line.emplace_back(value_text(value));
        for (Cell& cell : load_cells(loads, summary.cases[k])) line.push_back(std::move(cell));
    }
    return table;
}

/// Points with the least and the largest mean load, and in the notes where they lie.
void add_extreme_points(const Summary& summary, const std::vector<LoadColumn>& loads, Section& section) {
    const auto load = [](const CaseSummary& row) { return row.of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (std::isfinite(load(summary.cases[k]))) done.push_back(k);
    if (done.empty()) return;
    const auto [least, most] =
        std::ranges::minmax_element(done, {}, [&](std::size_t k) { return load(summary.cases[k]); });
    section.table = {{"point", "n"}};
    for (const LoadColumn& column : loads) section.table.front().emplace_back(column.heading());
    for (const auto& [words, k] : {std::pair{"least mean", *least}, {"largest mean", *most}}) {
        std::vector<Cell>& line = section.table.emplace_back(std::vector<Cell>{words});
        for (Cell& cell : load_cells(loads, summary.cases[k])) line.push_back(std::move(cell));
        section.notes.push_back(fmt::format("The {} is at {}.", words, summary.label_of(k)));
    }
}

/// "thickness from 0.02 to 0.04 m: mean load +5.4 N (2.1 to 8.7)", the strongest first.
std::vector<std::string> axis_sentences(const Sensitivity& found) {
    constexpr std::size_t most = 6;
    std::vector<std::pair<double, std::string>> told;
    for (const SensitivityRow& row : found.rows) {
        if (row.quantity.key.view() != "mean_load" || !row.fit) continue;
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
            const Slope& slope = row.fit->slopes[axis];
            told.emplace_back(std::abs(slope.estimate), change_sentence(found, row, axis));
        }
    }
    std::ranges::stable_sort(told, std::ranges::greater{}, &std::pair<double, std::string>::first);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(told.size(), most); ++k) sentences.push_back(told[k].second);
    return sentences;
}

}  // namespace

Section overview_section(const Evidence& evidence, const Sensitivity& sensitivity) {
    const Summary& summary = evidence.summary;
    const std::vector<LoadColumn> loads = load_columns(summary);
    Section section{.before = heading(evidence) + warning_lines(warnings_of(evidence.table, summary)) + "\n"};
    const bool design = evidence.campaign.design.active();
    const bool many = summary.cases.size() > most_overview_rows;
    if (design) {
        if (many) {
            add_extreme_points(summary, loads, section);
        } else {
            section.table = point_table(find_points(evidence.campaign), summary, loads);
        }
        for (std::string& sentence : axis_sentences(sensitivity)) section.notes.push_back(std::move(sentence));
    } else if (const std::optional<ModelWidth> width = find_model_width(evidence)) {
        section.table = variations_table(summary, *width, most_overview_rows);
        section.notes.push_back(width_sentence(width));
        if (const std::size_t all = width->variations.size(); all > most_overview_rows)
            section.notes.push_back(fmt::format("{} smaller changes: --parts model.", all - most_overview_rows));
        section.after = "\n" + load_columns_text(summary) + "\n";
        return section;
    } else {
        section.table = case_table(evidence, loads);
    }
    section.after = "\n" + load_columns_text(summary) + "\n";
    if (many && !design)
        section.notes.push_back(fmt::format("{} more cases: --full.", summary.cases.size() - most_overview_rows));
    return section;
}

Section next_commands(const Evidence& evidence, const std::string& program) {
    const std::string file = evidence.file.string();
    const std::optional<int> worst = most_loaded_member(evidence);
    std::vector<std::pair<std::string, std::string>> commands;
    commands.emplace_back(fmt::format("{} report {}", program, file), "everything on one page");
    if (worst)
        commands.emplace_back(fmt::format("{} replay {} --worst -o worst.html", program, file),
                              "the largest load, in a browser");
    commands.emplace_back(fmt::format("{} summarize {} --full", program, file), "every figure");
    std::size_t widest = 0;
    for (const auto& [command, what] : commands) widest = std::max(widest, command.size());
    std::string text = fmt::format("In {}. Next:\n", file);
    for (const auto& [command, what] : commands) text += fmt::format("  {:{}}  {}\n", command, widest, what);
    return {.before = text};
}

}  // namespace floes
