#pragma once
// The one place that opens configuration files.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// Reads and checks the campaign of the configuration at `path`, with "key=value" overrides (--set). Throws InputError.
Campaign load_campaign(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace floes
