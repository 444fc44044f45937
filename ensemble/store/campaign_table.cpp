#include <limits>

#include "store/arrangement_rows.hpp"
#include "store/campaign_columns.hpp"
#include "store/campaign_file.hpp"

namespace floes {
namespace {

void set_missing(MemberRow& row, int segments) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const RealColumn& column : real_columns) column.field(row) = nan;
    row.segment_maximum.assign(static_cast<std::size_t>(segments), nan);
}

void set_numbers(MemberRow& row, const MemberResult& result) {
    set_load(row, result.load);
    row.failure_ratio = result.failure_ratio;
    row.failures_bending = result.failures_bending;
    row.failures_shear = result.failures_shear;
    row.failures_compression = result.failures_compression;
    row.mean_sway = result.mean_sway;
    row.mean_heave = result.mean_heave;
    row.peaks = result.peaks;
}

CaseRow case_row(const Case& one) {
    const Scenario& scenario = one.scenario;
    return {one.name,
            scenario.joint.cfm,
            scenario.ice.elastic_modulus,
            scenario.field.far_end,
            scenario.contact.erp,
            scenario.structure.profile,
            scenario.analysis};
}

}  // namespace

void set_load(MemberRow& row, const LoadStatistics& load) {
    row.mean_load = load.mean;
    row.sd_load = load.sd;
    row.maximum_load = load.maximum;
    row.segment_maximum = load.segment_maximum;
    row.mean_maximum = load.mean_maximum;
    row.sd_maximum = load.sd_maximum;
    row.trend = load.trend;
    row.trend_p = load.trend_p;
    row.steady = load.steady;
}

CampaignTable campaign_table(const Campaign& campaign, std::span<const MemberRecord> records) {
    CampaignTable table;
    table.title = campaign.name;
    for (const Case& one : campaign.cases) table.cases.push_back(case_row(one));
    const ArrangementRows arrangements(campaign);
    int number = 0;
    for (const MemberRecord* record : match_records(campaign, records)) {
        const MemberKey key = member_key(campaign, number++);
        MemberRow& row = table.members.emplace_back();
        row.case_index = key.case_index;
        row.arrangement = arrangements.row(key);
        set_missing(row, campaign.cases[static_cast<std::size_t>(key.case_index)].scenario.analysis.segments);
        if (record == nullptr) continue;
        row.reason = record->result.reason;
        if (record->result.status == MemberStatus::done) {
            row.status = RowStatus::done;
            set_numbers(row, record->result);
        } else {
            row.status = RowStatus::failed;
        }
    }
    return table;
}

}  // namespace floes
