#include "findings/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

constexpr double minute = 60;  // s

/// None where no load came above any level.
std::vector<Figure> levels_figures(const Summary& summary, const std::vector<LevelRow>& rows) {
    std::vector<double> loads;
    double least = 1;
    for (const LevelRow& row : rows) {
        loads.push_back(row.level);
        if (row.time_above.estimate > 0) least = std::min(least, row.time_above.estimate);
    }
    if (least == 1) return {};
    const double floor = least / 3;
    Figure figure{.description = "Share of the time with a surge load above a level",
                  .x = axis_around("surge load, N", loads, true),
                  .y = {"share of the time", floor, 1, true},
                  .size = {720, 340},
                  .legend = case_legend(summary),
                  .caption =
                      "Share of the time in the window with a surge load above the levels that the members "
                      "counted at every step: mean over arrangements with its 95 % interval."};
    const std::size_t cases = summary.cases.size();
    for (std::size_t i = 0; i < cases; ++i) {
        // A small offset puts the intervals of one level side by side.
        const double aside =
            0.006 * (figure.x.high - figure.x.low) * (static_cast<double>(i) - 0.5 * static_cast<double>(cases - 1));
        Figure::Points curve;
        for (const LevelRow& row : rows) {
            if (row.case_index != i || !(row.time_above.estimate > 0)) continue;
            const double at = row.level + aside;
            curve.emplace_back(at, row.time_above.estimate);
            figure.line({{at, std::max(floor, row.time_above.low)}, {at, row.time_above.high}}, colour(i) + " thin");
            figure.dot(at, row.time_above.estimate, colour(i), 3);
        }
        figure.line(std::move(curve), colour(i));
    }
    return {std::move(figure)};
}

}  // namespace

std::vector<LevelRow> find_levels(const CampaignTable& table) {
    std::vector<LevelRow> rows;
    for (std::size_t index = 0; index < table.cases.size(); ++index) {
        const CaseRow& about = table.cases[index];
        for (std::size_t level = 0; level < table.levels.size(); ++level) {
            std::vector<double> shares;
            std::vector<double> rates;
            for (const MemberRow& member : table.members) {
                if (member.case_index != static_cast<int>(index) || std::isnan(member.steps_above[level])) continue;
                shares.push_back(member.steps_above[level] / about.window_steps());
                rates.push_back(member.upcrossings[level] / about.analysis.window);
            }
            if (shares.empty()) continue;
            rows.push_back({index, table.levels[level], static_cast<int>(shares.size()),
                            clipped(mean_interval(shares), 0, 1),
                            clipped(mean_interval(rates), 0, std::numeric_limits<double>::infinity())});
        }
    }
    return rows;
}

Section levels_section(const Summary& summary, const std::vector<LevelRow>& rows) {
    using Row = const LevelRow&;
    DataRows records = make_rows<LevelRow>(
        "load_levels", rows,
        {{"case", [&](Row row) { return summary.name_of(row.case_index); }},
         {Names{"level_N", "level_N"}, &LevelRow::level},
         {"runs", &LevelRow::runs},
         {Names{"time_above", "time_above/estimate"}, [](Row row) { return row.time_above.estimate; }},
         {Names{"time_above_low", "time_above/low"}, [](Row row) { return row.time_above.low; }},
         {Names{"time_above_high", "time_above/high"}, [](Row row) { return row.time_above.high; }},
         {Names{"upcrossings_per_s", "upcrossings_per_s/estimate"}, [](Row row) { return row.upcrossings.estimate; }},
         {Names{"upcrossings_low", "upcrossings_per_s/low"}, [](Row row) { return row.upcrossings.low; }},
         {Names{"upcrossings_high", "upcrossings_per_s/high"}, [](Row row) { return row.upcrossings.high; }}});
    if (rows.empty())
        return {.before =
                    "Load levels: no member counted any (analysis.exceedance_levels_N). For the exceedance curve of "
                    "the segment maxima use --format csv or json.\n",
                .records = {json_only(records)}};
    Table table{{"case", "load, N", "runs", "time above, %", "95 %", "rises per minute", "95 %"}};
    for (const LevelRow& row : rows) {
        const auto range = [](const Interval& found, double factor, int decimals) {
            return bracket(factor * found.low, factor * found.high, decimals);
        };
        table.push_back({summary.label_of(row.case_index), fmt::format("{:g}", row.level), fmt::format("{}", row.runs),
                         fixed(row.time_above.estimate / unit::percent, 3), range(row.time_above, 1 / unit::percent, 3),
                         fixed(row.upcrossings.estimate * minute, 2), range(row.upcrossings, minute, 2)});
    }
    return {.title = "Load levels",
            .table = std::move(table),
            .after =
                "\nTime above: share of the window with a surge load above the level; rises: how often the load "
                "rises through it.\nCounted in each member at every time step; mean over arrangements with its "
                "95 % interval (t).\n",
            .records = {records},
            .figures = levels_figures(summary, rows)};
}

}  // namespace floes
