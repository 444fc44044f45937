#pragma once
// What decides the load: how strongly the statistics of a case depend on the axes of the campaign's design.

#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/summary.hpp"
#include "inference/linear_fit.hpp"
#include "inference/sobol_indices.hpp"

namespace floes {

/// Sensitivity of one quantity of one [[case]] that was run at the points of the design.
struct SensitivityRow {
    Quantity quantity{};
    std::string base;                     ///< name of the [[case]]; empty if there is none
    int points = 0;                       ///< with a done member
    int base_points = 0;                  ///< complete base points, used for the indices
    std::optional<SobolIndices> indices;  ///< of the means over arrangements; only for Saltelli's points
    std::optional<LinearFit> fit;         ///< slopes in the unit of the quantity, per half axis
};

/// An axis with its ends, coordinates -1 and 1.
struct SensitivityAxis {
    std::string key;
    double from = 0;  ///< in the key's unit
    double to = 0;
    AxisScale scale = AxisScale::linear;
};

struct Sensitivity {
    std::vector<SensitivityAxis> axes;
    std::vector<SensitivityRow> rows;  ///< by [[case]], then by quantity
    std::vector<std::string> notes;    ///< sentences on what could not be computed, and why
};

/// Indices and planes for mean, SD, mean maximum and failure ratio. If at least two arrangements have every point, each
/// is fitted separately and the slopes are averaged; otherwise the plane is fitted to the means of the points. A member
/// that is not done excludes its arrangement from the separate fits and its base point from the indices. `table`: of
/// that campaign.
Sensitivity find_sensitivity(const Campaign& campaign, const CampaignTable& table);

/// Whether pairs and extremes are shown by default: not for a design of many cases. Its axes say more, and the pairs
/// would be too many to read and slow to compute.
bool in_detail(const Campaign& campaign);

}  // namespace floes
