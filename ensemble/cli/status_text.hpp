#pragma once
// What `floes status` prints.

#include <string>

#include "store/campaign_status.hpp"

namespace floes {

/// For people: a sentence, who is at work, a line a case, and the failures with their reasons.
std::string status_table(const CampaignStatus& status);

/// For programs: one JSON object with `title`, `done`, `failed`, `missing`, `total`, `at_work`, `seconds_left` (null
/// when unknown), `cases`, `failures`, `sessions`.
std::string status_json(const CampaignStatus& status);

}  // namespace floes
