// Fatigue and operation: cycles of the load, and how long it lasts above a level.

#include "findings/sections.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/units.hpp"
#include "findings/moored.hpp"
#include "findings/summary.hpp"
#include "statistics/averaged_load.hpp"

namespace floes {

namespace {

constexpr std::size_t edge_count = 12;

/// For one member.
struct Counted {
    double time;  ///< s
    std::vector<double> loads;
    std::vector<LoadCycle> cycles;
};

Counted counted_of(const LoadWindow& window) {
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(window.averaging / window.step)));
    Counted made{static_cast<double>(window.loads.size()) * window.step, running_means(window.loads, steps), {}};
    made.cycles = rainflow(made.loads);
    return made;
}

/// 1, 2, 2.5 or 5 times a power of ten, not below `least`.
double round_width(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double digit : {1.0, 2.0, 2.5, 5.0})
        if (digit * power >= least) return digit * power;
    return 10 * power;
}

std::vector<double> edges_of(const std::map<std::size_t, std::vector<Counted>>& cases) {
    double largest = 0;
    for (const auto& [index, members] : cases)
        for (const Counted& one : members) {
            for (const double load : one.loads) largest = std::max(largest, load);
            for (const LoadCycle& cycle : one.cycles) largest = std::max(largest, cycle.range);
        }
    std::vector<double> edges;
    if (largest <= 0) return edges;
    const double width = round_width(largest / edge_count);
    for (std::size_t k = 0; k < edge_count; ++k) edges.push_back(width * static_cast<double>(k));
    return edges;
}

Interval equivalent_of(const std::vector<Counted>& members, double slope) {
    std::vector<double> damage;
    for (const Counted& one : members) damage.push_back(damage_sum(one.cycles, slope) / one.time);
    Interval found = mean_interval(damage);
    for (double* value : {&found.estimate, &found.low, &found.high})
        *value = std::pow(std::max(*value, 0.0), 1 / slope);
    return found;
}

CaseFatigue fatigue_of(std::size_t index, const std::vector<Counted>& members, const std::vector<double>& edges) {
    CaseFatigue made{.case_index = index,
                     .runs = static_cast<int>(members.size()),
                     .equivalent = {},
                     .cycles_above = std::vector<double>(edges.size(), 0),
                     .time_above = std::vector<double>(edges.size(), 0)};
    double hours = 0;
    for (const Counted& one : members) hours += one.time / unit::hour;
    const double runs = static_cast<double>(members.size());
    for (const Counted& one : members) {
        for (const LoadCycle& cycle : one.cycles) {
            made.cycles += cycle.count / hours;
            for (std::size_t k = 0; k < edges.size(); ++k)
                if (cycle.range >= edges[k]) made.cycles_above[k] += cycle.count / hours;
        }
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const auto above = std::ranges::count_if(one.loads, [&](double load) { return load > edges[k]; });
            made.time_above[k] += static_cast<double>(above) / static_cast<double>(one.loads.size()) / runs;
        }
    }
    for (const double slope : fatigue_slopes) made.equivalent.push_back(equivalent_of(members, slope));
    return made;
}

}  // namespace

Fatigue find_fatigue(std::span<const LoadWindow> windows) {
    std::map<std::size_t, std::vector<Counted>> cases;
    std::map<std::size_t, double> averaging;
    for (const LoadWindow& window : windows) {
        Counted one = counted_of(window);
        if (one.loads.empty()) continue;
        cases[window.case_index].push_back(std::move(one));
        averaging[window.case_index] = std::max(window.averaging, window.step);
    }
    Fatigue made{edges_of(cases), {}};
    for (const auto& [index, members] : cases) {
        made.cases.push_back(fatigue_of(index, members, made.edges));
        made.cases.back().averaging = averaging[index];
    }
    return made;
}

