#include "findings/sensitivity_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "findings/key_words.hpp"
#include "findings/load_columns.hpp"
#include "findings/printable.hpp"
#include "tables/number_text.hpp"

namespace floes {

namespace {

constexpr int index_decimals = 2;

bool has_indices(const Sensitivity& found) {
    return std::ranges::any_of(found.rows, [](const SensitivityRow& row) { return row.indices.has_value(); });
}

const char* scale_word(const SensitivityAxis& axis) {
    return axis.scale == AxisScale::log ? "log" : "linear";
}

std::string axis_text(const SensitivityAxis& axis) {
    const KeyWords words = key_words(axis.key);
    return words.with(fmt::format("{:g} to {:g}", axis.from, axis.to)) + (axis.scale == AxisScale::log ? ", log" : "");
}

/// The interval from two arrangements says nothing.
std::string limits_text(const LinearFit& fit, const Slope& slope, double factor, int decimals) {
    if (fit.repetitions > 0 && fit.repetitions < fewest_for_interval) return "–";
    return bracket(factor * slope.low, factor * slope.high, decimals);
}

std::vector<Cell> line(const Sensitivity& found, const SensitivityRow& row, std::size_t axis) {
    const double factor = row.quantity.factor();
    const int decimals = row.fit && !row.quantity.percent ? decimals_for(std::abs(row.fit->centre)) : 1;
    std::vector<Cell> cells{"  " + axis_text(found.axes[axis])};
    if (row.fit) {
        const Slope& slope = row.fit->slopes[axis];
        const double over_all = 2 * factor;  // a slope is over half the axis
        cells.emplace_back(fixed(over_all * slope.estimate, decimals),
                           limits_text(*row.fit, slope, over_all, decimals));
    } else {
        cells.emplace_back("–", "");
    }
    if (has_indices(found)) {
        for (const SobolIndex& index : {row.indices->first[axis], row.indices->total[axis]})
            cells.emplace_back(fixed(index.estimate, index_decimals),
                               bracket(index.interval.low, index.interval.high, index_decimals));
    }
    return cells;
}

std::string heading_of(const SensitivityRow& row) {
    std::string text = row.base.empty() ? "" : row.base + ": ";
    text += row.quantity.label.view();
    if (row.fit) text += fmt::format(" (R² {})", fixed(row.fit->r_squared, index_decimals));
    return text;
}

/// The slope and the indices of one axis. `axis_of` and `row_of` find them in the record's source.
template <class Row>
void add_axis(const std::string& place, const std::function<const SensitivityRow&(const Row&)>& row_of,
              const std::function<std::size_t(const Row&)>& axis_of, std::vector<DataColumn<Row>>& columns) {
    const auto add = [&](std::string csv, const std::string& json, auto value) {
        columns.push_back({Names{std::move(csv), json.empty() ? "" : place + json},
                           [=](const Row& row) { return Datum(value(row_of(row), axis_of(row))); }});
    };
    using Found = const SensitivityRow&;
    const auto of_fit = [&](const std::string& csv, const std::string& json, auto value) {
        add(csv, json, [=](Found row, std::size_t axis) {
            return row.fit ? Datum(value(*row.fit, row.fit->slopes[axis])) : Datum(Absent{});
        });
    };
    const auto of_index = [&](const std::string& name, std::vector<SobolIndex> SobolIndices::*indices) {
        const auto part = [&](const std::string& csv, const std::string& json, auto value) {
            add(csv, json, [=](Found row, std::size_t axis) {
                return row.indices ? Datum(value(((*row.indices).*indices)[axis])) : Datum(Absent{});
            });
        };
        part(name, name + "/estimate", [](const SobolIndex& index) { return index.estimate; });
        part(name + "_low", name + "/low", [](const SobolIndex& index) { return index.interval.low; });
        part(name + "_high", name + "/high", [](const SobolIndex& index) { return index.interval.high; });
    };
    add("", "slope", [](Found row, std::size_t) { return row.fit ? Datum(Absent{}) : Datum(Undefined{}); });
    of_fit("slope", "slope/estimate", [](const LinearFit&, const Slope& slope) { return slope.estimate; });
    of_fit("slope_low", "slope/low", [](const LinearFit&, const Slope& slope) { return slope.low; });
    of_fit("slope_high", "slope/high", [](const LinearFit&, const Slope& slope) { return slope.high; });
    of_fit("change", "change/estimate", [](const LinearFit&, const Slope& slope) { return 2 * slope.estimate; });
    of_fit("change_low", "change/low", [](const LinearFit&, const Slope& slope) { return 2 * slope.low; });
    of_fit("change_high", "change/high", [](const LinearFit&, const Slope& slope) { return 2 * slope.high; });
    of_fit("r_squared", "", [](const LinearFit& fit, const Slope&) { return fit.r_squared; });
    of_fit("arrangements_fitted", "", [](const LinearFit& fit, const Slope&) { return fit.repetitions; });
    add("base_points", "",
        [](Found row, std::size_t) { return row.indices ? Datum(row.base_points) : Datum(Absent{}); });
    of_index("first_order", &SobolIndices::first);
    of_index("total", &SobolIndices::total);
}

DataRows row_records(const Sensitivity& found) {
    using Row = const SensitivityRow&;
    const auto of_fit = [](auto value) {
        return [value](Row row) { return row.fit ? Datum(value(*row.fit)) : Datum(Undefined{}); };
    };
    std::vector<DataColumn<SensitivityRow>> columns{
        {"base", &SensitivityRow::base},
        {"quantity", [](Row row) { return row.quantity.name.view(); }},
        {"points", &SensitivityRow::points},
        {"base_points", [](Row row) { return row.indices ? Datum(row.base_points) : Datum(Absent{}); }},
        {"centre", of_fit([](const LinearFit& fit) { return fit.centre; })},
        {"r_squared", of_fit([](const LinearFit& fit) { return fit.r_squared; })},
        {"arrangements_fitted", of_fit([](const LinearFit& fit) { return fit.repetitions; })}};
    for (std::size_t k = 0; k < found.axes.size(); ++k) {
        const std::string place = fmt::format("axes/{}/", k);
        columns.push_back({place + "key", [&found, k](Row) { return found.axes[k].key; }});
        add_axis<SensitivityRow>(
            place, [](Row row) -> Row { return row; }, [k](Row) { return k; }, columns);
    }
    return json_only(make_rows<SensitivityRow>("sensitivity/rows", found.rows, columns));
}

DataRows axis_records(const Sensitivity& found) {
    struct Line {
        const SensitivityRow* row;
        const SensitivityAxis* axis;
    };
    std::vector<Line> lines;
    for (const SensitivityRow& row : found.rows)
        for (const SensitivityAxis& axis : found.axes) lines.push_back({&row, &axis});
    std::vector<DataColumn<Line>> columns{{"base", [](const Line& line) { return line.row->base; }},
                                          {"quantity", [](const Line& line) { return line.row->quantity.name.view(); }},
                                          {"axis", [](const Line& line) { return line.axis->key; }},
                                          {"from", [](const Line& line) { return line.axis->from; }},
                                          {"to", [](const Line& line) { return line.axis->to; }},
                                          {"scale", [](const Line& line) { return scale_word(*line.axis); }},
                                          {"points", [](const Line& line) { return line.row->points; }}};
    add_axis<Line>(
        "", [](const Line& line) -> const SensitivityRow& { return *line.row; },
        [&](const Line& line) { return static_cast<std::size_t>(line.axis - found.axes.data()); }, columns);
    return csv_only(make_rows<Line>("", lines, columns));
}

/// Of changes and indices by [[case]], quantity and axis.
Table sensitivity_heading(const Sensitivity& found) {
    Table table{{"from one end to the other", {"change", "95 %"}}};
    if (has_indices(found)) {
        table.front().emplace_back("first order", "95 %");
        table.front().emplace_back("total", "95 %");
    }
    return table;
}

/// Of the quantities that are asked for first, or of the others.
void add_rows(const Sensitivity& found, bool headlines, const std::vector<Cell>& heading, Table& table) {
    for (const SensitivityRow& row : found.rows) {
        const bool first = row.quantity.shown >= Shown::in_headlines || row.quantity.key.view() == "mean_maximum_1s";
        if (first != headlines) continue;
        table.emplace_back(heading.size(), Cell{"", ""}).front() = heading_of(row);
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) table.push_back(line(found, row, axis));
    }
}

/// The meaning of the columns, then the notes, as sentences.
std::vector<std::string> sensitivity_notes(const Sensitivity& found) {
    std::vector<std::string> notes;
    if (!found.rows.empty()) {
        const auto fitted =
            std::ranges::find_if(found.rows, [](const SensitivityRow& row) { return row.fit.has_value(); });
        notes.push_back(
            "Change: of the plane fitted to all points, from one end of the axis to the other. (The slopes of --format "
            "csv and json are over half of it, from its middle to its end.)");
        if (fitted != found.rows.end())
            notes.push_back(fitted->fit->repetitions > 0
                                ? fmt::format("Its interval: Student's t over {} arrangements, each fitted separately.",
                                              fitted->fit->repetitions)
                                : std::string{"Its interval: from the residuals, since no two arrangements have every "
                                              "point."});
        if (has_indices(found))
            notes.push_back(fmt::format(
                "First order: share of the variance that the axis explains alone; total: including interactions. "
                "Intervals: bootstrap over {} base points.",
                found.rows.front().base_points));
    }
    for (const std::string& note : found.notes) notes.push_back(note);
    return notes;
}

}  // namespace

