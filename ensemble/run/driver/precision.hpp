#pragma once
// A campaign's stop rule, applied to its members.

#include <optional>

#include "campaign_file/campaign_table.hpp"
#include "inference/precision_stop.hpp"

namespace floes {

/// The rule before any member; empty if the campaign has no rule. Throws InputError as PrecisionStop does.
std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign);

/// The rule with every done and every failed member of `table`, which belongs to the campaign.
std::optional<PrecisionStop> stop_rule_of(const Campaign& campaign, const CampaignTable& table);

}  // namespace floes
