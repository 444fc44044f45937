#pragma once
// The report of a campaign: one HTML page with everything in it, for the engineer who has to defend a design load.

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/read_details.hpp"
#include "findings/findings.hpp"
#include "findings/hybrid_curve.hpp"
#include "laboratory/calibration.hpp"

namespace floes {

/// The surge load of one member, thinned to what a picture can show.
struct DrawnHistory {
    int case_index = 0;
    std::vector<std::pair<double, double>> points;  ///< s after the tow began, N
};

/// All that the page tells.
struct ReportData {
    Campaign campaign;  ///< as the file's own configuration has it
    CampaignOrigin origin;
    Findings findings;  ///< with pairs and extremes where in_detail(), points and sensitivity of a design, levels
    std::vector<DrawnHistory>
        histories;  ///< of the first arrangement that every case has done; empty where none is kept
    std::vector<BreakRow> breaks;
    int largest_member = -1;  ///< the done member with the largest load; -1: none is done
    std::vector<PlanarPose> largest_poses;
    std::vector<CurvePoint> curve;      ///< plate tests of the first case's ice; empty: not measured
    std::optional<HybridCurve> hybrid;  ///< none where the formulas have no load for this structure
    std::string command;                ///< that repeats the campaign
};

/// Reads everything but `curve` and `command` from the file. Throws InputError as read_campaign_file() does.
ReportData read_report_data(const std::filesystem::path& path);

/// The page: no scripts, nothing loaded from elsewhere, light and dark, fit for paper.
std::string report_page(const ReportData& data);

}  // namespace floes
