#include "findings/points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "findings/cases.hpp"
#include "findings/summary.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

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
        for (const LoadColumn& load : loads) row.emplace_back(estimate_of(found, load.quantity));
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
    const auto lines = grouped(line_of.size(), [&](std::size_t k) { return line_of[k]; });
    std::vector<std::map<double, double>> drawn(std::max<std::size_t>(1, lines.size()));
    for (std::size_t k = 0; k < loads.values.size(); ++k) {
        const auto place =
            line_of.empty() ? lines.begin() : std::ranges::find(lines, line_of[k], &decltype(lines)::value_type::first);
        const auto line = static_cast<std::size_t>(place - lines.begin());
        const Estimate& load = loads.values[k];
        const double at = beside(figure.x, axis.values[k], line, drawn.size());
        if (load.said) figure.line({{at, load.low}, {at, load.high}}, colour(line) + " thin");
        figure.dot(at, load.value, colour(line));
        drawn[line][axis.values[k]] = load.value;
    }
    for (std::size_t line = 0; line < lines.size(); ++line) {
        figure.line({drawn[line].begin(), drawn[line].end()}, colour(line));
        if (lines.size() > 1) figure.legend.emplace_back(colour(line), lines[line].first);
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
    for (const CaseSummary& row : summary.cases) loads.values.push_back(estimate_of(row, column.quantity));
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

namespace {

/// Cases in order of their points.
using Points = std::vector<std::size_t>;

/// Of each [[case]], by its name.
std::vector<std::pair<std::string, Points>> by_base(const Campaign& campaign) {
    auto all = grouped(campaign.cases.size(), [&](std::size_t k) { return campaign.cases[k].base; });
    for (auto& [base, points] : all)
        std::ranges::sort(points, {}, [&](std::size_t k) { return campaign.cases[k].point; });
    return all;
}

/// Values of a quantity: a row for each arrangement, a column for each point; NaN where no member is done.
std::vector<std::vector<double>> values_of(const Points& points, const Quantity& quantity, const Sample& sample) {
    const std::size_t cases = sample.cases.size();
    std::vector<std::vector<double>> values(sample.members() / cases);
    for (std::size_t arrangement = 0; arrangement < values.size(); ++arrangement)
        for (const std::size_t k : points)
            values[arrangement].push_back(sample.value(arrangement * cases + k, quantity));
    return values;
}

bool finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// Mean of each point over the arrangements in which it is done; NaN if there is none.
std::vector<double> means_of(const std::vector<std::vector<double>>& values, std::size_t points) {
    std::vector<double> means;
    for (std::size_t p = 0; p < points; ++p) {
        std::vector<double> done;
        for (const std::vector<double>& arrangement : values)
            if (std::isfinite(arrangement[p])) done.push_back(arrangement[p]);
        means.push_back(mean_of(done));
    }
    return means;
}

/// Uses the base points whose points all have a mean. Points are in the order of design_points().
SaltelliValues saltelli_values(const std::vector<double>& means, std::size_t axes) {
    SaltelliValues values;
    values.ab.resize(axes);
    const std::size_t each = axes + 2;
    for (std::size_t first = 0; first + each <= means.size(); first += each) {
        const std::vector<double> base(means.begin() + static_cast<std::ptrdiff_t>(first),
                                       means.begin() + static_cast<std::ptrdiff_t>(first + each));
        if (!finite(base)) continue;
        values.a.push_back(base[0]);
        values.b.push_back(base[1]);
        for (std::size_t axis = 0; axis < axes; ++axis) values.ab[axis].push_back(base[2 + axis]);
    }
    return values;
}

/// Coordinates of the cases, -1 at an axis's beginning and 1 at its end.
PointCoordinates coordinates(const Campaign& campaign, const Points& points, const std::vector<RangedAxis>& axes) {
    PointCoordinates all;
    for (const std::size_t k : points) {
        std::vector<double>& row = all.emplace_back();
        for (const RangedAxis& axis : axes) row.push_back(axis.coordinate(numeric_value(campaign.cases[k], axis.key)));
    }
    return all;
}

std::optional<LinearFit> fit_of(const PointCoordinates& points, const std::vector<std::vector<double>>& values,
                                const std::vector<double>& means) {
    std::vector<std::vector<double>> whole;
    std::ranges::copy_if(values, std::back_inserter(whole), finite);
    if (whole.size() >= 2 && can_fit(points)) return fit_repetitions(points, whole);
    PointCoordinates known;
    std::vector<double> known_means;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!std::isfinite(means[p])) continue;
        known.push_back(points[p]);
        known_means.push_back(means[p]);
    }
    if (!can_fit(known)) return {};
    return fit_points(known, known_means);
}

