#pragma once
// A campaign's status in sentences, the same on a terminal and on a page.

#include <string>

#include "driver/campaign_status.hpp"

namespace floes {

/// All cases together.
CaseStatus total_of(const CampaignStatus& status);

int members_of(const CaseStatus& one);

/// "smoke: 5 of 12 members done, 0 failed, 7 to do".
std::string counts_sentence(const CampaignStatus& status);

/// What runs, or how it ended and what to type if anything is left; empty if there is nothing to say.
std::string work_sentence(const CampaignStatus& status);

/// How close the campaign is to the precision that ends it.
std::string stop_sentence(const StopStatus& stop);

/// "mean_load of every case", "mean_load of E200 - E60".
std::string what_of(const StopRule& rule);

}  // namespace floes
