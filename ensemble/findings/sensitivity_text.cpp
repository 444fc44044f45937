// What decides the load, as a table, JSON and CSV.

#include "findings/sensitivity_text.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "findings/columns.hpp"
#include "findings/figures.hpp"
#include "findings/json.hpp"

namespace floes {

namespace {

constexpr int index_decimals = 2;

bool has_indices(const Sensitivity& found) {
    return std::ranges::any_of(found.rows, [](const SensitivityRow& row) { return row.indices.has_value(); });
}

std::string axis_text(const SensitivityAxis& axis) {
    return fmt::format("{} {:g} … {:g}{}", axis.key, axis.from, axis.to, axis.scale == AxisScale::log ? ", log" : "");
}

std::vector<std::string> line(const Sensitivity& found, const SensitivityRow& row, std::size_t axis) {
    const bool ratio = quantities[row.quantity].interval == &CaseSummary::failure_ratio;
    const double factor = ratio ? 1 / unit::percent : 1;
    const int decimals = row.fit && !ratio ? decimals_for(std::abs(row.fit->centre)) : 1;
    std::vector<std::string> cells{"  " + axis_text(found.axes[axis]), "–", ""};
    if (row.fit) {
        const Slope& slope = row.fit->slopes[axis];
        cells[1] = fixed(slope.estimate * factor, decimals);
        cells[2] = bracket({slope.low, slope.high}, decimals, factor);
    }
    if (has_indices(found)) {
        for (const SobolIndex& index : {row.indices->first[axis], row.indices->total[axis]}) {
            cells.push_back(fixed(index.estimate, index_decimals));
            cells.push_back(bracket(index.interval, index_decimals));
        }
    }
    return cells;
}

std::string heading_of(const SensitivityRow& row) {
    std::string text = row.base.empty() ? "" : row.base + ": ";
    text += quantities[row.quantity].label;
    if (row.fit) text += fmt::format(" (R² {})", fixed(row.fit->r_squared, index_decimals));
    return text;
}

Json slope_json(const Slope& slope) {
    return json_estimate(slope.estimate, slope.low, slope.high);
}

Json index_json(const SobolIndex& index) {
    return json_estimate(index.estimate, index.interval.low, index.interval.high);
}

Json row_json(const Sensitivity& found, const SensitivityRow& row) {
    Json axes = Json::array();
    for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
        Json one{{"key", found.axes[axis].key}};
        one["slope"] = row.fit ? slope_json(row.fit->slopes[axis]) : Json(nullptr);
        if (row.indices) {
            one["first_order"] = index_json(row.indices->first[axis]);
            one["total"] = index_json(row.indices->total[axis]);
        }
        axes.push_back(std::move(one));
    }
    Json json{{"base", row.base}, {"quantity", quantities[row.quantity].key}, {"points", row.points}};
    if (row.indices) json["base_points"] = row.base_points;
    json["centre"] = row.fit ? json_number(row.fit->centre) : Json(nullptr);
    json["r_squared"] = row.fit ? json_number(row.fit->r_squared) : Json(nullptr);
    json["arrangements_fitted"] = row.fit ? Json(row.fit->repetitions) : Json(nullptr);
    json["axes"] = std::move(axes);
    return json;
}

}  // namespace

std::vector<std::vector<std::string>> sensitivity_lines(const Sensitivity& found) {
    std::vector<std::vector<std::string>> lines{{"along", "slope", "95 %"}};
    if (has_indices(found))
        for (const char* column : {"first order", "95 %", "total", "95 %"}) lines.front().emplace_back(column);
    for (const SensitivityRow& row : found.rows) {
        lines.push_back(std::vector<std::string>(lines.front().size()));
        lines.back().front() = heading_of(row);
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) lines.push_back(line(found, row, axis));
    }
    return lines;
}

std::vector<std::string> sensitivity_notes(const Sensitivity& found) {
    std::vector<std::string> notes;
    if (!found.rows.empty()) {
        const auto fitted =
            std::ranges::find_if(found.rows, [](const SensitivityRow& row) { return row.fit.has_value(); });
        notes.push_back(
            "Slope: change over half the axis, from its middle to its end, of the plane nearest to all points.");
        if (fitted != found.rows.end())
            notes.push_back(fitted->fit->repetitions > 0
                                ? fmt::format("Its interval: Student's t over {} arrangements fitted one by one.",
                                              fitted->fit->repetitions)
                                : std::string{"Its interval: from the residuals, since no two arrangements have every "
                                              "point."});
        if (has_indices(found))
            notes.push_back(fmt::format(
                "First order: share of the variance that the axis explains alone; total: and together with the others. "
                "Intervals: bootstrap over {} base points.",
                found.rows.front().base_points));
    }
    for (const std::string& note : found.notes) notes.push_back(note);
    return notes;
}

std::string sensitivity_table(const Sensitivity& found, int width) {
    std::string text = "What decides the load\n\n";
    if (!found.rows.empty()) text += columns(sensitivity_lines(found), width) + "\n";
    for (const std::string& note : sensitivity_notes(found)) text += note + "\n";
    return text;
}

std::string sensitivity_csv(const Sensitivity& found) {
    std::string text =
        "base,quantity,axis,from,to,scale,points,slope,slope_low,slope_high,r_squared,arrangements_fitted,base_points,"
        "first_order,first_order_low,first_order_high,total,total_low,total_high\n";
    for (const SensitivityRow& row : found.rows) {
        for (std::size_t k = 0; k < found.axes.size(); ++k) {
            const SensitivityAxis& axis = found.axes[k];
            text += fmt::format("{},{},{},{},{},{},{}", row.base, quantities[row.quantity].key, axis.key,
                                csv_number(axis.from), csv_number(axis.to),
                                axis.scale == AxisScale::log ? "log" : "linear", row.points);
            if (row.fit) {
                const Slope& slope = row.fit->slopes[k];
                text += fmt::format(",{},{},{},{},{}", csv_number(slope.estimate), csv_number(slope.low),
                                    csv_number(slope.high), csv_number(row.fit->r_squared), row.fit->repetitions);
            } else {
                text += ",,,,,";
            }
            if (row.indices) {
                text += fmt::format(",{}", row.base_points);
                for (const SobolIndex& index : {row.indices->first[k], row.indices->total[k]})
                    text += fmt::format(",{},{},{}", csv_number(index.estimate), csv_number(index.interval.low),
                                        csv_number(index.interval.high));
            } else {
                text += ",,,,,,,";
            }
            text += "\n";
        }
    }
    return text;
}

Json sensitivity_as_json(const Sensitivity& found) {
    Json axes = Json::array();
    for (const SensitivityAxis& axis : found.axes)
        axes.push_back({{"key", axis.key},
                        {"from", json_number(axis.from)},
                        {"to", json_number(axis.to)},
                        {"scale", axis.scale == AxisScale::log ? "log" : "linear"}});
    Json rows = Json::array();
    for (const SensitivityRow& row : found.rows) rows.push_back(row_json(found, row));
    return {{"axes", axes}, {"rows", rows}, {"notes", found.notes}};
}

}  // namespace floes