namespace {

constexpr std::size_t most_tabled = 4;  // whose bins are shown; of more they are in CSV

std::vector<LoadWindow> windows_of(const Evidence& evidence) {
    std::vector<LoadWindow> windows;
    for_each_history(evidence.file, [&](const StoredHistory& history) {
        const std::size_t of_case = evidence.case_of(history.member);
        const Analysis& analysis = evidence.sample.cases[of_case].analysis;
        const auto first = static_cast<std::size_t>(std::lround(analysis.steady_start / history.step));
        const auto count = static_cast<std::size_t>(std::lround(analysis.window / history.step));
        if (first + count > history.values.size()) return;
        const auto loads = history.values.subspan(first, count);
        const double averaging = analysis.averaging.empty() ? 0 : std::ranges::min(analysis.averaging);
        windows.push_back({of_case, history.step, averaging, std::vector<double>(loads.begin(), loads.end())});
    });
    return windows;
}

/// For the mooring force of a moored hull, at full scale.
std::vector<LoadWindow> moored_windows(const Evidence& evidence, const MooredRequest& request) {
    std::vector<bool> answered(evidence.sample.cases.size(), false);
    for (const MooredCase& one : find_moored(evidence, request)) answered[one.case_index] = one.refused.empty();
    std::vector<LoadWindow> windows;
    for_each_history(evidence.file, [&](const StoredHistory& history) {
        const std::size_t index = evidence.case_of(history.member);
        if (!answered[index]) return;
        LoadWindow& window = windows.emplace_back(LoadWindow{index, request.time_factor() * history.step, 0, {}});
        window.loads = mooring_force(history.values, history.step, evidence.sample.cases[index].analysis, request);
        for (double& force : window.loads) force *= request.force_factor();
    });
    return windows;
}

Results case_rows(const Summary& summary, const Fatigue& found) {
    Results results{.place = "fatigue/cases",
                    .columns = {{"case", "case"},
                                {"runs", "runs"},
                                {.key = "averaging", .words = "averaged over, s", .digits = 3},
                                {.key = "cycles_per_h", .words = "cycles per hour", .decimals = 0}}};
    for (const double slope : fatigue_slopes)
        results.columns.push_back(estimates(fmt::format("equivalent_range_m{:g}", slope),
                                            fmt::format("equivalent range, m = {:g}", slope), "N"));
    for (const CaseFatigue& of_case : found.cases) {
        std::vector<Datum> row{summary.named(of_case.case_index), of_case.runs, of_case.averaging, of_case.cycles};
        for (const Interval& range : of_case.equivalent) row.emplace_back(estimate(range, of_case.runs));
        results.add(std::move(row));
    }
    return results;
}

Results level_rows(const Summary& summary, const Fatigue& found) {
    Results results{.place = "fatigue/levels",
                    .columns = {{"case", "case"},
                                {.key = "level", .words = "range, load", .unit = "N", .digits = 4},
                                {.key = "cycles_above_per_h", .words = "cycles per hour", .digits = 4},
                                {.key = "time_above", .words = "time above", .unit = "share", .decimals = 3}},
                    .view = Results::View::none};
    for (const CaseFatigue& of_case : found.cases)
        for (std::size_t k = 0; k < found.edges.size(); ++k)
            results.add(
                {summary.named(of_case.case_index), found.edges[k], of_case.cycles_above[k], of_case.time_above[k]});
    return results;
}

}  // namespace

std::vector<Section> fatigue_sections(Evidence& evidence) {
    const Fatigue found =
        find_fatigue(evidence.moored ? moored_windows(evidence, *evidence.moored) : windows_of(evidence));
    const std::string subject = evidence.moored ? "mooring force k x" : "load";
    if (found.cases.empty())
        return {{.missing = "Fatigue: unknown, because the file keeps no load histories (analysis.history_steps).\n"}};
    Section cycles{.title = "Cycles and duration of the " + subject,
                   .results = {case_rows(evidence.summary, found), level_rows(evidence.summary, found)},
                   .after = "\nRainflow cycles (ASTM E1049) of the surge " + subject +
                            " in the window. Equivalent range: met once a second, it does the damage of all cycles, by "
                            "Palmgren and Miner with an S-N curve of slope m; brackets: 95 % over arrangements (t).\n"};
    if (found.cases.size() > most_tabled) {
        cycles.notes = {"Cycles and time above levels are in --format csv."};
        return {std::move(cycles)};
    }
    return {
        std::move(cycles),
        {.results = {pivot(level_rows(evidence.summary, found), "level", "case", {"cycles_above_per_h", "time_above"})},
         .after = "\nCycles per hour with a range of at least so much, and share of the time with a load above it.\n"}};
}

}  // namespace floes
