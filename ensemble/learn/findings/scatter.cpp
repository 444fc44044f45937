#include "findings/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "campaign/identity.hpp"
#include "core/units.hpp"
#include "findings/load_columns.hpp"
#include "statistics/means.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

const double undefined = std::nan("");

/// The cases of the largest group that shares arrangements.
std::vector<std::size_t> largest_group(const Campaign& campaign) {
    const std::vector<int> groups = sharing_groups(campaign);
    std::map<int, std::vector<std::size_t>> cases;
    for (std::size_t k = 0; k < groups.size(); ++k) cases[groups[k]].push_back(k);
    std::vector<std::size_t> largest;
    for (const auto& [group, members] : cases)
        if (members.size() > largest.size()) largest = members;
    return largest;
}

using Members = std::vector<const MemberRow*>;

/// Of each case the members of the arrangements that all have done, in the same order.
std::vector<Members> common_members(const CampaignTable& table, const std::vector<std::size_t>& cases) {
    std::map<int, Members> by_arrangement;
    for (const std::size_t one : cases)
        for (const MemberRow* row : done_members(table, one)) by_arrangement[row->arrangement].push_back(row);
    std::vector<Members> members(cases.size());
    for (const auto& [arrangement, rows] : by_arrangement)
        if (rows.size() == cases.size())
            for (std::size_t k = 0; k < rows.size(); ++k) members[k].push_back(rows[k]);
    return members;
}

/// The variance of a run's value that its window alone would give, if all that differs between runs went on within
/// them; NaN where nothing says it.
double variance_of_time(const Quantity& quantity, const MemberRow& row, const std::map<int, double>& effective,
                        int member) {
    if (quantity.key.view() == "mean_load") {
        const auto found = effective.find(member);
        return found == effective.end() ? undefined : row.load.sd * row.load.sd / found->second;
    }
    const AveragedLoad* averaged = quantity.averaging > 0 ? row.averaged_over(quantity.averaging) : nullptr;
    const std::vector<double>& maxima = averaged != nullptr ? averaged->segment_maximum : row.load.segment_maximum;
    if (quantity.key.view() == "failure_ratio" || maxima.size() < 2) return undefined;
    const double sd = population_sd(maxima, mean_of(maxima));
    return sd * sd / static_cast<double>(maxima.size() - 1);
}

ScatterRow row_of(const Quantity& quantity, const CampaignTable& table, const std::vector<Members>& cases,
                  const std::map<int, double>& effective) {
    ScatterRow found;
    found.quantity = quantity;
    std::vector<std::vector<double>> values;
    double time = 0;
    std::size_t count = 0;
    for (const Members& members : cases) {
        std::vector<double>& own = values.emplace_back();
        for (const MemberRow* row : members) own.push_back(quantity.of(*row));
        const double mean = mean_of(own);
        for (double& value : own) value /= mean;
        for (const MemberRow* row : members) {
            time += variance_of_time(quantity, *row, effective, static_cast<int>(row - table.members.data())) /
                    (mean * mean);
            ++count;
        }
    }
    const bool known = std::ranges::all_of(values, [](const std::vector<double>& own) {
        return std::ranges::all_of(own, [](double value) { return std::isfinite(value); });
    });
    found.of_arrangement = arrangement_share(known ? values : std::vector<std::vector<double>>{});
    const double sd = found.of_arrangement.sd;
    found.of_time = time / static_cast<double>(count) / (sd * sd);
    return found;
}

std::string percent(double share) {
    return std::isfinite(share) ? fixed(share / unit::percent, 0) + " %" : "–";
}

}  // namespace

std::vector<ScatterRow> find_scatter(const Campaign& campaign, const CampaignTable& table, const Summary& summary,
                                     const SteadyReport& steady) {
    const std::vector<Members> cases = common_members(table, largest_group(campaign));
    if (cases.size() < 2 || cases.front().size() < 3) return {};
    std::map<int, double> effective;
    for (const MemberSteady& member : steady.members) effective[member.member] = member.effective_samples;
    std::vector<ScatterRow> rows;
    for (const LoadColumn& column : load_columns(summary))
        rows.push_back(row_of(column.quantity, table, cases, effective));
    return rows;
}

Section scatter_section(const std::vector<ScatterRow>& rows) {
    const auto number = [](double value) { return std::isfinite(value) ? Datum(value) : Undefined{}; };
    Section section{
        .records = {json_only(make_rows<ScatterRow>(
            "scatter", rows,
            {{"quantity", [](const ScatterRow& row) { return row.quantity.name.view(); }},
             {"cases", [](const ScatterRow& row) { return row.of_arrangement.cases; }},
             {"arrangements", [](const ScatterRow& row) { return row.of_arrangement.arrangements; }},
             {"sd_over_mean", [=](const ScatterRow& row) { return number(row.of_arrangement.sd); }},
             {"arrangement/share", [=](const ScatterRow& row) { return number(row.of_arrangement.share); }},
             {"arrangement/low", [=](const ScatterRow& row) { return number(row.of_arrangement.interval.low); }},
             {"arrangement/high", [=](const ScatterRow& row) { return number(row.of_arrangement.interval.high); }},
             {"time_share", [=](const ScatterRow& row) { return number(row.of_time); }}}))}};
    if (rows.empty()) {
        section.before =
            "Where scatter comes from: unknown; it takes two cases over the same arrangements, three of them done.\n";
        return section;
    }
    section.title = fmt::format("Where the scatter of single runs comes from, {} cases x {} arrangements",
                                rows.front().of_arrangement.cases, rows.front().of_arrangement.arrangements);
    section.table = {{"", "SD of one run, % of the mean", {"arrangement", "95 %"}, "window"}};
    for (const ScatterRow& row : rows) {
        const ArrangementShare& share = row.of_arrangement;
        section.table.push_back({std::string{row.quantity.label.view()},
                                 fixed(share.sd / unit::percent, 1),
                                 {percent(share.share), std::isfinite(share.interval.low)
                                                            ? fmt::format("[{}, {}]", percent(share.interval.low),
                                                                          percent(share.interval.high))
                                                            : "–"},
                                 percent(row.of_time)});
    }
    section.after =
        "\nArrangement: share of the variance of single runs that cases over the same arrangement have in common "
        "(intraclass correlation; below 0: by chance). The rest differs between runs of one arrangement: pairing does "
        "not "
        "take it away. Window: share that runs of this length would have if all their differences passed within a run "
        "(mean load: variance of a step over the effective samples; maxima: variance of the segments' over their "
        "number); near what the arrangement leaves, longer runs are worth as much as more of them.\n";
    return section;
}

}  // namespace floes
