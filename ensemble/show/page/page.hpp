#pragma once
// The report of a campaign: one self-contained HTML page for the engineer who has to defend a design load.

#include <string>

#include "page/report_data.hpp"

namespace floes {

/// The page: no scripts, no external resources, for light and dark screens and for print. Reads the campaign file.
/// Throws InputError as read_campaign_file() does.
std::string report_page(ReportData data);

}  // namespace floes
