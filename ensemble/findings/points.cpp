#include "findings/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "findings/cases.hpp"
#include "findings/estimates.hpp"
#include "findings/evidence.hpp"
#include "keys/key.hpp"
#include "scenario/keys.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {
namespace {

std::variant<double, std::string> value_of(const Case& of_case, const DesignAxis& axis) {
    if (axis.numeric) return numeric_value(of_case, axis.key);
    Scenario scenario = of_case.scenario;
    const Keys keys = describe(scenario);
    const std::string text = literal(*find_key(keys, axis.key));
    return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

Results point_results(const DesignPoints& points, const Summary& summary) {
    Results results{.place = "design/points", .columns = {{"case", "case"}, {"base"}, {"point"}}};
    const std::vector<KeyWords> words = axis_words(points);
    for (std::size_t axis = 0; axis < words.size(); ++axis)
        results.columns.push_back({.key = points.keys[axis], .words = words[axis].heading(), .digits = 4});
    results.columns.push_back({"done", "n"});
    const std::vector<LoadColumn> loads = load_columns(summary);
    for (const LoadColumn& load : loads) results.columns.push_back(estimates("", load.words, unit_of(load.quantity)));
    for (const Quantity& quantity : shown_in(summary.quantities, Shown::in_summary))
        results.columns.push_back({std::string{quantity.key.view()}});
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const PointRow& point = points.rows[k];
        const CaseSummary& found = summary.cases.at(k);
        std::vector<Datum> row{point.name, point.base, point.point};
        for (const auto& value : point.values)
            row.push_back(std::visit([](const auto& known) { return Datum(known); }, value));
        row.emplace_back(found.done);
        for (const LoadColumn& load : loads)
            row.emplace_back(estimate(found.of(load.quantity), found.done, kind_of(load.quantity)));
        for (const Quantity& quantity : shown_in(summary.quantities, Shown::in_summary))
            row.emplace_back(found.of(quantity).estimate);
        results.add(std::move(row));
    }
    return results;
}

constexpr std::size_t most_lines = 6;    // of one figure, as many as there are colours
constexpr std::size_t most_values = 12;  // of an axis whose points make a chequer-board

/// An axis of the design with the places of the points on it.
struct PointAxis {
    std::string name;
    std::string heading;
    bool logarithmic;
    std::vector<double> values;  ///< of each point; empty: the axis has words

    /// Each value once, in order.
    std::vector<double> distinct() const {
        std::vector<double> sorted = values;
        std::ranges::sort(sorted);
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        return sorted;
    }

    /// Around the points' values, on the scale of the design.
    Axis around() const {
        if (!logarithmic) return axis_around(heading, values, false);
        std::vector<double> logarithms;
        for (const double value : values) logarithms.push_back(std::log(value));
        const Axis axis = axis_around(heading, logarithms, false);
        return {.label = heading, .low = std::exp(axis.low), .high = std::exp(axis.high), .logarithmic = true};
    }
};

PointAxis axis_of(const DesignPoints& points, std::size_t axis) {
    const KeyWords words = axis_words(points)[axis];
    PointAxis found{words.name, words.heading(), points.scales[axis] == AxisScale::log, {}};
    for (const PointRow& row : points.rows)
        if (const auto* number = std::get_if<double>(&row.values[axis])) found.values.push_back(*number);
    if (found.values.size() < points.rows.size()) found.values.clear();
    return found;
}

/// The load of each point.
struct PointLoads {
    std::string words;  ///< "mean load"
    std::string unit;
    std::vector<Estimate> values;

