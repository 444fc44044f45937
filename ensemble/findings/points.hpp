#pragma once
// The results at the points of a design, and what decides the load: how strongly the statistics of a case depend on its
// axes, and where the scatter of single runs comes from: from their arrangements, or from what differs between runs.

#include <optional>
#include <string>
#include <vector>

#include "findings/design_points.hpp"
#include "findings/evidence.hpp"
#include "findings/steady.hpp"
#include "inference/explained_variance.hpp"
#include "tables/section.hpp"

namespace floes {

/// Where each point lies, its loads with their intervals, and pictures of them: over each axis, and over two. Programs
/// get the number of done members and the estimate of each quantity of the summary.
Section points_section(const Evidence& evidence);

/// The load over each axis, and a map over the two that move it most. None without a result.
std::vector<Figure> point_figures(const Evidence& evidence);

/// Sensitivity of one quantity of one [[case]] that was run at the points of the design.
struct SensitivityRow {
    Quantity quantity{};
    std::string base;                     ///< name of the [[case]]; empty if there is none
    int points = 0;                       ///< with a done member
    int base_points = 0;                  ///< complete base points, used for the indices
    std::optional<SobolIndices> indices;  ///< of the means over arrangements; only for Saltelli's points
    std::optional<LinearFit> fit;         ///< slopes in the unit of the quantity, per half axis

    /// What the fitted plane changes from one end of an axis to the other; limits from two arrangements say nothing.
    Estimate change(std::size_t axis) const;
};

struct Sensitivity {
    std::vector<RangedAxis> axes;
    std::vector<SensitivityRow> rows;  ///< by [[case]], then by quantity
    std::vector<std::string> notes;    ///< sentences on what could not be computed, and why
};

/// Indices and planes for mean, SD, mean maximum and failure ratio. If at least two arrangements have every point, each
/// is fitted separately and the slopes are averaged; otherwise the plane is fitted to the means of the points. A member
/// that is not done excludes its arrangement from the separate fits and its base point from the indices.
Sensitivity find_sensitivity(const Evidence& evidence);
/// Found once.
const Sensitivity& sensitivity_of(Evidence& evidence);

/// The changes and indices with their notes: a record for each quantity and axis.
Section sensitivity_section(const Sensitivity& found);

/// "Thickness from 0.02 to 0.04 m changes the mean load by +5.4 N (+2.1 to +8.7).", at most so many, the strongest
/// first; the range is left out where it says nothing.
std::vector<std::string> change_sentences(const Sensitivity& found, const Units& units, std::size_t most);

/// Mean load, largest load and broken floes over the largest group of cases that begin from the same arrangements,
/// relative to each case's mean, over the arrangements that every case of the group has done: sd_over_mean, the share
/// of its variance that the arrangement explains, and the share that windows of finite length alone would give (NaN:
/// unknown). `steady` has the effective samples of members with histories; without, the mean load's share of time is
/// unknown. No rows without two cases over three arrangements.
Results find_scatter(const Evidence& evidence, const SteadyReport& steady);

Section scatter_section(Results scatter);

}  // namespace floes
