#pragma once
// One line a member, for whoever wants to go on with the values themselves.

#include <string>

#include "findings/summary.hpp"

namespace floes {

/// member,case,arrangement,status,…: the quantities of a case's summary under the same names, the maximum of each
/// segment, and whether the load was steady. Fields are empty where a member failed or is missing.
std::string members_csv(const CampaignTable& table);

}  // namespace floes
