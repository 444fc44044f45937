#include "findings/points.hpp"

#include <fmt/format.h>

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

Table points_table(const DesignPoints& points) {
    Table table{{"case"}};
    for (const std::string& key : points.keys) table.front().emplace_back(key);
    for (const PointRow& row : points.rows) {
        std::vector<Cell>& line = table.emplace_back(std::vector<Cell>{row.name});
        for (const auto& value : row.values) line.emplace_back(value_text(value));
    }
    return table;
}

Section points_section(const DesignPoints& points, const Summary& summary) {
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
    Section section{
        .records = {make_list("design/axes", points.keys), make_rows<PointRow>("design/points", points.rows, columns)}};
    if (points.keys.empty()) {
        section.before = "The campaign has no design: its cases lie on no axes.\n";
    } else {
        section.title = "Points of the design";
        section.table = points_table(points);
    }
    return section;
}

}  // namespace floes
