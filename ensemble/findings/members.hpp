#pragma once
// One line for each member, for further analysis of the values themselves.

#include "campaign_file/campaign_table.hpp"
#include "tables/section.hpp"

namespace floes {

/// In CSV: member,case,arrangement,status,…: the quantities of a case's summary under the same names, the maximum of
/// each segment, and whether the load was steady. Fields are empty where a member failed or is missing.
Section members_section(const CampaignTable& table);

/// In CSV: case,arrangement,quantity,unit,value: a line for each quantity of each done member, as far as it is known.
Section long_section(const CampaignTable& table);

}  // namespace floes
