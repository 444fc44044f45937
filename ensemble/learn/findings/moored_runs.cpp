// Structures that gave way in the simulation: the line of each case.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "findings/moored_cases.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct MooredRow {
    std::size_t case_index = 0;
    std::size_t runs = 0;
    Interval load, offset, sd_offset, force, largest_force, tension, thrust, at_limit;
    double yaw = 0;     ///< largest of all runs, rad
    double broken = 0;  ///< lines that broke, of all runs
    double velocity_ratio = 0;
};

std::vector<double> values_of(const Evidence& evidence, std::size_t of_case, std::string_view key) {
    std::vector<double> values;
    for (const MemberRow* member : done_members(evidence.table, of_case))
        values.push_back(member->value(*find_quantity(key)));
    return values;
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        if (std::isfinite(value)) sum += value;
    return sum;
}

std::vector<MooredRow> find_rows(const Evidence& evidence) {
    std::vector<MooredRow> rows;
    for (std::size_t index = 0; index < evidence.campaign.cases.size(); ++index) {
        const Scenario& scenario = evidence.campaign.cases[index].scenario;
        if (!scenario.moorings.give_way() || done_members(evidence.table, index).empty()) continue;
        const auto interval = [&](std::string_view key) {
            const std::vector<double> values = values_of(evidence, index, key);
            const bool known = std::ranges::none_of(values, [](double value) { return std::isnan(value); });
            return known ? mean_interval(values)
                         : Interval{nan, nan, nan, nan, nan};  // no lines, no tension; no thrusters, no thrust
        };
        const std::vector<double> yaw = values_of(evidence, index, "largest_yaw");
        double squares = 0;
        const std::vector<double> speeds = values_of(evidence, index, "rms_surge_velocity");
        for (const double speed : speeds) squares += speed * speed;
        rows.push_back(
            {.case_index = index,
             .runs = yaw.size(),
             .load = interval("mean_load"),
             .offset = interval("mean_surge_offset"),
             .sd_offset = interval("sd_surge_offset"),
             .force = interval("mean_surge_mooring"),
             .largest_force = interval("mean_maximum_surge_mooring"),
             .tension = interval("largest_line_tension"),
             .thrust = interval("largest_surge_thrust"),
             .at_limit = interval("thrust_at_limit"),
             .yaw = std::ranges::max(yaw),
             .broken = sum_of(values_of(evidence, index, "broken_lines")),
             .velocity_ratio = std::sqrt(squares / static_cast<double>(speeds.size())) / scenario.structure.speed});
    }
    return rows;
}

Table table_of(const Evidence& evidence, const std::vector<MooredRow>& rows) {
    double largest = 0;
    bool lines = false;
    bool thrusters = false;
    for (const MooredRow& row : rows) {
        largest = std::max({largest, row.load.estimate, row.largest_force.estimate});
        lines = lines || std::isfinite(row.tension.estimate);
        thrusters = thrusters || std::isfinite(row.thrust.estimate);
    }
    const LoadUnit unit = load_unit(largest);
    const int decimals = decimals_for(unit.factor * largest);
    Table table{{"gives way", "runs"}};
    const auto head = [&](const std::string& words) { table.front().emplace_back(words, "95 %"); };
    head(fmt::format("mean load, {}", unit.name));
    head("mean offset, m");
    head("SD of offset, m");
    head(fmt::format("largest mooring force of a segment, {}", unit.name));
    table.front().emplace_back("largest yaw, °");
    table.front().emplace_back("rms velocity / drift");
    if (lines) head(fmt::format("largest tension of a line, {}", unit.name));
    if (lines) table.front().emplace_back("lines broken");
    if (thrusters) head(fmt::format("largest thrust in surge, {}", unit.name));
    if (thrusters) head("time at the limit of thrust, %");
    for (const MooredRow& row : rows) {
        std::vector<Cell>& line = table.emplace_back();
        const auto add = [&](const Interval& value, double factor, int digits) {
            const bool said = says_something(value.estimate, {value.low, value.high}, static_cast<int>(row.runs));
            line.emplace_back(std::isfinite(value.estimate) ? fixed(factor * value.estimate, digits) : "–",
                              said ? bracket(factor * value.low, factor * value.high, digits) : "–");
        };
        line.emplace_back(evidence.summary.label_of(row.case_index));
        line.emplace_back(fmt::format("{}", row.runs));
        add(row.load, unit.factor, decimals);
        add(row.offset, 1, decimals_for(row.offset.estimate));
        add(row.sd_offset, 1, decimals_for(row.offset.estimate));
        add(row.largest_force, unit.factor, decimals);
        line.emplace_back(fixed(row.yaw / unit::degree, 1));
        line.emplace_back(fixed(row.velocity_ratio, 3));
        if (lines) add(row.tension, unit.factor, decimals);
        if (lines) line.emplace_back(fmt::format("{:g}", row.broken));
        if (!thrusters) continue;
        add(row.thrust, unit.factor, decimals);
        add(row.at_limit, 100, 1);
    }
    return table;
}

}  // namespace

std::optional<Section> moored_runs_section(const Evidence& evidence) {
    const std::vector<MooredRow> rows = find_rows(evidence);
    if (rows.empty()) return {};
    std::vector<DataColumn<MooredRow>> columns{
        {"case", [&](const MooredRow& row) { return Datum(evidence.summary.name_of(row.case_index)); }},
        {"runs", [](const MooredRow& row) { return Datum(row.runs); }}};
    const auto add = [&](const std::string& name, const std::string& unit_name, Interval MooredRow::*value) {
        columns.push_back({name + unit_name, [=](const MooredRow& row) { return Datum((row.*value).estimate); }});
        columns.push_back({name + "_low", [=](const MooredRow& row) { return Datum((row.*value).low); }});
        columns.push_back({name + "_high", [=](const MooredRow& row) { return Datum((row.*value).high); }});
    };
    add("mean_load", "_N", &MooredRow::load);
    add("mean_offset", "_m", &MooredRow::offset);
    add("sd_offset", "_m", &MooredRow::sd_offset);
    add("mean_force", "_N", &MooredRow::force);
    add("largest_force", "_N", &MooredRow::largest_force);
    add("largest_tension", "_N", &MooredRow::tension);
    add("largest_thrust", "_N", &MooredRow::thrust);
    add("thrust_at_limit", "_share", &MooredRow::at_limit);
    columns.push_back({"largest_yaw_rad", [](const MooredRow& row) { return Datum(row.yaw); }});
    columns.push_back({"broken_lines", [](const MooredRow& row) { return Datum(row.broken); }});
    columns.push_back({"velocity_ratio", [](const MooredRow& row) { return Datum(row.velocity_ratio); }});
    return Section{
        .title = "Structures that give way in the simulation",
        .table = table_of(evidence, rows),
        .after =
            "\nOffset along the surge load from where the moorings would have the structure, and what springs and "
            "lines bear of that load. Largest of a segment: mean over segments and arrangements; tension: mean "
            "over arrangements of the largest of any line; thrust likewise, and the share of the window in which "
            "thrusters are at a limit in any direction; brackets: 95 % (t). docs/moored.md\n",
        .records = {make_rows<MooredRow>("moored/simulated", rows, columns)}};
}

}  // namespace floes
