#pragma once
// The report of a campaign: one self-contained HTML page for the engineer who has to defend a design load.

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign_file/read_details.hpp"
#include "findings/extremes.hpp"
#include "findings/hybrid_curve.hpp"
#include "findings/levels.hpp"
#include "findings/pairs.hpp"
#include "findings/parts.hpp"
#include "findings/points.hpp"
#include "findings/sensitivity.hpp"
#include "laboratory/calibration.hpp"

namespace floes {

/// The surge load of one member, thinned to the resolution of a figure.
struct DrawnHistory {
    int case_index = 0;
    std::vector<std::pair<double, double>> points;  ///< s after the tow began, N
};

/// Contents of the page.
struct ReportData : Evidence {
    CampaignOrigin origin;
    std::optional<std::vector<PairRow>> pairs;          ///< if in_detail()
    std::optional<std::vector<CaseExtremes>> extremes;  ///< likewise
    std::optional<Sensitivity> sensitivity;             ///< of a design
    std::optional<DesignPoints> points;                 ///< of a design
    std::vector<LevelRow> levels;
    std::vector<DrawnHistory> histories;  ///< of the first arrangement done in every case; empty: no histories
    std::vector<BreakRow> breaks;
    int largest_member = -1;  ///< the done member with the largest load; -1: none is done
    std::vector<PlanarPose> largest_poses;
    std::vector<CurvePoint> curve;      ///< plate tests of the first case's ice; empty: not measured
    std::optional<HybridCurve> hybrid;  ///< none if the formulas do not apply to this structure
    std::string command;                ///< that repeats the campaign
};

/// Reads everything but `curve` and `command` from the file. Throws InputError as read_campaign_file() does.
ReportData read_report_data(const std::filesystem::path& path);

/// The page: no scripts, no external resources, for light and dark screens and for print.
std::string report_page(const ReportData& data);

}  // namespace floes
