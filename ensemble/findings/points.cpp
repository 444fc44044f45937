#include "findings/points.hpp"

#include "findings/columns.hpp"
#include "findings/figures.hpp"
#include "findings/json.hpp"
#include "keys/key.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

std::variant<double, std::string> value_of(const Case& one, const DesignAxis& axis) {
    if (axis.numeric) return numeric_value(one, axis.key);
    Scenario scenario = one.scenario;
    const Keys keys = describe(scenario);
    const std::string text = literal(*find_key(keys, axis.key));
    return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

/// "0.03", "open".
std::string value_text(const std::variant<double, std::string>& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(value);
}

}  // namespace

DesignPoints find_points(const Campaign& campaign) {
    DesignPoints points;
    if (!campaign.design.active()) return points;
    for (const DesignAxis& axis : campaign.design.axes) points.keys.push_back(axis.key);
    for (const Case& one : campaign.cases) {
        PointRow& row = points.rows.emplace_back(PointRow{one.name, one.base, one.point, {}});
        for (const DesignAxis& axis : campaign.design.axes) row.values.push_back(value_of(one, axis));
    }
    return points;
}

std::vector<std::vector<std::string>> points_lines(const DesignPoints& points) {
    std::vector<std::vector<std::string>> lines{{"case"}};
    for (const std::string& key : points.keys) lines.front().push_back(key);
    for (const PointRow& row : points.rows) {
        lines.push_back({row.name});
        for (const auto& value : row.values) lines.back().push_back(value_text(value));
    }
    return lines;
}

std::string points_table(const DesignPoints& points, int width) {
    if (points.keys.empty()) return "The campaign has no design: its cases lie on no axes.\n";
    return "Points of the design\n\n" + columns(points_lines(points), width);
}

std::string points_csv(const DesignPoints& points, const Summary& summary) {
    std::string text = "case,base,point";
    for (const std::string& key : points.keys) text += "," + key;
    text += ",done";
    for (const Quantity& quantity : quantities) text += fmt::format(",{}", quantity.key);
    text += "\n";
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const PointRow& row = points.rows[k];
        text += fmt::format("{},{},{}", row.name, row.base, row.point);
        for (const auto& value : row.values) text += "," + csv_text(value_text(value));
        text += fmt::format(",{}", summary.cases.at(k).done);
        for (const Quantity& quantity : quantities)
            text += "," + csv_number((summary.cases.at(k).*quantity.interval).estimate);
        text += "\n";
    }
    return text;
}

Json points_as_json(const DesignPoints& points) {
    Json rows = Json::array();
    for (const PointRow& row : points.rows) {
        Json values = Json::array();
        for (const auto& value : row.values) std::visit([&values](const auto& one) { values.push_back(one); }, value);
        rows.push_back({{"case", row.name}, {"base", row.base}, {"point", row.point}, {"values", values}});
    }
    return {{"axes", points.keys}, {"points", rows}};
}

}  // namespace floes
