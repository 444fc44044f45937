#pragma once
// Reads the table of a campaign file.

#include "campaign_file/campaign_file.hpp"
#include "campaign_file/campaign_table.hpp"

namespace floes {

/// Throws RunError where it is damaged; so do the readers of the file's other parts.
CampaignTable read_campaign_file(const CampaignFile& file);

}  // namespace floes
