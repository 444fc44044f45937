#pragma once
// Where the cases of a design lie, with the results there: a table for plotting or fitting with other tools.

#include <string>
#include <variant>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/summary.hpp"

namespace floes {

struct PointRow {
    std::string name;  ///< of the case
    std::string base;  ///< name of the [[case]] that the point belongs to; may be empty
    int point = -1;
    std::vector<std::variant<double, std::string>> values;  ///< one for each axis, in the key's unit; words as in TOML
};

struct DesignPoints {
    std::vector<std::string> keys;  ///< of the axes
    std::vector<PointRow> rows;     ///< one for each case, in order
};

/// A campaign without a design has no keys and no rows.
DesignPoints find_points(const Campaign& campaign);

/// Case and values.
Table points_table(const DesignPoints& points);

/// The same; CSV also has the number of done members and the estimate of each quantity of the summary.
Section points_section(const DesignPoints& points, const Summary& summary);

}  // namespace floes