std::string word_axis(const Design& design) {
    const auto found = std::ranges::find(design.axes, false, &DesignAxis::numeric);
    return found == design.axes.end() ? "" : found->key;
}

/// Whether the quantity is one of those that are asked for first.
bool in_front(const Quantity& quantity) {
    return quantity.shown >= Shown::in_headlines;
}

bool has_indices(const Sensitivity& found) {
    return std::ranges::any_of(found.rows, [](const SensitivityRow& row) { return row.indices.has_value(); });
}

/// A row for each quantity and axis, under the name of its quantity.
Results sensitivity_results(const Sensitivity& found) {
    const bool indices = has_indices(found);
    Results results{.place = "sensitivity/rows",
                    .columns = program_columns("base quantity axis from to scale points centre r_squared "
                                               "arrangements_fitted base_points") +
                               std::vector<ResultColumn>{{.words = "from one end to the other"},
                                                         estimates("slope", ""),
                                                         estimates("change", "change", ""),
                                                         estimates("first_order", indices ? "first order" : "", "1", 2),
                                                         estimates("total", indices ? "total" : "", "1", 2)}};
    const auto interval = [](const Slope& slope) { return Estimate{slope.estimate, slope.low, slope.high}; };
    const auto share = [](const SobolIndex& of) { return Datum(within(of.estimate, of.interval)); };
    for (const SensitivityRow& row : found.rows) {
        const auto whom = in_front(row.quantity) ? Results::For::everybody : Results::For::folded;
        results.add_heading(
            fmt::format("{}{}{}", row.base, row.base.empty() ? "" : ": ", row.quantity.label) +
                (row.fit && std::isfinite(row.fit->r_squared) ? fmt::format(" (R² {:.2f})", row.fit->r_squared) : ""),
            whom, unit_of(row.quantity));
        for (std::size_t k = 0; k < found.axes.size(); ++k) {
            const RangedAxis& axis = found.axes[k];
            const std::string_view scale = axis.scale == AxisScale::log ? "log" : "linear";
            const std::string range = key_words(axis.key).with(fmt::format("{:g} to {:g}", axis.from, axis.to));
            std::vector<Datum> cells{row.base,  row.quantity.key.view(), axis.key, axis.from, axis.to, scale,
                                     row.points};
            if (row.fit)
                cells.insert(cells.end(), {row.fit->centre, row.fit->r_squared, row.fit->repetitions});
            else
                cells.insert(cells.end(), 3, Undefined{});
            cells.emplace_back(row.indices ? Datum(row.base_points) : Datum(Absent{}));
            cells.emplace_back("  " + range + (axis.scale == AxisScale::log ? ", log" : ""));
            cells.emplace_back(row.fit ? Datum(interval(row.fit->slopes[k])) : Datum(Undefined{}));
            cells.emplace_back(row.fit ? Datum(row.change(k)) : Datum(Undefined{}));
            cells.emplace_back(row.indices ? share(row.indices->first[k]) : Datum(Absent{}));
            cells.emplace_back(row.indices ? share(row.indices->total[k]) : Datum(Absent{}));
            results.add(std::move(cells), whom);
        }
    }
    return results;
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
    notes.insert(notes.end(), found.notes.begin(), found.notes.end());
    return notes;
}

/// The cases of the largest group that shares arrangements.
std::vector<std::size_t> largest_group(const Campaign& campaign) {
    const std::vector<int> groups = sharing_groups(campaign);
    std::map<int, std::vector<std::size_t>> cases;
    for (std::size_t k = 0; k < groups.size(); ++k) cases[groups[k]].push_back(k);
    const auto largest = std::ranges::max_element(cases, {}, [](const auto& group) { return group.second.size(); });
    return largest == cases.end() ? std::vector<std::size_t>{} : largest->second;
}

