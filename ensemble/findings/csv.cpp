#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "core/units.hpp"
#include "findings/conditions.hpp"
#include "findings/figures.hpp"
#include "findings/formats.hpp"

namespace floes {

namespace {

// One line of the file as (column, value): header and lines come from the same list and cannot drift apart.
using Cells = std::vector<std::pair<std::string, std::string>>;

void add_interval(std::string_view key, const Estimate& interval, Cells& cells) {
    cells.emplace_back(key, csv_number(interval.estimate));
    cells.emplace_back(fmt::format("{}_low", key), csv_number(interval.low));
    cells.emplace_back(fmt::format("{}_high", key), csv_number(interval.high));
    cells.emplace_back(fmt::format("{}_bca_low", key), csv_number(interval.bca.low));
    cells.emplace_back(fmt::format("{}_bca_high", key), csv_number(interval.bca.high));
    cells.emplace_back(fmt::format("{}_prediction_low", key), csv_number(interval.prediction_low));
    cells.emplace_back(fmt::format("{}_prediction_high", key), csv_number(interval.prediction_high));
}

Cells case_cells(const Summary& summary, std::size_t index, Reference reference) {
    const CaseSummary& row = summary.cases[index];
    Cells cells{{"name", csv_text(row.about.name)},
                {"cfm", csv_number(row.about.cfm)},
                {"elastic_modulus_MPa", csv_number(row.about.elastic_modulus / unit::megapascal)},
                {"members", fmt::format("{}", row.members)},
                {"failed_members", fmt::format("{}", row.failed_members)},
                {"missing_members", fmt::format("{}", row.missing_members)},
                {"not_steady", fmt::format("{}", row.not_steady)}};
    for (const Quantity& quantity : quantities) {
        add_interval(quantity.key, row.*quantity.interval, cells);
        if (reference) {
            cells.emplace_back(fmt::format("{}_difference_percent", quantity.key),
                               csv_number(difference_percent(summary, index, *reference, quantity)));
        }
    }
    const auto failures = [&](std::int64_t FailureCounts::*mode) {
        return row.failures ? fmt::format("{}", *row.failures.*mode) : std::string{};
    };
    cells.emplace_back("failures_bending", failures(&FailureCounts::bending));
    cells.emplace_back("failures_shear", failures(&FailureCounts::shear));
    cells.emplace_back("failures_compression", failures(&FailureCounts::compression));
    cells.emplace_back("structure_wall", csv_text(row.about.shape.words()));
    cells.emplace_back("far_end", far_end_key(row.about.far_end));
    cells.emplace_back("contact_erp", csv_number(row.about.contact_erp));
    cells.emplace_back("steady_start_s", csv_number(row.about.analysis.steady_start));
    cells.emplace_back("window_s", csv_number(row.about.analysis.window));
    cells.emplace_back("segments", fmt::format("{}", row.about.analysis.segments));
    return cells;
}

}  // namespace

std::string summary_csv(const Summary& summary, Reference reference) {
    std::string text;
    for (std::size_t index = 0; index < summary.cases.size(); ++index) {
        std::vector<std::string> columns;
        std::vector<std::string> values;
        for (auto& [column, value] : case_cells(summary, index, reference)) {
            columns.push_back(std::move(column));
            values.push_back(std::move(value));
        }
        if (index == 0) text += fmt::format("{}\n", fmt::join(columns, ","));
        text += fmt::format("{}\n", fmt::join(values, ","));
    }
    return text;
}

}  // namespace floes
