#pragma once
// The report of a campaign: one self-contained HTML page for the engineer who has to defend a design load.

#include <string>
#include <vector>

#include "findings/catalogue.hpp"

namespace floes {

struct MomentPicture {
    std::string png;      ///< its bytes
    std::string caption;  ///< what is to be seen
};

/// A member with a large load in pictures: how the floes lay before, at the largest load, and at the end.
struct Moment {
    int member = 0;
    std::vector<MomentPicture> pictures;
    std::vector<std::string> differences;  ///< of the member computed for them from the one in the file
};

/// Findings are computed of the evidence; the rest is what only the report tells.
struct ReportData {
    Evidence evidence;
    std::vector<Moment> moments;  ///< the worst ones; empty: no pictures were made
    std::string command;          ///< that repeats the campaign
};

/// The page: no scripts, no external resources, for light and dark screens and for print. Reads the campaign file.
/// Throws InputError as read_campaign_file() does.
std::string report_page(ReportData data);

}  // namespace floes
