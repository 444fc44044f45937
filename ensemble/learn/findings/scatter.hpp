#pragma once
// Where the scatter of single runs comes from: from their arrangements, or from what differs between runs of one.

#include <vector>

#include "campaign/campaign.hpp"
#include "findings/steady.hpp"
#include "findings/summary.hpp"
#include "inference/variance_parts.hpp"

namespace floes {

/// One quantity over the largest group of cases that begin from the same arrangements, relative to each case's mean.
struct ScatterRow {
    Quantity quantity{};
    ArrangementShare of_arrangement;  ///< sd: over the mean
    double of_time = 0;  ///< share of the variance that windows of finite length alone would give; NaN: unknown
};

/// Mean load, largest load and broken floes, over the arrangements that every case of the group has done. `steady` has
/// the effective samples of members with histories; without, the mean load's share of time is unknown.
std::vector<ScatterRow> find_scatter(const Campaign& campaign, const CampaignTable& table, const Summary& summary,
                                     const SteadyReport& steady);

Section scatter_section(const std::vector<ScatterRow>& rows);

}  // namespace floes
