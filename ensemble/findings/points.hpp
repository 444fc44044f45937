#pragma once
// Where the cases of a design lie, beside what was found there: the table to draw or fit by other means.

#include <string>
#include <variant>
#include <vector>

#include "campaign/campaign.hpp"
#include "findings/summary.hpp"

namespace floes {

struct PointRow {
    std::string name;  ///< of the case
    std::string base;  ///< of the [[case]] that the point was added to; may be empty
    int point = -1;
    std::vector<std::variant<double, std::string>> values;  ///< one an axis, in the key's unit; words as TOML has them
};

struct DesignPoints {
    std::vector<std::string> keys;  ///< of the axes
    std::vector<PointRow> rows;     ///< one a case, in order
};

/// Of a campaign without a design there are no keys and no rows.
DesignPoints find_points(const Campaign& campaign);

/// Case and values.
Table points_table(const DesignPoints& points);

/// The same with, in CSV, the members done and the estimate of each quantity of the summary.
Section points_section(const DesignPoints& points, const Summary& summary);

}  // namespace floes
