#pragma once
// The one place that opens configuration files.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// The text of a file. Throws InputError when it cannot be read.
std::string read_text(const std::string& path);

/// Reads and checks the campaign of the configuration at `path`, with "key=value" overrides (--set). Throws InputError.
Campaign load_campaign(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace floes
