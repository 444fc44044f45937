#pragma once
// Where on the structure and when along the tow the load acts, over the members of each case. Needs no histories.

#include <cstddef>
#include <vector>

#include "campaign_file/campaign_file.hpp"
#include "campaign_file/campaign_table.hpp"
#include "inference/interval.hpp"
#include "statistics/load_map.hpp"

namespace floes {

struct CaseLoadMap {
    std::size_t case_index = 0;
    int members = 0;                  ///< done members with a map, at least 1
    LoadMap mean;                     ///< over them
    std::vector<Interval> along_tow;  ///< of the mean over members in each part of the window, N

    double load() const;  ///< N: the sum over the structure

    /// Share of the load that acts within `angle` degrees of straight ahead, a multiple of 10; NaN of no load.
    double share_within(double angle) const;

    /// Share of the load in the heights from `low` to `high`, shares of the depth, by their middles; NaN of no load.
    double share_between(double low, double high) const;
};

/// Cases without a map are left out. Throws as read_campaign_file() does.
std::vector<CaseLoadMap> find_load_maps(const CampaignFile& file, const CampaignTable& table);

}  // namespace floes
