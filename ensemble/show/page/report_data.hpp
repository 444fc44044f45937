#pragma once
// What the page tells, gathered from a campaign file.

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/catalogue.hpp"
#include "findings/design_load.hpp"
#include "findings/extremes.hpp"
#include "findings/levels.hpp"
#include "findings/load_maps.hpp"
#include "findings/pairs.hpp"
#include "findings/points.hpp"
#include "findings/sensitivity.hpp"
#include "laboratory/calibration.hpp"
#include "page/moment.hpp"
#include "theory/hybrid_curve.hpp"

namespace floes {

/// The surge load of one member, thinned to what a picture can show.
struct DrawnHistory {
    int case_index = 0;
    std::vector<std::pair<double, double>> points;  ///< s after the tow began, N
};

/// All that the page tells.
struct ReportData : Evidence {
    std::optional<std::vector<PairRow>> pairs;  ///< where in_detail()
    std::optional<Sensitivity> sensitivity;     ///< of a design
    std::optional<DesignPoints> points;         ///< of a design
    DesignLoadRequest asked;                    ///< of the design loads
    std::vector<CaseDesignLoad> designs;        ///< where in_detail() and the members averaged their load
    std::vector<LevelRow> levels;
    std::vector<std::pair<std::string, Section>> further;  ///< parts with a title for the page, with that title
    std::vector<DrawnHistory> histories;   ///< of the first arrangement that every case has done; empty: none is kept
    std::vector<std::size_t> drawn_cases;  ///< by themselves: at most six that have members done, the most loaded
    std::vector<CaseLoadMap> load_maps;    ///< of these; of files before layout 1.7 none
    std::vector<BreakRow> breaks;
    int largest_member = -1;  ///< the done member with the largest load; -1: none is done
    std::vector<PlanarPose> largest_poses;
    std::vector<CurvePoint> curve;      ///< plate tests of the first case's ice; empty: not measured
    std::optional<HybridCurve> hybrid;  ///< none where the formulas have no load for this structure
    std::string file_name;              ///< of the campaign, as a command names it
    std::vector<Moment> moments;        ///< pictures of worst moments; empty: none were made
    std::string command;                ///< that repeats the campaign
};

/// What the first section of the page needs, of a table without a file: summary, sensitivity, design loads.
ReportData answer_data(Campaign campaign, CampaignTable table);

/// Reads everything but `curve`, `moments` and `command` from the file. Throws InputError as read_campaign_file() does.
ReportData read_report_data(const std::filesystem::path& path);

}  // namespace floes