    /// With room for the values and the limits that say something.
    Axis axis() const {
        std::vector<double> extent;
        for (const Estimate& load : values) {
            extent.push_back(load.value);
            if (load.said) extent.insert(extent.end(), {load.low, load.high});
        }
        return axis_around(words, extent, true, unit);
    }
};

/// What tells the points of one line from those of another: the [[case]] and the values of the other axes. None where
/// there are more lines than can be told apart.
std::vector<std::string> lines_of(const DesignPoints& points, std::size_t axis) {
    const std::vector<KeyWords> words = axis_words(points);
    std::vector<std::string> lines;
    for (const PointRow& row : points.rows) {
        std::string& line = lines.emplace_back(row.base);
        for (std::size_t k = 0; k < words.size(); ++k)
            if (k != axis) line += (line.empty() ? "" : ", ") + words[k].with(value_text(row.values[k]));
    }
    const std::size_t different = std::set(lines.begin(), lines.end()).size();
    return different > most_lines || different == lines.size() ? std::vector<std::string>{} : lines;
}

/// A little to one side, so that the intervals of several lines do not cover each other.
double beside(const Axis& axis, double value, std::size_t line, std::size_t lines) {
    const double share = 0.006 * (static_cast<double>(line) - 0.5 * static_cast<double>(lines - 1));
    return axis.logarithmic ? value * std::pow(axis.high / axis.low, share) : value + share * (axis.high - axis.low);
}

Figure over_axis(const DesignPoints& points, std::size_t number, const PointLoads& loads) {
    const PointAxis axis = axis_of(points, number);
    Figure figure{.description = fmt::format("Mean load over {}", axis.name),
                  .x = axis.around(),
                  .y = loads.axis(),
                  .size = {720, 300},
                  .caption = fmt::format("Mean load over {}: a dot for each point of the design, with its 95 % "
                                         "interval over arrangements where it says something.",
                                         axis.name)};
    const std::vector<std::string> line_of = lines_of(points, number);
    std::vector<std::string> lines;  // each once
    for (const std::string& line : line_of)
        if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
    std::vector<std::map<double, double>> drawn(std::max<std::size_t>(1, lines.size()));
    for (std::size_t k = 0; k < loads.values.size(); ++k) {
        const auto place = line_of.empty() ? lines.begin() : std::ranges::find(lines, line_of[k]);
        const auto line = static_cast<std::size_t>(place - lines.begin());
        const Estimate& load = loads.values[k];
        const double at = beside(figure.x, axis.values[k], line, drawn.size());
        if (load.said) figure.line({{at, load.low}, {at, load.high}}, colour(line) + " thin");
        figure.dot(at, load.value, colour(line));
        drawn[line][axis.values[k]] = load.value;
    }
    for (std::size_t line = 0; line < lines.size(); ++line) {
        figure.line({drawn[line].begin(), drawn[line].end()}, colour(line));
        if (lines.size() > 1) figure.legend.emplace_back(colour(line), lines[line]);
    }
    return figure;
}

/// A row for each word of an axis that has no numbers, the first at the top.
Figure over_words(const DesignPoints& points, std::size_t axis, const PointLoads& loads) {
    std::vector<std::string> words;
    for (const PointRow& row : points.rows)
        if (std::ranges::find(words, value_text(row.values[axis])) == words.end())
            words.push_back(value_text(row.values[axis]));
    std::ranges::reverse(words);
    const std::string name = axis_words(points)[axis].name;
    const double count = static_cast<double>(words.size());
    Figure figure{.description = fmt::format("Mean load for each {}", name),
                  .x = loads.axis(),
                  .y = {"", 0, count, false, words},
                  .size = {720, 90 + 40 * count},
                  .caption = fmt::format("Mean load for each {}: a dot for each point of the design.", name)};
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const auto at = std::ranges::find(words, value_text(points.rows[k].values[axis])) - words.begin();
        figure.dot(loads.values[k].value, static_cast<double>(at) + 0.5, "c0");
    }
    return figure;
}

/// The difference of the load from one end of the axis to the other, by least squares.
double effect(const PointAxis& axis, const PointLoads& loads) {
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < loads.values.size(); ++k) {
        const double x = axis.logarithmic ? std::log(axis.values[k]) : axis.values[k];
        const double y = loads.values[k].value;
        if (!std::isfinite(y)) continue;
        n += 1, sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y;
        low = std::min(low, x), high = std::max(high, x);
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    return spread > 0 ? std::abs((n * sum_xy - sum_x * sum_y) / spread * (high - low)) : 0;
}

/// Values at which a board has its fields; with too many of them, or one alone, each point is a small field.
std::vector<double> fields(const PointAxis& axis) {
    std::vector<double> values = axis.distinct();
    return values.size() >= 2 && values.size() <= most_values ? values : std::vector<double>{};
}

/// Where the field of a value begins and ends: on a board halfway to its neighbours, and as far beyond the outer ones.
std::pair<double, double> field_of(const std::vector<double>& values, const Axis& axis, double value) {
    const auto on = [&](double place) { return axis.logarithmic ? std::log(place) : place; };
    const auto off = [&](double place) { return axis.logarithmic ? std::exp(place) : place; };
    double below = 0.04 * (on(axis.high) - on(axis.low));
    double above = below;
    if (!values.empty()) {
        const auto k = static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
        below = 0.98 * (k > 0 ? on(values[k]) - on(values[k - 1]) : on(values[k + 1]) - on(values[k]));
        above = k + 1 < values.size() ? 0.98 * (on(values[k + 1]) - on(values[k])) : below;
    }
    return {off(on(value) - below / 2), off(on(value) + above / 2)};
}

