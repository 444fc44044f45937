#pragma once
// Where the load of each member acts, as the campaign file has it.

#include <functional>

#include "campaign_file/campaign_file.hpp"
#include "statistics/load_map.hpp"

namespace floes {

/// Calls `use` with the number and the load map of each done member that has one, in member order. Throws as
/// read_campaign_file() does.
void for_each_load_map(const CampaignFile& file, const std::function<void(int member, const LoadMap&)>& use);

}  // namespace floes
