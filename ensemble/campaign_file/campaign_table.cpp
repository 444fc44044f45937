#include "campaign_file/campaign_table.hpp"
#include "campaign/case_words.hpp"
#include "core/undefined.hpp"

#include <algorithm>
#include <functional>

namespace floes {

double MemberRow::value(const Quantity& quantity) const {
    return done() ? quantity.of(*this) : undefined;
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

ArrangementRows::ArrangementRows(const Campaign& campaign)
    : group_of_case_(sharing_groups(campaign)), arrangements_(campaign.arrangements) {
    groups_ = *std::ranges::max_element(group_of_case_) + 1;
}

int ArrangementRows::row(MemberKey member) const {
    return member.arrangement * groups_ + group_of_case_.at(static_cast<std::size_t>(member.case_index));
}

namespace {

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
    row.steps_above.assign(levels, undefined);
    row.upcrossings.assign(levels, undefined);
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
            scenario.general.time_step,
            scenario.field,
            scenario.field_length(),
            scenario.gap(),
            scenario.water.current_velocity(),
            scenario.wind,
            scenario.joint,
            floe_words(scenario),
            motion_words(scenario),
            scenario.general.tolerance > 0 && scenario.general.solver == SolverKind::direct
                ? scenario.general.iterations
                : 0};
}

CampaignTable table_without_members(const Campaign& campaign) {
    CampaignTable table;
    table.title = campaign.name;
    for (const Case& one : campaign.cases) table.cases.push_back(case_row(one));
    table.levels = of_all_cases(campaign, [](const Scenario& s) { return s.analysis.exceedance_levels; });
    table.averaging_times = of_all_cases(campaign, &Scenario::averaging_times);
    return table;
}

}  // namespace

MemberRows::MemberRows(const Campaign& campaign)
    : campaign_(campaign), table_(table_without_members(campaign)), arrangements_(campaign) {}

MemberRow MemberRows::row(std::size_t member, const MemberRecord* record) const {
    if (record == nullptr) return row(member, RowStatus::missing, {});
    const bool done = record->result.status == MemberStatus::done;
    return row(member, done ? RowStatus::done : RowStatus::failed, record->whole(MemberRecord::Arrays::in_table));
}

MemberRow MemberRows::row(std::size_t member, RowStatus status, const MemberResult& result) const {
    const MemberKey key = member_key(campaign_, static_cast<int>(member));
    MemberRow row;
    row.case_index = key.case_index;
    row.arrangement = arrangements_.row(key);
    row.status = status;
    row.reason = result.reason;
    const Analysis& analysis = table_.cases[static_cast<std::size_t>(key.case_index)].analysis;
    set_missing(row, analysis.segments, table_.levels.size());
    if (status != RowStatus::done) return row;
    static_cast<MemberOutputs&>(row) = result;
    set_levels(row, table_.levels, analysis.exceedance_levels, result.levels);
    return row;
}

CampaignTable campaign_table(const Campaign& campaign, const StoredMembers& members) {
    const MemberRows rows(campaign);
    CampaignTable table = rows.table();
    for (const std::optional<std::size_t>& known : match_records(campaign, members.notes())) {
        const std::optional<MemberRecord> record = known ? std::optional(members.read(*known)) : std::nullopt;
        table.members.push_back(rows.row(table.members.size(), record ? &*record : nullptr));
    }
    return table;
}

}  // namespace floes
