#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "findings/load_columns.hpp"
#include "findings/points.hpp"
#include "findings/printable.hpp"

namespace floes {
namespace {

constexpr std::size_t most_lines = 6;    // of one figure, as many as there are colours
constexpr std::size_t most_values = 12;  // of an axis whose points make a chequer-board

const double* number(const PointRow& row, std::size_t axis) {
    return std::get_if<double>(&row.values[axis]);
}

bool numeric(const DesignPoints& points, std::size_t axis) {
    return std::ranges::all_of(points.rows, [=](const PointRow& row) { return number(row, axis) != nullptr; });
}

std::vector<double> values_of(const DesignPoints& points, std::size_t axis) {
    std::vector<double> values;
    for (const PointRow& row : points.rows) values.push_back(*number(row, axis));
    return values;
}

std::vector<double> distinct(std::vector<double> values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

bool logarithmic(const DesignPoints& points, std::size_t axis) {
    return points.scales[axis] == AxisScale::log;
}

/// Around the points' values, on the scale of the design.
Axis axis_of(const DesignPoints& points, std::size_t axis) {
    const std::string label = axis_words(points)[axis].heading();
    std::vector<double> values = values_of(points, axis);
    if (!logarithmic(points, axis)) return axis_around(label, values, false);
    for (double& value : values) value = std::log(value);
    Axis around = axis_around(label, values, false);
    return {.label = label, .low = std::exp(around.low), .high = std::exp(around.high), .logarithmic = true};
}

/// What tells the points of one line from those of another: the [[case]] and the values of the other axes.
std::string line_of(const DesignPoints& points, const PointRow& row, std::size_t axis) {
    const std::vector<KeyWords> words = axis_words(points);
    std::string told = row.base;
    for (std::size_t k = 0; k < words.size(); ++k)
        if (k != axis) told += (told.empty() ? "" : ", ") + words[k].with(value_text(row.values[k]));
    return told;
}

/// The number of each point's line in order of appearance; none where there are more than can be told apart.
std::map<std::string, std::size_t> lines_of(const DesignPoints& points, std::size_t axis) {
    std::map<std::string, std::size_t> lines;
    for (const PointRow& row : points.rows) lines.try_emplace(line_of(points, row, axis), lines.size());
    return lines.size() > most_lines || lines.size() == points.rows.size() ? std::map<std::string, std::size_t>{}
                                                                           : lines;
}

void draw_interval(Figure& figure, const LoadColumn& load, const CaseSummary& row, double at, std::size_t line) {
    const Estimate& found = row.of(load.quantity);
    if (says_something(load.quantity, found.estimate, {found.low, found.high}, row.done))
        figure.line({{at, load.factor * found.low}, {at, load.factor * found.high}}, colour(line) + " thin");
    figure.dot(at, load.factor * found.estimate, colour(line));
}

/// A little to one side, so that the intervals of several lines do not cover each other.
double beside(const Axis& axis, double value, std::size_t line, std::size_t lines) {
    const double share = 0.006 * (static_cast<double>(line) - 0.5 * static_cast<double>(lines - 1));
    return axis.logarithmic ? value * std::pow(axis.high / axis.low, share) : value + share * (axis.high - axis.low);
}

/// Estimates and the limits that say something: what a figure has to have room for.
std::vector<double> extent(const Summary& summary, const LoadColumn& load) {
    std::vector<double> values;
    for (const CaseSummary& row : summary.cases) {
        const Estimate& found = row.of(load.quantity);
        values.push_back(load.factor * found.estimate);
        if (says_something(load.quantity, found.estimate, {found.low, found.high}, row.done))
            values.insert(values.end(), {load.factor * found.low, load.factor * found.high});
    }
    return values;
}

Figure over_axis(const DesignPoints& points, const Summary& summary, std::size_t axis, const LoadColumn& load) {
    const std::string name = axis_words(points)[axis].name;
    Figure figure{.description = fmt::format("Mean load over {}", name),
                  .x = axis_of(points, axis),
                  .y = axis_around(load.heading(), extent(summary, load), true),
                  .size = {720, 300},
                  .caption = fmt::format("Mean load over {}: a dot for each point of the design, with its 95 % "
                                         "interval over arrangements where it says something.",
                                         name)};
    const std::map<std::string, std::size_t> lines = lines_of(points, axis);
    std::vector<std::map<double, double>> drawn(std::max<std::size_t>(1, lines.size()));
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const PointRow& row = points.rows[k];
        const std::size_t line = lines.empty() ? 0 : lines.at(line_of(points, row, axis));
        draw_interval(figure, load, summary.cases[k], beside(figure.x, *number(row, axis), line, drawn.size()), line);
        drawn[line][*number(row, axis)] = load.factor * summary.cases[k].of(load.quantity).estimate;
    }
    if (lines.empty()) return figure;
    for (std::size_t line = 0; line < drawn.size(); ++line)
        figure.line({drawn[line].begin(), drawn[line].end()}, colour(line));
    figure.legend.resize(lines.size());
    for (const auto& [told, line] : lines) figure.legend[line] = {colour(line), told};
    if (lines.size() == 1) figure.legend.clear();
    return figure;
}

/// A row for each word of an axis that has no numbers, the first at the top.
Figure over_words(const DesignPoints& points, const Summary& summary, std::size_t axis, const LoadColumn& load) {
    std::vector<std::string> words;
    for (const PointRow& row : points.rows)
        if (std::ranges::find(words, value_text(row.values[axis])) == words.end())
            words.push_back(value_text(row.values[axis]));
    std::ranges::reverse(words);
    const std::string name = axis_words(points)[axis].name;
    const double count = static_cast<double>(words.size());
    Figure figure{.description = fmt::format("Mean load for each {}", name),
                  .x = axis_around(load.heading(), extent(summary, load), true),
                  .y = {"", 0, count, false, words},
                  .size = {720, 90 + 40 * count},
                  .caption = fmt::format("Mean load for each {}: a dot for each point of the design.", name)};
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const auto at = std::ranges::find(words, value_text(points.rows[k].values[axis])) - words.begin();
        figure.dot(load.factor * summary.cases[k].of(load.quantity).estimate, static_cast<double>(at) + 0.5, "c0");
    }
    return figure;
}

/// The difference of the load from one end of the axis to the other, by least squares.
double effect(const DesignPoints& points, const Summary& summary, std::size_t axis, const LoadColumn& load) {
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const double value = *number(points.rows[k], axis);
        const double x = logarithmic(points, axis) ? std::log(value) : value;
        const double y = summary.cases[k].of(load.quantity).estimate;
        if (!std::isfinite(y)) continue;
        n += 1, sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y;
        low = std::min(low, x), high = std::max(high, x);
    }
    const double spread = n * sum_xx - sum_x * sum_x;
    return spread > 0 ? std::abs((n * sum_xy - sum_x * sum_y) / spread * (high - low)) : 0;
}

