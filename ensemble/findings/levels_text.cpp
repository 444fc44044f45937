// Load levels as a table, JSON and CSV.

#include "findings/levels_text.hpp"

#include "core/units.hpp"
#include "findings/columns.hpp"
#include "findings/figures.hpp"
#include "findings/json.hpp"

namespace floes {

namespace {

constexpr double minute = 60;  // s

Json interval_json(const Interval& interval) {
    return json_estimate(interval.estimate, interval.low, interval.high);
}

}  // namespace

std::string levels_table(const Summary& summary, const std::vector<LevelRow>& rows, int width) {
    if (rows.empty())
        return "Load levels: no member counted any (analysis.exceedance_levels_N). The curve of the segment maxima is "
               "in\n--format csv and json.\n";
    std::vector<std::vector<std::string>> lines{
        {"case", "load, N", "runs", "time above, %", "95 %", "rises a minute", "95 %"}};
    for (const LevelRow& row : rows) {
        lines.push_back({summary.cases.at(row.case_index).about.name, fmt::format("{:g}", row.level),
                         fmt::format("{}", row.runs), fixed(row.time_above.estimate / unit::percent, 3),
                         bracket({row.time_above.low, row.time_above.high}, 3, 1 / unit::percent),
                         fixed(row.upcrossings.estimate * minute, 2),
                         bracket({row.upcrossings.low, row.upcrossings.high}, 2, minute)});
    }
    return "Load levels\n\n" + columns(lines, width) +
           "\nTime above: share of the window with a surge load beyond the level; rises: how often the load rises "
           "through it.\nCounted in each member at every time step; mean over arrangements with its 95 % interval "
           "(t).\n";
}

std::string levels_csv(const Summary& summary, const std::vector<LevelRow>& rows) {
    std::string text =
        "case,level_N,runs,time_above,time_above_low,time_above_high,upcrossings_per_s,upcrossings_low,"
        "upcrossings_high\n";
    for (const LevelRow& row : rows) {
        text += fmt::format("{},{},{}", summary.cases.at(row.case_index).about.name, row.level, row.runs);
        for (const Interval& interval : {row.time_above, row.upcrossings})
            for (const double value : {interval.estimate, interval.low, interval.high}) text += "," + csv_number(value);
        text += "\n";
    }
    return text;
}

Json levels_as_json(const Summary& summary, const std::vector<LevelRow>& rows) {
    Json all = Json::array();
    for (const LevelRow& row : rows) {
        all.push_back({{"case", summary.cases.at(row.case_index).about.name},
                       {"level_N", row.level},
                       {"runs", row.runs},
                       {"time_above", interval_json(row.time_above)},
                       {"upcrossings_per_s", interval_json(row.upcrossings)}});
    }
    return all;
}

}  // namespace floes