/// Loads of the points that lie on one place of both axes.
std::map<std::pair<double, double>, std::vector<double>> loads_by_place(const PointAxis& across, const PointAxis& up,
                                                                        const PointLoads& loads) {
    std::map<std::pair<double, double>, std::vector<double>> places;
    for (std::size_t k = 0; k < loads.values.size(); ++k) {
        std::vector<double>& known = places[{across.values[k], up.values[k]}];
        if (std::isfinite(loads.values[k].value)) known.push_back(loads.values[k].value);
    }
    return places;
}

Figure map_of(const PointAxis& across, const PointAxis& up, const PointLoads& loads, const Units& units) {
    Figure figure{.description = fmt::format("Mean load over {} and {}", across.name, up.name),
                  .x = across.around(),
                  .y = up.around(),
                  .size = {720, 420}};
    const auto places = loads_by_place(across, up, loads);
    std::vector<double> columns = fields(across);
    std::vector<double> rows = fields(up);
    if (columns.size() * rows.size() != places.size()) columns = rows = {};  // it is no board
    double largest = 0;
    bool averaged = false;
    std::vector<Figure::Cell> cells;
    for (const auto& [place, values] : places) {
        if (values.empty()) continue;
        averaged = averaged || values.size() > 1;
        const auto [left, right] = field_of(columns, figure.x, place.first);
        const auto [low, high] = field_of(rows, figure.y, place.second);
        cells.push_back({left, low, right - left, high - low, mean_of(values), "heat"});
        largest = std::max(largest, cells.back().share);
    }
    for (const Figure::Cell& cell : cells) {
        figure.x.low = std::min(figure.x.low, cell.x), figure.x.high = std::max(figure.x.high, cell.x + cell.width);
        figure.y.low = std::min(figure.y.low, cell.y), figure.y.high = std::max(figure.y.high, cell.y + cell.height);
        figure.cell(cell.x, cell.y, cell.width, cell.height, largest > 0 ? 0.85 * cell.share / largest : 0, "heat");
    }
    if (!columns.empty())
        for (const auto& [place, values] : places)
            if (!values.empty())
                figure.text(place.first, place.second, units.number(mean_of(values), loads.unit), "middle", "key");
    figure.heat_scale = fmt::format("up to {}: {}", units.text(largest, loads.unit), loads.words);
    figure.caption = fmt::format("Mean load over {} and {}{}.", across.name, up.name,
                                 averaged ? ", a mean over the other axes and cases" : "");
    return figure;
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
    for (const Case& of_case : campaign.cases) {
        PointRow& row = points.rows.emplace_back(PointRow{of_case.name, of_case.base, of_case.point, {}});
        for (const DesignAxis& axis : campaign.design.axes) row.values.push_back(value_of(of_case, axis));
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

Section points_section(const Evidence& evidence) {
    const DesignPoints points = find_points(evidence.campaign);
    Results axes{.place = "design/axes", .columns = program_columns("key"), .in_csv = false};
    for (const std::string& key : points.keys) axes.add({key});
    Section section{.results = {std::move(axes), point_results(points, evidence.summary)}};
    if (points.keys.empty()) {
        section.before = "The campaign has no design: its cases lie on no axes.\n";
        return section;
    }
    section.title = "Points of the design";
    section.after = "\n" + load_columns_text(evidence.summary) + "\n";
    section.figures = point_figures(evidence);
    return section;
}

std::vector<Figure> point_figures(const Evidence& evidence) {
    const DesignPoints points = find_points(evidence.campaign);
    const Summary& summary = evidence.summary;
    const LoadColumn column = load_columns(summary).front();
    PointLoads loads{column.words, unit_of(column.quantity), {}};
    for (const CaseSummary& row : summary.cases)
        loads.values.push_back(estimate(row.of(column.quantity), row.done, kind_of(column.quantity)));
    if (std::ranges::none_of(summary.cases, [](const CaseSummary& row) { return row.done > 0; })) return {};
    std::vector<Figure> figures;
    std::vector<PointAxis> axes;  // of numbers that differ
    for (std::size_t k = 0; k < points.keys.size(); ++k) {
        PointAxis axis = axis_of(points, k);
        if (!axis.values.empty() && axis.distinct().size() < 2) continue;
        figures.push_back(axis.values.empty() ? over_words(points, k, loads) : over_axis(points, k, loads));
        if (!axis.values.empty()) axes.push_back(std::move(axis));
    }
    if (axes.size() < 2) return figures;
    std::ranges::stable_sort(axes, std::ranges::greater{}, [&](const PointAxis& axis) { return effect(axis, loads); });
    figures.push_back(map_of(axes[0], axes[1], loads, evidence.units));
    return figures;
}

}  // namespace floes
