#include "year/contour_section.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/key_words.hpp"
#include "year/year_words.hpp"

namespace floes {
namespace {

constexpr int drawn_points = 180;

/// "0.0290", "0.1 + 3 x^1.5".
std::string parameter_text(const SmoothParameter& parameter) {
    if (parameter.constant()) return fmt::format("{:.4g}", parameter.a);
    const std::string power = fmt::format("{:.4g} x^{:.3g}", parameter.b, parameter.c);
    return parameter.a == 0 ? power : fmt::format("{:.4g} + {}", parameter.a, power);
}

/// "Thickness: Weibull, scale 0.029 m, shape 4.1", without a full stop.
std::string law_text(const InputDistribution& law, const std::string& key) {
    KeyWords words = key_words(key);
    words.name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.name.front())));
    const std::string unit = words.unit.empty() ? "" : " " + words.unit;
    const std::string one = parameter_text(law.first);
    const std::string two = parameter_text(law.second);
    switch (law.law) {
        case InputLaw::normal:
            return fmt::format("{}: normal, mean {}{}, standard deviation {}{}", words.name, one, unit, two, unit);
        case InputLaw::lognormal:
            return fmt::format("{}: log-normal, median {}{}, standard deviation of the logarithm {}", words.name, one,
                               unit, two);
        case InputLaw::weibull:
            return fmt::format("{}: Weibull, scale {}{}, shape {}", words.name, one, unit, two);
        case InputLaw::exponential:
            break;
    }
    return fmt::format("{}: exponential, mean {}{}", words.name, one, unit);
}

/// Both laws, for programs: each parameter is a + b x^c.
DataRows law_records(const ContourInputs& inputs) {
    struct Row {
        std::string key;
        InputDistribution law;
    };
    const std::vector<Row> rows{{inputs.keys[0], inputs.inputs.one}, {inputs.keys[1], inputs.inputs.other}};
    using Parameter = SmoothParameter InputDistribution::*;
    const auto column = [](const char* name, Parameter parameter, double SmoothParameter::*part) {
        return DataColumn<Row>{name, [=](const Row& row) { return Datum(row.law.*parameter.*part); }};
    };
    return json_only(make_rows<Row>("inputs", rows,
                                    {{"key", [](const Row& row) { return Datum(row.key); }},
                                     {"distribution", [](const Row& row) { return Datum(name_of(row.law.law)); }},
                                     column("first/a", &InputDistribution::first, &SmoothParameter::a),
                                     column("first/b", &InputDistribution::first, &SmoothParameter::b),
                                     column("first/c", &InputDistribution::first, &SmoothParameter::c),
                                     column("second/a", &InputDistribution::second, &SmoothParameter::a),
                                     column("second/b", &InputDistribution::second, &SmoothParameter::b),
                                     column("second/c", &InputDistribution::second, &SmoothParameter::c)}));
}

Section ice_section(const ContourInputs& inputs, const ContourRequest& request) {
    const double hours = inputs.time / unit::hour;
    const bool smooth = !inputs.inputs.other.first.constant() || !inputs.inputs.other.second.constant();
    std::string text =
        fmt::format("Ice of {:g} h a year: {:.4g} states of {:g} h.\n{}.\n{}{}.\n", hours, inputs.time / request.state,
                    request.state / unit::hour, law_text(inputs.inputs.one, inputs.keys[0]),
                    law_text(inputs.inputs.other, inputs.keys[1]),
                    smooth ? fmt::format("; x is the {}", key_words(inputs.keys[0]).name) : "");
    if (!inputs.fit) return {.before = std::move(text), .records = {law_records(inputs)}};
    const bool weibull = inputs.inputs.one.law == InputLaw::weibull;
    text += fmt::format(
        "Fitted to the hours of {} classes by maximum likelihood; for the {} {} is likelier than {} (mean "
        "log-likelihood "
        "of an hour: {:.2g} more).{} What lies beyond the classes is what these laws make of it.\n\n",
        inputs.classes.size(), key_words(inputs.keys[0]).name, weibull ? "Weibull" : "log-normal",
        weibull ? "log-normal" : "Weibull", inputs.fit->ahead,
        inputs.fit->scatter_fixed ? " Too few classes tell whether the scatter of the second depends on the first."
                                  : "");
    Table table{{key_words(inputs.keys[0]).heading(), {"h a year"}, {"by the law, h"}}};
    for (const ClassCheck& one : inputs.fit->classes)
        table.push_back(
            {fmt::format("{:g}", one.value), fmt::format("{:.4g}", one.hours), fmt::format("{:.4g}", one.by_law)});
    return {.before = std::move(text), .table = std::move(table), .records = {law_records(inputs)}};
}

