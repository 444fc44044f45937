#pragma once
// The identity of campaigns and cases: digests that are equal exactly when the members are, and what differs otherwise.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// 32 hex digits: equal exactly when every member of the two campaigns is the same and they have the same members.
std::string fingerprint(const Campaign& campaign);

/// 32 hex digits of one case's physics (scenario and seed, not its name or the number of arrangements): what a stored
/// member of it is valid for.
std::string case_fingerprint(const Campaign& campaign, int case_index);

/// One line a differing key: "general.iterations: 50 there, 20 here". Empty when equal.
std::vector<std::string> differences(const Campaign& there, const Campaign& here);

}  // namespace floes
