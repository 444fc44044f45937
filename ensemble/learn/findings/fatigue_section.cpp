#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign_file/read_history.hpp"
#include "core/units.hpp"
#include "findings/fatigue.hpp"
#include "findings/moored_cases.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

constexpr std::size_t most_tabled = 4;  // whose bins are shown; of more they are in CSV

std::vector<LoadWindow> windows_of(const Evidence& evidence) {
    std::vector<LoadWindow> windows;
    for_each_history(evidence.file, [&](const SurgeHistory& history) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(history.member)];
        const Analysis& analysis = evidence.table.cases[static_cast<std::size_t>(member.case_index)].analysis;
        const auto first = static_cast<std::size_t>(std::lround(analysis.steady_start / history.step));
        const auto count = static_cast<std::size_t>(std::lround(analysis.window / history.step));
        if (first + count > history.surge.size()) return;
        const auto loads = history.surge.subspan(first, count);
        const double averaging = analysis.averaging.empty() ? 0 : std::ranges::min(analysis.averaging);
        windows.push_back({static_cast<std::size_t>(member.case_index), history.step, averaging,
                           std::vector<double>(loads.begin(), loads.end())});
    });
    return windows;
}

/// Of the mooring force of a moored hull, at full scale.
std::vector<LoadWindow> moored_windows(const Evidence& evidence, const MooredRequest& request) {
    std::vector<bool> answered(evidence.table.cases.size(), false);
    for (const MooredCase& one : find_moored(evidence, request)) answered[one.case_index] = one.refused.empty();
    std::vector<LoadWindow> windows;
    for_each_history(evidence.file, [&](const SurgeHistory& history) {
        const auto index =
            static_cast<std::size_t>(evidence.table.members[static_cast<std::size_t>(history.member)].case_index);
        if (!answered[index]) return;
        LoadWindow& window = windows.emplace_back(LoadWindow{index, request.time_factor() * history.step, 0, {}});
        window.loads = mooring_force(history.surge, history.step, evidence.table.cases[index].analysis, request);
        for (double& force : window.loads) force *= request.force_factor();
    });
    return windows;
}

Table case_table(const Summary& summary, const Fatigue& found) {
    Table table{{"case", "runs", "averaged over, s", "cycles per hour"}};
    for (const double slope : fatigue_slopes)
        table.front().push_back({fmt::format("equivalent range, m = {:g}, N", slope), "95 %"});
    for (const CaseFatigue& one : found.cases) {
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(summary.label_of(one.case_index));
        line.emplace_back(fmt::format("{}", one.runs));
        line.emplace_back(fmt::format("{:.3g}", one.averaging));
        line.emplace_back(fixed(one.cycles, 0));
        for (const Interval& range : one.equivalent) {
            const int decimals = decimals_for(range.estimate);
            const bool said = says_something(range.estimate, {range.low, range.high}, one.runs);
            line.push_back({fixed(range.estimate, decimals), said ? bracket(range.low, range.high, decimals) : "–"});
        }
    }
    return table;
}

/// A line for each edge.
Table edge_table(const Summary& summary, const Fatigue& found) {
    Table table{{"N"}};
    for (const CaseFatigue& one : found.cases) {
        table.front().emplace_back(summary.label_of(one.case_index) + ": cycles per hour");
        table.front().emplace_back("time above, %");
    }
    for (std::size_t k = 0; k < found.edges.size(); ++k) {
        std::vector<Cell>& line = table.emplace_back();
        line.emplace_back(fmt::format("{:g}", found.edges[k]));
        for (const CaseFatigue& one : found.cases) {
            line.emplace_back(fmt::format("{:.4g}", one.cycles_above[k]));
            line.emplace_back(fixed(one.time_above[k] / unit::percent, 3));
        }
    }
    return table;
}

struct Line {
    const CaseFatigue* of;
    std::size_t edge;
};

std::vector<DataRows> records_of(const Summary& summary, const Fatigue& found) {
    std::vector<Line> lines;
    for (const CaseFatigue& one : found.cases)
        for (std::size_t k = 0; k < found.edges.size(); ++k) lines.push_back({&one, k});
    std::vector<DataColumn<CaseFatigue>> columns{
        {"case", [&](const CaseFatigue& one) { return summary.name_of(one.case_index); }},
        {"runs", [](const CaseFatigue& one) { return one.runs; }},
        {"averaging_s", [](const CaseFatigue& one) { return one.averaging; }},
        {"cycles_per_h", [](const CaseFatigue& one) { return one.cycles; }}};
    for (std::size_t k = 0; k < std::size(fatigue_slopes); ++k) {
        const std::string name = fmt::format("equivalent_range_m{:g}", fatigue_slopes[k]);
        columns.push_back({name + "_N", [k](const CaseFatigue& one) { return one.equivalent[k].estimate; }});
        columns.push_back({name + "_low", [k](const CaseFatigue& one) { return one.equivalent[k].low; }});
        columns.push_back({name + "_high", [k](const CaseFatigue& one) { return one.equivalent[k].high; }});
    }
    return {make_rows<CaseFatigue>("fatigue/cases", found.cases, columns),
            make_rows<Line>("fatigue/levels", lines,
                            {{"case", [&](const Line& line) { return summary.name_of(line.of->case_index); }},
                             {"level_N", [&](const Line& line) { return found.edges[line.edge]; }},
                             {"cycles_above_per_h", [](const Line& line) { return line.of->cycles_above[line.edge]; }},
                             {"time_above", [](const Line& line) { return line.of->time_above[line.edge]; }}})};
}

}  // namespace

std::vector<Section> fatigue_sections(Evidence& evidence) {
    const Fatigue found =
        find_fatigue(evidence.moored ? moored_windows(evidence, *evidence.moored) : windows_of(evidence));
    const std::string subject = evidence.moored ? "mooring force k x" : "load";
    if (found.cases.empty())
        return {{.missing = "Fatigue: unknown, because the file keeps no load histories (analysis.history_steps).\n"}};
    Section cycles{
        .title = "Cycles and duration of the " + subject,
        .table = case_table(evidence.summary, found),
        .after = "\nRainflow cycles (ASTM E1049) of the surge " + subject +
                 " in the window. Equivalent range: met once a "
                 "second, it does the damage of all cycles, by Palmgren and Miner with an S-N curve of slope m; "
                 "brackets: 95 % over arrangements (t).\n",
        .records = records_of(evidence.summary, found)};
    if (found.cases.size() > most_tabled) {
        cycles.notes = {"Cycles and time above levels are in --format csv."};
        return {std::move(cycles)};
    }
    return {
        std::move(cycles),
        {.table = edge_table(evidence.summary, found),
         .after = "\nCycles per hour with a range of at least so much, and share of the time with a load above it.\n"}};
}

}  // namespace floes
