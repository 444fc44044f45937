#include "campaign_file/measure_anew.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "statistics/level_counts.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

void measure(MemberRow& row, std::span<const double> window, double step, const Analysis& analysis,
             std::span<const double> levels) {
    row.load = load_statistics(window, step, analysis.segments);
    std::vector<double> times;
    for (const AveragedLoad& one : row.averaged) times.push_back(one.time);
    row.averaged = averaged_load(window, {.time_step = step,
                                          .segments = analysis.segments,
                                          .times = times,
                                          .peak_separation = analysis.peak_separation});
    const std::vector<LevelCount> counts = count_levels(window, levels);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (std::isnan(row.steps_above[k])) continue;
        row.steps_above[k] = counts[k].steps_above;
        row.upcrossings[k] = counts[k].upcrossings;
    }
}

}  // namespace

std::span<const double> in_window(const SurgeHistory& history, const Analysis& analysis) {
    const auto count = static_cast<std::size_t>(std::llround(analysis.window / history.step));
    return history.surge.last(std::min(count, history.surge.size()));
}

CampaignTable measured_anew(const CampaignFile& file, CampaignTable table, const std::vector<Analysis>& windows) {
    for (std::size_t k = 0; k < table.cases.size(); ++k) table.cases[k].analysis = windows.at(k);
    for_each_history(file, [&](const SurgeHistory& history) {
        MemberRow& row = table.members.at(static_cast<std::size_t>(history.member));
        const CaseRow& about = table.cases.at(static_cast<std::size_t>(row.case_index));
        if (about.analysis.history_stride > 1)
            throw InputError(
                fmt::format("--window auto measures maxima and deviations anew, which needs the load of every step, "
                            "and the histories of case {} are means over {} steps (analysis.history_steps).",
                            about.name, about.analysis.history_stride));
        measure(row, in_window(history, about.analysis), history.step, about.analysis, table.levels);
    });
    return table;
}

}  // namespace floes
