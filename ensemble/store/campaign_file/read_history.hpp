#pragma once
// The load histories of a campaign file, member by member: all of them at once may not fit into memory.

#include <functional>
#include <span>

#include "campaign_file/campaign_file.hpp"

namespace floes {

struct SurgeHistory {
    int member = 0;
    double step = 0;                ///< s from value to value: the case's Δt times its history_stride
    std::span<const double> surge;  ///< N, from t = 0 to the end of the run; means over history_stride steps each
};

/// Calls `use` for each done member with a stored history, in member order: never where the file has no
/// /history/surge_load, so that who reads must say when there was none. Throws as read_campaign_file() does.
void for_each_history(const CampaignFile& file, const std::function<void(const SurgeHistory&)>& use);

/// The same of the force of springs and lines against the surge load, of members whose structure gave way.
void for_each_mooring_history(const CampaignFile& file, const std::function<void(const SurgeHistory&)>& use);

/// The loads of one member.
void with_history(const CampaignFile& file, int member, const std::function<void(const SurgeHistory&)>& use);

}  // namespace floes
