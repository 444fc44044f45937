#include <algorithm>
#include <functional>
#include <limits>

#include "campaign_file/arrangement_rows.hpp"
#include "campaign_file/campaign_table.hpp"
#include "campaign_file/followed_cfm.hpp"

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What a function gives of the scenarios of all cases, rising, each value once.
template <class Function>
std::vector<double> of_all_cases(const Campaign& campaign, Function function) {
    std::vector<double> values;
    for (const Case& one : campaign.cases) {
        const std::vector<double> own = std::invoke(function, one.scenario);
        values.insert(values.end(), own.begin(), own.end());
    }
    std::ranges::sort(values);
    values.erase(std::ranges::unique(values).begin(), values.end());
    return values;
}

void set_missing(MemberRow& row, int segments, std::size_t levels) {
    static_cast<MemberOutputs&>(row) = unmeasured(segments);
    row.steps_above.assign(levels, nan);
    row.upcrossings.assign(levels, nan);
}

CaseRow case_row(const Case& one) {
    const Scenario& scenario = one.scenario;
    return {one.name,
            followed_cfm(scenario.joint),
            scenario.ice.elastic_modulus,
            scenario.field.far_end,
            scenario.contact_law(),
            scenario.structure.shape,
            scenario.analysis,
            scenario.general.time_step};
}

}  // namespace

double MemberRow::value(const Quantity& quantity) const {
    return done() ? quantity.of(*this) : nan;
}

const AveragedLoad* MemberRow::averaged_over(double time) const {
    const auto found = std::ranges::find(averaged, time, &AveragedLoad::time);
    return done() && found != averaged.end() ? &*found : nullptr;
}

void set_levels(MemberRow& row, std::span<const double> all, std::span<const double> own,
                std::span<const LevelCount> counts) {
    for (std::size_t k = 0; k < std::min(own.size(), counts.size()); ++k) {
        const auto place = static_cast<std::size_t>(std::ranges::lower_bound(all, own[k]) - all.begin());
        row.steps_above.at(place) = counts[k].steps_above;
        row.upcrossings.at(place) = counts[k].upcrossings;
    }
}

CampaignTable campaign_table(const Campaign& campaign, std::span<const MemberRecord> records) {
    CampaignTable table;
    table.title = campaign.name;
    for (const Case& one : campaign.cases) table.cases.push_back(case_row(one));
    table.levels = of_all_cases(campaign, [](const Scenario& s) { return s.analysis.exceedance_levels; });
    table.averaging_times = of_all_cases(campaign, &Scenario::averaging_times);
    const ArrangementRows arrangements(campaign);
    int number = 0;
    for (const MemberRecord* record : match_records(campaign, records)) {
        const MemberKey key = member_key(campaign, number++);
        MemberRow& row = table.members.emplace_back();
        row.case_index = key.case_index;
        row.arrangement = arrangements.row(key);
        const Analysis& analysis = table.cases[static_cast<std::size_t>(key.case_index)].analysis;
        set_missing(row, analysis.segments, table.levels.size());
        if (record == nullptr) continue;
        row.reason = record->result.reason;
        if (record->result.status == MemberStatus::done) {
            row.status = RowStatus::done;
            static_cast<MemberOutputs&>(row) = record->result;
            set_levels(row, table.levels, analysis.exceedance_levels, record->result.levels);
        } else {
            row.status = RowStatus::failed;
        }
    }
    return table;
}

std::optional<int> member_with_largest_load(const CampaignTable& table,
                                            const std::function<bool(const MemberRow&)>& counts) {
    std::optional<int> largest;
    for (std::size_t k = 0; k < table.members.size(); ++k) {
        const MemberRow& row = table.members[k];
        if (!row.done() || !counts(row)) continue;
        if (!largest || row.load.maximum > table.members[static_cast<std::size_t>(*largest)].load.maximum)
            largest = static_cast<int>(k);
    }
    return largest;
}

}  // namespace floes
