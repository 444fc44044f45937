#include "findings/levels.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/units.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

constexpr double minute = 60;  // s

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
                    "the segment\nmaxima use --format csv or json.\n",
                .records = {json_only(records)}};
    Table table{{"case", "load, N", "runs", "time above, %", "95 %", "rises per minute", "95 %"}};
    for (const LevelRow& row : rows) {
        const auto range = [](const Interval& found, double factor, int decimals) {
            return bracket(factor * found.low, factor * found.high, decimals);
        };
        table.push_back({summary.name_of(row.case_index), fmt::format("{:g}", row.level), fmt::format("{}", row.runs),
                         fixed(row.time_above.estimate / unit::percent, 3), range(row.time_above, 1 / unit::percent, 3),
                         fixed(row.upcrossings.estimate * minute, 2), range(row.upcrossings, minute, 2)});
    }
    return {.before = "Load levels\n\n",
            .table = std::move(table),
            .after =
                "\nTime above: share of the window with a surge load above the level; rises: how often the load "
                "rises through it.\nCounted in each member at every time step; mean over arrangements with its "
                "95 % interval (t).\n",
            .records = {records}};
}

}  // namespace floes
