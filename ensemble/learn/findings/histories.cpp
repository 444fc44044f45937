#include "findings/report_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign_file/read_history.hpp"

namespace floes {
namespace {

constexpr std::size_t drawn_columns = 700;

struct DrawnHistory {
    std::size_t case_index = 0;
    Figure::Points points;  ///< s after the tow began, N
};

/// The smallest and the largest value of each column, in order of time, so that peaks are kept.
Figure::Points thinned(const SurgeHistory& history) {
    Figure::Points points;
    const std::size_t width = std::max<std::size_t>(1, history.surge.size() / drawn_columns);
    for (std::size_t first = 0; first < history.surge.size(); first += width) {
        const auto column = history.surge.subspan(first, std::min(width, history.surge.size() - first));
        const auto [low, high] = std::ranges::minmax_element(column);
        const auto [early, late] = std::minmax(low, high);
        for (const auto& value : {early, late})
            points.emplace_back(history.step * static_cast<double>(first + 1 + (value - column.begin())), *value);
    }
    return points;
}

/// The first arrangement that is done in every case; -1 if there is none.
int common_arrangement(const CampaignTable& table) {
    std::vector<std::size_t> done;
    for (const MemberRow& member : table.members) {
        const auto row = static_cast<std::size_t>(member.arrangement);
        if (row >= done.size()) done.resize(row + 1);
        done[row] += member.done() ? 1 : 0;
    }
    const auto found = std::ranges::find(done, table.cases.size());
    return found == done.end() ? -1 : static_cast<int>(found - done.begin());
}

Figure history_figure(const CampaignTable& table, std::vector<DrawnHistory> histories) {
    double largest = 0;
    double end = 1;
    for (const DrawnHistory& history : histories) {
        for (const auto& [time, load] : history.points) {
            largest = std::max(largest, load);
            end = std::max(end, time);
        }
    }
    const double shift = std::max(100.0, 100 * std::ceil(0.7 * largest / 100));
    const double count = static_cast<double>(histories.size());
    Figure figure{.description = "Surge load over time, one curve for each case",
                  .x = {fmt::format("time since the tow began, s; each case shifted by {:g} N", shift), 0, end},
                  .y = {"surge load, N", 0, std::max(1.0, shift * (count - 1) + 1.05 * largest)},
                  .size = {720, 160 + 90 * count}};
    double base = 0;
    for (DrawnHistory& history : histories) {
        for (auto& [time, load] : history.points) load += base;
        const CaseRow& about = table.cases[history.case_index];
        figure.line(std::move(history.points), colour(history.case_index) + " thin");
        figure.text(end * 0.01, base + 0.45 * shift, about.name, "start", "key " + colour(history.case_index));
        figure.upright(about.analysis.steady_start, "dashed");
        base += shift;
    }
    return figure;
}

}  // namespace

Section histories_section(Evidence& evidence) {
    std::vector<DrawnHistory> histories;
    const int arrangement = common_arrangement(evidence.table);
    for_each_history(evidence.file, [&](const SurgeHistory& history) {
        const MemberRow& member = evidence.table.members[static_cast<std::size_t>(history.member)];
        if (member.arrangement == arrangement)
            histories.push_back({static_cast<std::size_t>(member.case_index), thinned(history)});
    });
    if (histories.empty())
        return {.before = "No figure: the file has no load histories of an arrangement that is done in every case.\n"};
    Figure figure = history_figure(evidence.table, std::move(histories));
    figure.caption =
        "One arrangement, every case, shifted upwards (the paper's Fig. 6). Dashed: start of the analysis window.";
    if (std::ranges::any_of(evidence.table.cases, [](const CaseRow& one) { return one.analysis.history_stride > 1; }))
        figure.caption += " The file holds means over several steps, whose peaks are lower than the measured ones.";
    return {.figures = {std::move(figure)}};
}

}  // namespace floes
