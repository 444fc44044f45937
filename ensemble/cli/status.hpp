#pragma once
// What `floes status` prints.

#include <string>

#include "run/campaign_status.hpp"

namespace floes {

/// For people: a sentence, the active run, a line for each case, and the failures with their reasons.
std::string status_table(const CampaignStatus& status);

/// For programs: one JSON object with `title`, `done`, `failed`, `missing`, `total`, `at_work`, `seconds_left` and
/// `members_per_second` (null when unknown), `heartbeat`, `parts` and `stop` (null where there is none), `cases`,
/// `failures`, `remarks`, `under_way`, `slowest`, `sessions`.
std::string status_json(const CampaignStatus& status);

}  // namespace floes
