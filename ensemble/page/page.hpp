#pragma once
// The report of a campaign: one HTML page with everything in it, for the engineer who has to defend a design load.

#include <string>

#include "page/report_data.hpp"

namespace floes {

/// The page: no scripts, nothing loaded from elsewhere, light and dark, fit for paper.
std::string report_page(const ReportData& data);

}  // namespace floes
