#pragma once
// The points of a design without their results: where they lie, and what people call them and the keys of a scenario:
// "ice.thickness_m" is a thickness in m.

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

struct KeyWords {
    std::string name;  ///< "thickness"
    std::string unit;  ///< "m"; empty where the key has none

    /// "thickness, m"
    std::string heading() const { return unit.empty() ? name : name + ", " + unit; }
    /// "thickness 0.02 m"
    std::string with(const std::string& value) const { return name + " " + value + (unit.empty() ? "" : " " + unit); }
};

/// With a capital letter at its beginning.
std::string capital(std::string sentence);

/// `key`: the full path or a case's own key, as "cfm".
KeyWords key_words(std::string_view key);

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

/// Whether pairs and extremes are shown by default: not for a design of many cases. Its axes say more, and the pairs
/// would be too many to read and slow to compute.
bool in_detail(const Campaign& campaign);

}  // namespace floes
