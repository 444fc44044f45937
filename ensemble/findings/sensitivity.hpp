#pragma once
// What decides the load: how far the statistics of a case follow the axes of the campaign's design.

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/summary.hpp"
#include "inference/linear_fit.hpp"
#include "inference/sobol_indices.hpp"

namespace floes {

/// One quantity of one [[case]] that was run at the points of the design.
struct SensitivityRow {
    Quantity quantity{};
    std::string base;                     ///< name of the [[case]]; empty where there is none
    int points = 0;                       ///< with a done member
    int base_points = 0;                  ///< of the indices: those that are whole
    std::optional<SobolIndices> indices;  ///< of the means over arrangements; Saltelli's points alone
    std::optional<LinearFit> fit;         ///< slopes in the unit of the quantity, over half an axis
};

/// An axis with the ends that its coordinate -1 … 1 runs between.
struct SensitivityAxis {
    std::string key;
    double from = 0;  ///< in the key's unit
    double to = 0;
    AxisScale scale = AxisScale::linear;
};

struct Sensitivity {
    std::vector<SensitivityAxis> axes;
    std::vector<SensitivityRow> rows;  ///< by [[case]], then by quantity
    std::vector<std::string> notes;    ///< sentences on what cannot be said, and why
};

/// Indices and planes for mean, SD, mean maximum and failure ratio. Where two arrangements or more have every point,
/// they are fitted one by one, and the slopes are the means over them; otherwise the plane goes through the means of
/// the points. Members that are not done are left out: their arrangement of the first, their base point of the indices.
/// `table`: of that campaign.
Sensitivity find_sensitivity(const Campaign& campaign, const CampaignTable& table);

/// Whether pairs and extremes are shown unasked: not of a design of many cases, whose axes say more, and of which they
/// are too many to read and take long.
bool in_detail(const Campaign& campaign);

}  // namespace floes
