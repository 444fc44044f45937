#pragma once
// Reads the table of a campaign file.

#include <filesystem>

#include "campaign_file/campaign_table.hpp"

namespace floes {

/// Throws InputError when there is no such file, it is no campaign file, or its major version is not this program's.
CampaignTable read_campaign_file(const std::filesystem::path& path);

}  // namespace floes
