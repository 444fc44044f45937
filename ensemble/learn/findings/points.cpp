#include "findings/points.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "findings/load_columns.hpp"
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

/// Case, values, and the loads there.
Table points_table(const DesignPoints& points, const Summary& summary) {
    const std::vector<LoadColumn> loads = load_columns(summary);
    Table table{{"case"}};
    for (const KeyWords& words : axis_words(points)) table.front().emplace_back(words.heading());
    table.front().emplace_back("n");
    for (const LoadColumn& column : loads) table.front().emplace_back(column.heading());
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const PointRow& row = points.rows[k];
        std::vector<Cell>& line = table.emplace_back(std::vector<Cell>{row.name});
        for (const auto& value : row.values) line.emplace_back(value_text(value));
        line.emplace_back(fmt::format("{}", summary.cases.at(k).done));
        for (const LoadColumn& column : loads) line.emplace_back(column.cell(summary.cases[k]));
    }
    return table;
}

std::vector<DataRows> records_of(const DesignPoints& points, const Summary& summary) {
    using Row = const PointRow&;
    const auto summary_of = [&](Row row) -> const CaseSummary& {
        return summary.cases.at(static_cast<std::size_t>(&row - points.rows.data()));
    };
    std::vector<DataColumn<PointRow>> columns{
        {"case", &PointRow::name}, {"base", &PointRow::base}, {"point", &PointRow::point}};
    for (std::size_t k = 0; k < points.keys.size(); ++k)
        columns.push_back({Names{points.keys[k], fmt::format("values/{}", k)}, [k](Row row) {
                               return std::visit([](const auto& value) { return Datum(value); }, row.values[k]);
                           }});
    columns.push_back({Names{"done", ""}, [=](Row row) { return summary_of(row).done; }});
    for (const Quantity& one : shown_in(summary.quantities, Shown::in_summary))
        columns.push_back(
            {Names{std::string{one.name.view()}, ""}, [=, &one](Row row) { return summary_of(row).of(one).estimate; }});
    return {make_list("design/axes", points.keys), make_rows<PointRow>("design/points", points.rows, columns)};
}

}  // namespace

std::string value_text(const std::variant<double, std::string>& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? fmt::format("{:.4g}", *number) : std::get<std::string>(value);
}

DesignPoints find_points(const Campaign& campaign) {
    DesignPoints points;
    if (!campaign.design.active()) return points;
    for (const DesignAxis& axis : campaign.design.axes) {
        points.keys.push_back(axis.key);
        points.scales.push_back(axis.scale);
    }
    for (const Case& one : campaign.cases) {
        PointRow& row = points.rows.emplace_back(PointRow{one.name, one.base, one.point, {}});
        for (const DesignAxis& axis : campaign.design.axes) row.values.push_back(value_of(one, axis));
    }
    return points;
}

std::vector<KeyWords> axis_words(const DesignPoints& points) {
    std::vector<KeyWords> words;
    for (const std::string& key : points.keys) words.push_back(key_words(key));
    std::vector<KeyWords> told = words;
    for (std::size_t k = 0; k < words.size(); ++k)
        if (std::ranges::count(words, words[k].name, &KeyWords::name) > 1)
            told[k].name = points.keys[k].substr(0, points.keys[k].find('.')) + " " + words[k].name;
    return told;
}

std::vector<std::string> point_labels(const DesignPoints& points) {
    const std::vector<KeyWords> words = axis_words(points);
    std::vector<std::string> labels;
    for (const PointRow& row : points.rows) {
        std::string& label = labels.emplace_back(row.base.empty() ? "" : row.base + ": ");
        for (std::size_t k = 0; k < words.size(); ++k)
            label += (k == 0 ? "" : ", ") + words[k].with(value_text(row.values[k]));
    }
    return labels;
}

Section points_section(const DesignPoints& points, const Summary& summary) {
    Section section{.records = records_of(points, summary)};
    if (points.keys.empty()) {
        section.before = "The campaign has no design: its cases lie on no axes.\n";
        return section;
    }
    section.title = "Points of the design";
    section.table = points_table(points, summary);
    section.after = "\n" + load_columns_text(summary) + "\n";
    section.figures = point_figures(points, summary);
    return section;
}

}  // namespace floes
