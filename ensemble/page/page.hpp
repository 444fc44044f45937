#pragma once
// The report of a campaign: one self-contained HTML page for the engineer who has to defend a design load.

#include <filesystem>
#include <string>
#include <vector>

#include "findings/catalogue.hpp"
#include "run/campaign_status.hpp"

namespace floes {

struct MomentPicture {
    std::string png;      ///< its bytes
    std::string caption;  ///< what is to be seen
};

/// The worst moment of a member in pictures: how the floes lay before, then, and at the end.
struct Moment {
    int member = 0;
    std::string of;  ///< what is largest then, as floes replay --of; empty: the load of a step
    std::vector<MomentPicture> pictures;
    std::vector<std::string> differences;  ///< of the member computed for them from the one in the file
};

/// Findings are computed of the evidence; the rest is what only the report tells.
struct ReportData {
    Evidence evidence;
    std::vector<Moment> moments;  ///< the worst ones; empty: no pictures were made
    std::string command;          ///< that repeats the campaign
    std::string title = {};       ///< of the page; empty: by the campaign's name
    std::string author = {};      ///< empty: nobody is named
};

/// The page: no scripts, no external resources, for light and dark screens and for print. Reads the campaign file.
/// Throws InputError as read_campaign_file() does.
std::string report_page(ReportData data);

// A campaign under way as one HTML page: what is done, the answer so far and how precise it is, who computes, and what
// failed. While a run is active the page asks the browser to load it again every half minute.

inline constexpr int status_page_seconds = 30;  ///< from one page to the next

/// No scripts, no external resources, for light and dark screens. `campaign_file`: as the user names it, for the
/// commands that the page tells. `now`: when the snapshot was taken, UTC.
std::string status_page(const CampaignSnapshot& snapshot, const std::filesystem::path& campaign_file,
                        const std::string& now);

}  // namespace floes