/// Where a value's cell begins and ends: halfway to its neighbours, and as far beyond the outer ones.
std::pair<double, double> cell_of(const std::vector<double>& values, double value, bool log) {
    const auto on = [=](double one) { return log ? std::log(one) : one; };
    const auto off = [=](double one) { return log ? std::exp(one) : one; };
    const auto k = static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
    const double below = k > 0 ? on(values[k]) - on(values[k - 1]) : on(values[k + 1]) - on(values[k]);
    const double above = k + 1 < values.size() ? on(values[k + 1]) - on(values[k]) : below;
    return {off(on(value) - 0.49 * below), off(on(value) + 0.49 * above)};
}

struct MapCell {
    double x, y;
    double sum = 0;
    int count = 0;
};

/// Means over the points that lie on one place of both axes.
std::vector<MapCell> cells_of(const DesignPoints& points, const Summary& summary, std::size_t across, std::size_t up,
                              const LoadColumn& load) {
    std::map<std::pair<double, double>, MapCell> cells;
    for (std::size_t k = 0; k < points.rows.size(); ++k) {
        const double value = load.factor * summary.cases[k].of(load.quantity).estimate;
        if (!std::isfinite(value)) continue;
        const double x = *number(points.rows[k], across);
        const double y = *number(points.rows[k], up);
        MapCell& cell = cells.try_emplace({x, y}, MapCell{x, y}).first->second;
        cell.sum += value;
        ++cell.count;
    }
    std::vector<MapCell> all;
    for (const auto& [place, cell] : cells) all.push_back(cell);
    return all;
}