/// Members of each case over the arrangements that all of the cases have done, in the same order.
std::vector<Members> common_members(const Sample& sample, const std::vector<std::size_t>& cases) {
    std::map<int, Members> by_arrangement;
    for (const std::size_t k : cases)
        for (const std::size_t member : sample.done(k)) by_arrangement[sample.arrangement_of(member)].push_back(member);
    std::vector<Members> members(cases.size());
    for (const auto& [arrangement, runs] : by_arrangement)
        if (runs.size() == cases.size())
            for (std::size_t k = 0; k < runs.size(); ++k) members[k].push_back(runs[k]);
    return members;
}

/// The variance of a run's value that its window alone would give, if all that differs between runs went on within
/// them; NaN where nothing says it. `effective`: samples, by member.
double variance_of_time(const Sample& sample, const Quantity& asked, std::size_t member,
                        const std::map<std::size_t, double>& effective) {
    if (asked.key == quantity("mean_load").key) {
        const auto samples = effective.find(member);
        return samples == effective.end() ? std::nan("")
                                          : std::pow(sample.value(member, quantity("sd_load")), 2) / samples->second;
    }
    std::span<const double> maxima = sample.along("members/segment_maximum", member);
    if (const auto place = asked.averaging > 0 ? sample.place_of_time(member, asked.averaging) : std::nullopt)
        maxima = sample.along("averaged/segment_maximum", member, *place);
    if (asked.key == quantity("failure_ratio").key || maxima.size() < 2) return std::nan("");
    const double sd = population_sd(maxima, mean_of(maxima));
    return sd * sd / static_cast<double>(maxima.size() - 1);
}

}  // namespace

Estimate SensitivityRow::change(std::size_t axis) const {
    const Slope& slope = fit->slopes[axis];  // over half the axis
    return {2 * slope.estimate, 2 * slope.low, 2 * slope.high,
            fit->repetitions == 0 || fit->repetitions >= fewest_for_interval};
}

Sensitivity find_sensitivity(const Evidence& evidence) {
    Sensitivity found;
    const Campaign& campaign = evidence.campaign;
    const Design& design = campaign.design;
    if (!design.active()) {
        found.notes.push_back("The campaign has no design: its cases lie on no axes.");
        return found;
    }
    if (const std::string key = word_axis(design); !key.empty()) {
        found.notes.push_back(fmt::format(
            "The axis {} is not numeric; indices and planes need numeric axes. Compare its cases in pairs.", key));
        return found;
    }
    for (const DesignAxis& axis : design.axes) found.axes.push_back(ranged_axis(campaign, axis));
    for (const auto& [base, points] : by_base(campaign)) {
        const PointCoordinates places = coordinates(campaign, points, found.axes);
        bool fitted = false;
        for (const Quantity& quantity : evidence.summary.quantities) {
            if (!quantity.in_designs) continue;
            const auto values = values_of(points, quantity, evidence.sample);
            const std::vector<double> means = means_of(values, points.size());
            SensitivityRow& row = found.rows.emplace_back(SensitivityRow{quantity, base, 0, 0, {}, {}});
            row.points =
                static_cast<int>(std::ranges::count_if(means, [](double mean) { return std::isfinite(mean); }));
            if (design.indices) {
                const SaltelliValues at = saltelli_values(means, found.axes.size());
                row.base_points = static_cast<int>(at.a.size());
                row.indices = sobol_indices(at);
            }
            row.fit = fit_of(places, values, means);
            fitted = fitted || row.fit.has_value();
        }
        if (!fitted)
            found.notes.push_back(fmt::format(
                "{}no plane: it needs more points with a result than axes + 1, and no axis that depends on the others.",
                base.empty() ? "" : base + ": "));
    }
    if (design.indices)
        found.notes.push_back(
            "Indices are computed from means over arrangements. The scatter that remains in these means counts as "
            "interaction and raises the total indices.");
    return found;
}

const Sensitivity& sensitivity_of(Evidence& evidence) {
    return evidence.kept.once([&] { return find_sensitivity(evidence); });
}

Section sensitivity_section(const Sensitivity& found) {
    Results notes{.place = "sensitivity/notes", .columns = program_columns("note"), .in_csv = false};
    for (const std::string& note : found.notes) notes.add({note});
    return {.title = "What decides the load",
            .results = {sensitivity_results(found), std::move(notes)},
            .notes = sensitivity_notes(found)};
}

