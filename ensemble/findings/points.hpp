#pragma once
// Where the cases of a design lie, with the results there: a table for plotting or fitting with other tools.

#include <string>
#include <variant>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/conditions.hpp"
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

}  // namespace floes
