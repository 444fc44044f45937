#pragma once
// A campaign under way as one HTML page: what is done, the answer so far and how precise it is, who computes, and what
// failed. While a run is active the page asks the browser to load it again every half minute.

#include <filesystem>
#include <string>

#include "run/campaign_status.hpp"

namespace floes {

inline constexpr int status_page_seconds = 30;  ///< from one page to the next

/// No scripts, no external resources, for light and dark screens. `campaign_file`: as the user names it, for the
/// commands that the page tells. `now`: when the snapshot was taken, UTC.
std::string status_page(const CampaignSnapshot& snapshot, const std::filesystem::path& campaign_file,
                        const std::string& now);

}  // namespace floes