/// Values at which a board has its fields; with too many of them, or one alone, each point is a small field.
std::vector<double> fields(const DesignPoints& points, std::size_t axis) {
    std::vector<double> values = distinct(values_of(points, axis));
    return values.size() >= 2 && values.size() <= most_values ? values : std::vector<double>{};
}

std::pair<double, double> field_of(const std::vector<double>& values, const Axis& axis, double value) {
    if (!values.empty()) return cell_of(values, value, axis.logarithmic);
    constexpr double half = 0.02;  // of the axis
    if (!axis.logarithmic) return {value - half * (axis.high - axis.low), value + half * (axis.high - axis.low)};
    const double factor = std::pow(axis.high / axis.low, half);
    return {value / factor, value * factor};
}

/// Different places of points on the two axes.
std::size_t places_of(const DesignPoints& points, std::size_t across, std::size_t up) {
    std::set<std::pair<double, double>> places;
    for (const PointRow& row : points.rows) places.emplace(*number(row, across), *number(row, up));
    return places.size();
}

Figure map_of(const DesignPoints& points, const Summary& summary, std::size_t across, std::size_t up,
              const LoadColumn& load) {
    const std::vector<KeyWords> words = axis_words(points);
    Figure figure{.description = fmt::format("Mean load over {} and {}", words[across].name, words[up].name),
                  .x = axis_of(points, across),
                  .y = axis_of(points, up),
                  .size = {720, 420}};
    const std::vector<MapCell> cells = cells_of(points, summary, across, up, load);
    std::vector<double> columns = fields(points, across);
    std::vector<double> rows = fields(points, up);
    if (columns.size() * rows.size() != places_of(points, across, up)) columns = rows = {};  // it is no board
    double largest = 0;
    bool averaged = false;
    for (const MapCell& cell : cells) {
        largest = std::max(largest, cell.sum / cell.count);
        averaged = averaged || cell.count > 1;
        const auto [left, right] = field_of(columns, figure.x, cell.x);
        const auto [low, high] = field_of(rows, figure.y, cell.y);
        figure.x.low = std::min(figure.x.low, left), figure.x.high = std::max(figure.x.high, right);
        figure.y.low = std::min(figure.y.low, low), figure.y.high = std::max(figure.y.high, high);
    }
    for (const MapCell& cell : cells) {
        const auto [left, right] = field_of(columns, figure.x, cell.x);
        const auto [low, high] = field_of(rows, figure.y, cell.y);
        const double mean = cell.sum / cell.count;
        figure.cell(left, low, right - left, high - low, largest > 0 ? 0.85 * mean / largest : 0, "heat");
        if (!columns.empty() && !rows.empty())
            figure.text(cell.x, cell.y, fmt::format("{:.{}f}", mean, load.decimals), "middle", "key");
    }
    figure.heat_scale = fmt::format("up to {:.{}f}: {}", largest, load.decimals, load.heading());
    figure.caption = fmt::format("Mean load over {} and {}{}.", words[across].name, words[up].name,
                                 averaged ? ", a mean over the other axes and cases" : "");
    return figure;
}

}  // namespace

std::vector<Figure> point_figures(const DesignPoints& points, const Summary& summary) {
    const LoadColumn load = load_columns(summary).front();
    if (std::ranges::none_of(summary.cases, [](const CaseSummary& row) { return row.done > 0; })) return {};
    std::vector<Figure> figures;
    std::vector<std::pair<double, std::size_t>> strongest;
    for (std::size_t axis = 0; axis < points.keys.size(); ++axis) {
        if (!numeric(points, axis)) {
            figures.push_back(over_words(points, summary, axis, load));
            continue;
        }
        if (distinct(values_of(points, axis)).size() < 2) continue;
        figures.push_back(over_axis(points, summary, axis, load));
        strongest.emplace_back(effect(points, summary, axis, load), axis);
    }
    if (strongest.size() < 2) return figures;
    std::ranges::stable_sort(strongest, std::ranges::greater{}, &std::pair<double, std::size_t>::first);
    figures.push_back(map_of(points, summary, strongest[0].second, strongest[1].second, load));
    return figures;
}

}  // namespace floes
