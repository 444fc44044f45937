#pragma once
// Where on the structure and when along the tow the load acts, over the members of each case. Needs no histories.

#include <cstddef>
#include <vector>

#include "campaign_file/campaign_file.hpp"
#include "campaign_file/campaign_table.hpp"
#include "findings/evidence.hpp"
#include "inference/interval.hpp"
#include "statistics/load_map.hpp"
#include "tables/figure.hpp"

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

// Figures of where on the structure and when along the tow the load acts. For this module only.

/// For each map, the wall unrolled: angle by height, all in one scale of colours.
std::vector<Figure> wall_figures(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);
Figure load_rose(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);       ///< by angle, in plan
Figure load_profile(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);    ///< by height
Figure load_along_tow(const Evidence& evidence, const std::vector<CaseLoadMap>& maps);  ///< over the distance towed

}  // namespace floes
