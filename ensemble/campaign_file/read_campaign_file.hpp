#pragma once
// Reads the table of a campaign file.

#include <array>
#include <filesystem>

#include "campaign_file/campaign_table.hpp"

namespace floes {

/// Version of the layout, {major, minor}: a new minor only adds names.
inline constexpr std::array<int, 2> campaign_file_version{1, 7};
inline constexpr const char* campaign_filetype = "floes campaign";

/// Throws InputError when there is no such file, it is no campaign file, or its major version is not this program's.
CampaignTable read_campaign_file(const std::filesystem::path& path);

}  // namespace floes