struct PointRow {
    const ContourOf* of;
    const ContourPoint* point;
};

Section points_section(const ContourInputs& inputs, const std::vector<ContourOf>& contours) {
    Table table{
        {"exceeded in a year with, at", {key_words(inputs.keys[0]).heading()}, {key_words(inputs.keys[1]).heading()}}};
    std::vector<PointRow> rows;
    for (const ContourOf& one : contours)
        for (const ContourPoint& point : one.points) {
            rows.push_back({&one, &point});
            table.push_back({fmt::format("{}, {:.0f}°", per_year_text(one.per_year), point.degrees),
                             fmt::format("{:.4g}", point.value[0]), fmt::format("{:.4g}", point.value[1])});
        }
    Section made{.title = "Environmental contours (IFORM)", .table = std::move(table)};
    made.records = {
        make_rows<PointRow>("contours", rows,
                            {{"per_year", [](const PointRow& row) { return Datum(row.of->per_year); }},
                             {"radius", [](const PointRow& row) { return Datum(row.of->radius); }},
                             {"angle_deg", [](const PointRow& row) { return Datum(row.point->degrees); }},
                             {inputs.keys[0], [](const PointRow& row) { return Datum(row.point->value[0]); }},
                             {inputs.keys[1], [](const PointRow& row) { return Datum(row.point->value[1]); }}})};
    for (const ContourOf& one : contours)
        made.after += fmt::format("{}{}: radius {:.4g} in standard normal space.", made.after.empty() ? "\n" : " ",
                                  per_year_text(one.per_year), one.radius);
    made.after +=
        "\nRun a short-term case at each point (-o cases.toml --config my.toml), then floes design: the largest over "
        "the "
        "points, at a quantile that makes up for the load's own variability, is the load of that probability a year. "
        "Which quantile does is not known beforehand: docs/year.md.\n";
    return made;
}

}  // namespace

std::vector<ContourOf> find_contours(const ContourInputs& inputs, const ContourRequest& request) {
    std::vector<ContourOf> made;
    const double states = inputs.time / request.state;
    for (const double per_year : request.per_year) {
        const double radius = contour_radius(per_year, states);
        if (!(radius > 0))
            throw InputError(
                fmt::format("{:g} states of {:g} h a year are so few that less than half of them would be beyond what "
                            "{:g} of years exceed; take a smaller probability or shorter states",
                            states, request.state / unit::hour, per_year));
        ContourOf one{per_year, radius, contour(inputs.inputs, radius, request.points),
                      contour(inputs.inputs, radius, drawn_points)};
        for (const std::vector<ContourPoint>* points : {&one.curve, &one.points})
            for (const ContourPoint& point : *points)
                if (!inputs.inputs.other.valid(point.value[0]))
                    throw InputError(fmt::format(
                        "the distribution of {} does not exist where {} is {:.4g}, on the contour of {:g}: its "
                        "parameters are {:.4g} and {:.4g}, and must be above 0",
                        inputs.keys[1], inputs.keys[0], point.value[0], per_year,
                        inputs.inputs.other.first.at(point.value[0]), inputs.inputs.other.second.at(point.value[0])));
        made.push_back(std::move(one));
    }
    return made;
}

std::vector<Section> contour_sections(const ContourInputs& inputs, const ContourRequest& request,
                                      const std::vector<ContourOf>& contours) {
    Section points = points_section(inputs, contours);
    points.figures = {contour_figure(inputs, contours)};
    return {ice_section(inputs, request), std::move(points)};
}

}  // namespace floes