std::string change_sentence(const Sensitivity& found, const SensitivityRow& row, std::size_t axis) {
    const Slope& slope = row.fit->slopes[axis];
    const SensitivityAxis& about = found.axes[axis];
    const KeyWords words = key_words(about.key);
    std::string name = words.name;
    if (row.base.empty() && name.front() >= 'a' && name.front() <= 'z') name.front() += 'A' - 'a';
    const LoadUnit unit = load_unit(std::abs(row.fit->centre));
    const double factor = 2 * unit.factor;  // a slope is over half the axis
    const int decimals = few_decimals(unit.factor * std::abs(row.fit->centre));
    const bool said = limits_text(*row.fit, slope, factor, decimals).starts_with('[');
    return fmt::format(
        "{}{} from {:g} to {:g}{} changes the mean load by {:+.{}f} {}{}.", row.base.empty() ? "" : row.base + ": ",
        name, about.from, about.to, words.unit.empty() ? "" : " " + words.unit, factor * slope.estimate, decimals,
        unit.name,
        said ? fmt::format(" ({:+.{}f} to {:+.{}f})", factor * slope.low, decimals, factor * slope.high, decimals)
             : "");
}

Section sensitivity_section(const Sensitivity& found) {
    Section section{.title = "What decides the load",
                    .notes = sensitivity_notes(found),
                    .records = {json_only(make_rows<SensitivityAxis>(
                                    "sensitivity/axes", found.axes,
                                    {{"key", &SensitivityAxis::key},
                                     {"from", &SensitivityAxis::from},
                                     {"to", &SensitivityAxis::to},
                                     {"scale", [](const SensitivityAxis& axis) { return scale_word(axis); }}})),
                                row_records(found), axis_records(found), make_list("sensitivity/notes", found.notes)}};
    if (found.rows.empty()) return section;
    section.table = sensitivity_heading(found);
    add_rows(found, false, section.table.front(), section.folded);
    add_rows(found, true, Table(section.table).front(), section.table);
    return section;
}

}  // namespace floes
