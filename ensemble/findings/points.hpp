#pragma once
// The cases of a design: where they lie, with the results there, for plotting or fitting with other tools, and which of
// its axes decide the load.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/conditions.hpp"
#include "inference/explained_variance.hpp"
#include "member/quantity.hpp"
#include "tables/section.hpp"

namespace floes {

struct Evidence;

struct PointRow {
    std::string name;  ///< of the case
    std::string base;  ///< name of the [[case]] that the point belongs to; may be empty
    int point = -1;
    std::vector<std::variant<double, std::string>> values;  ///< one for each axis, in the key's unit; words as in TOML
};

struct DesignPoints {
    std::vector<std::string> keys;       ///< of the axes
    std::vector<AxisScale> scales = {};  ///< of the axes
    std::vector<PointRow> rows;          ///< one for each case, in order
};

/// An axis of a design with its ends, where the coordinates of points are -1 and 1.
struct RangedAxis {
    std::string key;
    double from = 0;  ///< in the key's unit
    double to = 0;
    AxisScale scale = AxisScale::linear;
    bool whole = false;  ///< the key takes whole numbers only; value() does not round

    /// On the axis's scale, 0 if it has no extent. `value` is in the key's unit, above 0 on a logarithmic axis.
    double coordinate(double value) const;
    /// The inverse.
    double value(double coordinate) const;
};

/// Its ends are from and to, or the least and the greatest value of a grid or list.
RangedAxis ranged_axis(const Campaign& campaign, const DesignAxis& axis);

/// A campaign without a design has no keys and no rows.
DesignPoints find_points(const Campaign& campaign);

/// "0.03", "open": the value as people read it.
std::string value_text(const std::variant<double, std::string>& value);

/// What people call the points: "thickness 0.02 m, speed 0.05 m/s", after the name of the [[case]] if there is one.
/// Empty for a campaign without a design.
std::vector<std::string> point_labels(const DesignPoints& points);

/// Words of each axis; two that would read the same have the names of their tables before them.
std::vector<KeyWords> axis_words(const DesignPoints& points);

/// Where each point lies, its loads with their intervals, and pictures of them: over each axis, and over two. Programs
/// get the number of done members and the estimate of each quantity of the summary.
Section points_section(const Evidence& evidence);

/// The load over each axis, and a map over the two that move it most. None without a result.
std::vector<Figure> point_figures(const Evidence& evidence);

// What decides the load: how strongly the statistics of a case depend on the axes of the campaign's design, and where
// the scatter of single runs comes from: from their arrangements, or from what differs between runs of one.

struct SteadyReport;

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

/// Whether pairs and extremes are shown by default: not for a design of many cases. Its axes say more, and the pairs
/// would be too many to read and slow to compute.
bool in_detail(const Campaign& campaign);

/// The changes and indices with their notes: a record for each quantity and axis.
Section sensitivity_section(const Sensitivity& found);

/// "Thickness from 0.02 to 0.04 m changes the mean load by +5.4 N (+2.1 to +8.7)." Of a row with a fit, for the mean
/// load; the range is left out where it says nothing.
std::string change_sentence(const Sensitivity& found, const SensitivityRow& row, std::size_t axis, const Units& units);

/// Mean load, largest load and broken floes over the largest group of cases that begin from the same arrangements,
/// relative to each case's mean, over the arrangements that every case of the group has done: sd_over_mean, the share
/// of its variance that the arrangement explains, and the share that windows of finite length alone would give (NaN:
/// unknown). `steady` has the effective samples of members with histories; without, the mean load's share of time is
/// unknown. No rows without two cases over three arrangements.
Results find_scatter(const Evidence& evidence, const SteadyReport& steady);

Section scatter_section(Results scatter);

}  // namespace floes
