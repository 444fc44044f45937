#include "campaign_file/campaign_table.hpp"

#include <algorithm>
#include <cmath>

#include "campaign/case_words.hpp"
#include "core/contract.hpp"
#include "core/units.hpp"
#include "member/array_output.hpp"

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

ArrangementRows::ArrangementRows(const Campaign& campaign)
    : group_of_case_(sharing_groups(campaign)), groups_(std::ranges::max(group_of_case_) + 1) {}

int ArrangementRows::row(MemberKey member) const {
    return member.arrangement * groups_ + group_of_case_.at(static_cast<std::size_t>(member.case_index));
}

std::vector<double> of_all_cases(const Campaign& campaign,
                                 const std::function<std::vector<double>(const Scenario&)>& of) {
    std::vector<double> values;
    for (const Case& one : campaign.cases) {
        const std::vector<double> own = of(one.scenario);
        values.insert(values.end(), own.begin(), own.end());
    }
    std::ranges::sort(values);
    values.erase(std::ranges::unique(values).begin(), values.end());
    return values;
}

namespace {

void set_missing(MemberRow& row, int segments, std::size_t levels) {
    static_cast<MemberOutputs&>(row) = unmeasured(segments);
    row.steps_above.assign(levels, undefined);
    row.upcrossings.assign(levels, undefined);
}

CaseRow case_row(const Case& one) {
    const Scenario& scenario = one.scenario;
    return {one.name,
            followed_cfm(scenario.joint),
            scenario.mean_ice().elastic_modulus,
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

CampaignCases cases_of(const Campaign& campaign) {
    CampaignCases table;
    table.title = campaign.name;
    for (const Case& one : campaign.cases) table.cases.push_back(case_row(one));
    table.levels = of_all_cases(campaign, [](const Scenario& s) { return s.analysis.exceedance_levels; });
    table.averaging_times = of_all_cases(campaign, &Scenario::averaging_times);
    return table;
}

}  // namespace

MemberRows::MemberRows(const Campaign& campaign)
    : campaign_(campaign), cases_(cases_of(campaign)), arrangements_(campaign) {}

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
    const Analysis& analysis = cases_.cases[static_cast<std::size_t>(key.case_index)].analysis;
    set_missing(row, analysis.segments, cases_.levels.size());
    if (status != RowStatus::done) return row;
    static_cast<MemberOutputs&>(row) = result;
    set_levels(row, cases_.levels, analysis.exceedance_levels, result.levels);
    return row;
}

CampaignTable campaign_table(const Campaign& campaign, const StoredMembers& members) {
    const MemberRows rows(campaign);
    CampaignTable table{rows.cases(), {}};
    for (const std::optional<std::size_t>& known : match_records(campaign, members.notes())) {
        const std::optional<MemberRecord> record = known ? std::optional(members.read(*known)) : std::nullopt;
        table.members.push_back(rows.row(table.members.size(), record ? &*record : nullptr));
    }
    return table;
}

constexpr std::string_view times_path = "averaging_time";

Sample::Sample(const CampaignTable& table) : CampaignCases(table), done_(table.cases.size()) {
    const std::vector<Quantity> known = table.quantities();
    MemberResult result;
    for (const MemberRow& row : table.members) {
        const std::size_t member = case_of_.size();
        case_of_.push_back(static_cast<std::size_t>(row.case_index));
        arrangement_of_.push_back(row.arrangement);
        status_.push_back(row.status);
        reason_.push_back(row.reason);
        steady_.push_back(row.done() && row.load.steady);
        if (row.done()) done_.at(case_of_.back()).push_back(member);
        for (const Quantity& one : known) columns_[std::string{one.key.view()}].push_back(row.value(one));
        static_cast<MemberOutputs&>(result) = row;
        for (const ArrayOutput& array : array_outputs) {
            // Levels differ between cases: the table has them in places that all share.
            if ((!array.in_table && array.path != times_path) || array.group() == "exceedance") continue;
            const ArrayValues values = row.done() ? array.access.get(result) : ArrayValues{};
            add(array.path, values.values, values.sizes.empty() ? 0 : values.sizes.back());
        }
        add("exceedance/steps_above", row.steps_above, row.steps_above.size());
        add("exceedance/upcrossings", row.upcrossings, row.upcrossings.size());
    }
    for (Members& members : done_)
        std::ranges::stable_sort(members, {}, [&](std::size_t k) { return arrangement_of_[k]; });
}

void Sample::add(std::string_view path, std::span<const double> values, std::size_t width) {
    Array& array = arrays_.try_emplace(std::string{path}).first->second;
    if (array.first.empty()) array.first.push_back(0);
    array.values.insert(array.values.end(), values.begin(), values.end());
    array.first.push_back(array.values.size());
    array.width.push_back(width);
}

double Sample::value(std::size_t member, const Quantity& quantity) const {
    FLOES_EXPECTS(member < members());
    const auto column = columns_.find(quantity.key.view());
    return column == columns_.end() ? undefined : column->second.at(member);
}

std::vector<double> Sample::values(const Members& members, const Quantity& quantity) const {
    std::vector<double> values;
    values.reserve(members.size());
    for (const std::size_t member : members) values.push_back(value(member, quantity));
    return values;
}

std::span<const double> Sample::along(std::string_view array, std::size_t member) const {
    FLOES_EXPECTS(arrays_.contains(array) && member < members());
    const Array& found = arrays_.find(array)->second;
    return std::span(found.values).subspan(found.first[member], found.first[member + 1] - found.first[member]);
}

std::span<const double> Sample::along(std::string_view array, std::size_t member, std::size_t place) const {
    const std::span<const double> all = along(array, member);
    const std::size_t width = arrays_.find(array)->second.width[member];
    if ((place + 1) * width > all.size()) return {};
    std::span<const double> row = all.subspan(place * width, width);
    while (!row.empty() && std::isnan(row.back())) row = row.first(row.size() - 1);
    return row;
}

std::optional<std::size_t> Sample::place_of_time(std::size_t member, double time) const {
    const std::span<const double> times = along(times_path, member);
    const auto found = std::ranges::find(times, time);
    return found == times.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - times.begin()));
}

std::vector<double> Sample::values(const Members& members, std::string_view array, std::size_t place,
                                   std::size_t second) const {
    std::vector<double> values;
    values.reserve(members.size());
    for (const std::size_t member : members) {
        const std::span<const double> all = along(array, member);
        const std::size_t width = arrays_.find(array)->second.width[member];
        const bool two = width < all.size();  // one axis is one row
        const std::size_t at = two ? place * width + second : place;
        values.push_back(at < all.size() ? all[at] : undefined);
    }
    return values;
}

}  // namespace floes