namespace {

std::string change_sentence(const Sensitivity& found, const SensitivityRow& row, std::size_t axis, const Units& units) {
    const RangedAxis& about = found.axes[axis];
    const KeyWords words = key_words(about.key);
    const std::string name = row.base.empty() ? capital(words.name) : words.name;
    return fmt::format("{}{} from {:g} to {:g}{} changes the mean load by {}.", row.base.empty() ? "" : row.base + ": ",
                       name, about.from, about.to, words.unit.empty() ? "" : " " + words.unit,
                       change_text(row.change(axis), units));
}

}  // namespace

std::vector<std::string> change_sentences(const Sensitivity& found, const Units& units, std::size_t most) {
    struct Change {
        std::string told;
        double size;
    };
    std::vector<Change> changes;
    for (const SensitivityRow& row : found.rows) {
        if (row.quantity.key.view() != "mean_load" || !row.fit) continue;
        for (std::size_t axis = 0; axis < found.axes.size(); ++axis) {
            changes.push_back({change_sentence(found, row, axis, units), std::abs(row.fit->slopes[axis].estimate)});
        }
    }
    std::ranges::stable_sort(changes, std::ranges::greater{}, &Change::size);
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < std::min(changes.size(), most); ++k) sentences.push_back(changes[k].told);
    return sentences;
}

Results find_scatter(const Evidence& evidence, const SteadyReport& steady) {
    Results scatter{.place = "scatter",
                    .columns = {{"quantity", "quantity"},
                                {"cases"},
                                {"arrangements"},
                                {.key = "sd_over_mean", .words = "SD / mean", .unit = "share", .decimals = 1},
                                estimates("arrangement_share", "arrangement", "share", 0),
                                {.key = "time_share", .words = "window", .unit = "share", .decimals = 0}},
                    .in_csv = false};
    const Sample& sample = evidence.sample;
    const std::vector<Members> cases = common_members(sample, largest_group(evidence.campaign));
    if (cases.size() < 2 || cases.front().size() < 3) return scatter;
    std::map<std::size_t, double> effective;
    for (const MemberSteady& member : steady.members)
        effective[static_cast<std::size_t>(member.member)] = member.effective_samples;
    for (const LoadColumn& column : load_columns(evidence.summary)) {
        const Quantity& asked = column.quantity;
        std::vector<std::vector<double>> values;
        double time = 0;
        for (const Members& members : cases) {
            std::vector<double> own = sample.values(members, asked);
            const double mean = mean_of(own);
            for (double& value : own) value /= mean;
            if (!finite(own)) continue;  // as of a case that ice never loads
            for (const std::size_t member : members)
                time += variance_of_time(sample, asked, member, effective) / (mean * mean);
            values.push_back(std::move(own));
        }
        const ArrangementShare found = arrangement_share(values);
        const double runs = static_cast<double>(values.size() * cases.front().size());
        scatter.add({Named{std::string{asked.key.view()}, std::string{asked.label.view()}}, found.cases,
                     found.arrangements, found.sd, within(found.share, found.interval),
                     time / runs / (found.sd * found.sd)});
    }
    return scatter;
}

Section scatter_section(Results scatter) {
    if (scatter.empty())
        return {.before =
                    "Where scatter comes from: unknown; it takes two cases over the same arrangements, three of them "
                    "done.\n",
                .results = {std::move(scatter)}};
    double cases = 0;
    double arrangements = 0;  // of the row that has most: others leave out what a case has not
    for (std::size_t row = 0; row < scatter.rows.size(); ++row) {
        cases = std::max(cases, scatter.number(row, "cases"));
        arrangements = std::max(arrangements, scatter.number(row, "arrangements"));
    }
    return {.title = fmt::format("Where the scatter of single runs comes from, {:g} cases x {:g} arrangements", cases,
                                 arrangements),
            .results = {std::move(scatter)},
            .after =
                "\nArrangement: share of the variance of single runs that cases over the same arrangement have in "
                "common (intraclass correlation; below 0: by chance). The rest differs between runs of one "
                "arrangement: pairing does not take it away. Window: share that runs of this length would have if all "
                "their differences passed within a run (mean load: variance of a step over the effective samples; "
                "maxima: variance of the segments' over their number); near what the arrangement leaves, longer runs "
                "are worth as much as more of them.\n"};
}

}  // namespace floes
