// Collects the contents of the page from a campaign file.

#include <algorithm>
#include <cmath>
#include <set>

#include "campaign_file/read_history.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "page/report_data.hpp"

namespace floes {
namespace {

constexpr std::size_t drawn_columns = 700;
constexpr std::size_t most_drawn_cases = 6;
constexpr double drawn_moduli[]{3, 5, 7, 10, 14, 20, 30, 45, 60, 90, 130, 200, 300, 450, 700, 1000};  // MPa
constexpr double crossing_of_the_paper = 10 * unit::megapascal;                                       // Fig. 8

/// The smallest and the largest value of each column, in order of time, so that peaks are kept.
std::vector<std::pair<double, double>> thinned(const SurgeHistory& history) {
    std::vector<std::pair<double, double>> points;
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
        done[row] += member.status == RowStatus::done ? 1 : 0;
    }
    const auto found = std::ranges::find(done, table.cases.size());
    return found == done.end() ? -1 : static_cast<int>(found - done.begin());
}

std::optional<HybridCurve> hybrid_of(const Scenario& scenario) {
    std::vector<double> moduli;
    for (const double modulus : drawn_moduli) moduli.push_back(modulus * unit::megapascal);
    try {
        return hybrid_curve(scenario, hybrid_model(scenario).crossing_at(crossing_of_the_paper), moduli);
    } catch (const InputError&) {
        return std::nullopt;  // Lindqvist's formula does not apply to this wall
    }
}

/// The design load of every case over 1 s, or over the longest time that members averaged over if they did not take
/// that.
void take_designs(ReportData& data) {
    const std::vector<double>& times = data.table.averaging_times;
    if (times.empty()) return;
    if (std::ranges::find(times, data.asked.averaging) == times.end()) data.asked.averaging = times.back();
    try {
        data.designs = find_design_loads(with_peaks(data.file, data.table), data.asked);
    } catch (const InputError&) {
        data.designs.clear();  // an older file without histories, or with thinned ones
    }
}

/// What the answer needs beside the evidence.
void take_answer(ReportData& data) {
    if (data.campaign.design.active()) data.sensitivity = find_sensitivity(data.campaign, data.table);
    if (in_detail(data.campaign)) take_designs(data);
}

/// In file order.
std::vector<std::size_t> most_loaded_cases(const Summary& summary) {
    const auto load = [&](std::size_t k) { return summary.cases[k].of(quantity("mean_load")).estimate; };
    std::vector<std::size_t> cases;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        if (summary.cases[k].done > 0) cases.push_back(k);
    std::ranges::stable_sort(cases, std::ranges::greater{}, load);
    cases.resize(std::min(cases.size(), most_drawn_cases));
    std::ranges::sort(cases);
    return cases;
}

}  // namespace

ReportData answer_data(Campaign campaign, CampaignTable table) {
    ReportData data;
    data.campaign = std::move(campaign);
    data.table = std::move(table);
    data.summary = summarise(data.table);
    take_answer(data);
    return data;
}

ReportData read_report_data(const std::filesystem::path& path) {
    ReportData data;
    const CampaignFile file(path);
    static_cast<Evidence&>(data) = read_evidence(file);
    data.file_name = path.filename().string();
    take_answer(data);
    if (data.campaign.design.active()) data.points = find_points(data.campaign);
    if (in_detail(data.campaign)) {
        data.pairs = compare_pairs(data.table, {});
        data.extremes = find_extremes(data.table);
    }
    data.levels = find_levels(data.table);
    for (const Finding& finding : findings())
        if (!finding.page_title.empty() && finding.unasked(data.campaign))
            data.further.emplace_back(finding.page_title, finding.section(data));
    const int arrangement = common_arrangement(data.table);
    for_each_history(file, [&](const SurgeHistory& history) {
        const MemberRow& member = data.table.members[static_cast<std::size_t>(history.member)];
        if (member.arrangement == arrangement) data.histories.push_back({member.case_index, thinned(history)});
    });
    data.drawn_cases = most_loaded_cases(data.summary);
    data.load_maps = find_load_maps(file, data.table);
    std::erase_if(data.load_maps, [&](const CaseLoadMap& found) {
        return !std::ranges::binary_search(data.drawn_cases, found.case_index);
    });
    data.breaks = read_breaks(file);
    data.largest_member = member_with_largest_load(data.table, [](const MemberRow&) { return true; }).value_or(-1);
    if (data.largest_member >= 0) data.largest_poses = read_poses(file, data.largest_member);
    data.hybrid = hybrid_of(data.campaign.cases.front().scenario);
    return data;
}

}  // namespace floes
