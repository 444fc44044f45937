#include "match/contour_section.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign_keys.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "findings/design_points.hpp"
#include "keys/document.hpp"
#include "keys/key.hpp"
#include "match/regimes.hpp"
#include "match/year.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr std::string_view input_block = "input";

struct LawWords {
    InputLaw law;
    std::vector<std::string> parameters;
};

const std::vector<LawWords>& laws() {
    static const std::vector<LawWords> all{{InputLaw::normal, {"mean", "sd"}},
                                           {InputLaw::lognormal, {"median", "sd_log"}},
                                           {InputLaw::weibull, {"scale", "shape"}},
                                           {InputLaw::exponential, {"mean"}}};
    return all;
}

/// A number, or [a, b, c] for a + b x^c.
SmoothParameter parameter_of(const Entry& entry, bool of_first) {
    const auto refuse = [&] {
        return InputError(fmt::format("{}: {} = {} is not a parameter; give a number{}", entry.where, entry.path,
                                      to_text(entry.value),
                                      of_first ? ", because the first input depends on none"
                                               : ", or [a, b, c] for a + b x^c, x the first input"));
    };
    if (const std::optional<double> number = number_of(entry.value)) return {.a = *number};
    const auto* list = std::get_if<std::vector<Value>>(&entry.value.data);
    if (list == nullptr || list->size() != 3 || of_first) throw refuse();
    std::array<double, 3> numbers{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<double> number = number_of((*list)[k]);
        if (!number) throw refuse();
        numbers[k] = *number;
    }
    return {numbers[0], numbers[1], numbers[2]};
}

void refuse_stranger(const std::string& key, const std::string& where) {
    Scenario scratch;
    const Keys keys = describe(scratch);
    const Key* known = find_key(keys, full_path(key));
    if (known == nullptr)
        throw InputError(fmt::format("{}: {} is not a key of a case that takes a number; did you mean {}?", where, key,
                                     nearest_path(keys, key)));
    if (!std::holds_alternative<NumberField>(known->field))
        throw InputError(
            fmt::format("{}: {} takes whole numbers or words, and a contour is of keys that take any "
                        "number, as ice.thickness_m",
                        where, key));
}

/// The text of an entry that must be there.
std::string words_of(const Block& block, std::string_view path, std::string_view example) {
    const Entry* entry = block.find(path);
    const std::string* words = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value.data);
    if (words == nullptr || words->empty())
        throw InputError(fmt::format("{}: this [[input]] wants {} = \"…\" in quotes, as \"{}\"",
                                     entry == nullptr ? block.where : entry->where, path, example));
    return *words;
}

const LawWords& law_of(const Block& block) {
    const std::string name = words_of(block, "distribution", "weibull");
    const auto found = std::ranges::find(laws(), name, [](const LawWords& one) { return name_of(one.law); });
    if (found != laws().end()) return *found;
    std::vector<std::string_view> names;
    for (const LawWords& one : laws()) names.push_back(name_of(one.law));
    throw InputError(fmt::format("{}: distribution = \"{}\" is not one of {}", block.find("distribution")->where, name,
                                 fmt::join(names, ", ")));
}

InputDistribution distribution_of(const Block& block, bool first) {
    const LawWords& words = law_of(block);
    for (const Entry& entry : block.entries)
        if (entry.path != "key" && entry.path != "distribution" &&
            std::ranges::find(words.parameters, entry.path) == words.parameters.end())
            throw InputError(fmt::format("{}: {} is no key of a {} distribution; it has {}", entry.where, entry.path,
                                         name_of(words.law), fmt::join(words.parameters, " and ")));
    InputDistribution made{.law = words.law, .first = {}, .second = {}};
    for (std::size_t k = 0; k < words.parameters.size(); ++k) {
        const Entry* entry = block.find(words.parameters[k]);
        if (entry == nullptr)
            throw InputError(fmt::format("{}: this [[input]] has no {}; a {} distribution has {}", block.where,
                                         words.parameters[k], name_of(words.law),
                                         fmt::join(words.parameters, " and ")));
        (k == 0 ? made.first : made.second) = parameter_of(*entry, first);
    }
    if (first && !made.valid(0))
        throw InputError(fmt::format(
            "{}: a {} distribution with these parameters does not exist; {} must be above 0", block.where,
            name_of(words.law),
            words.law == InputLaw::normal ? "sd" : fmt::format("{}", fmt::join(words.parameters, " and "))));
    return made;
}

ContourInputs from_distributions(const Document& document, const std::string& file) {
    ContourInputs made;
    double hours = -1;
    for (const Entry& entry : document.entries) {
        if (entry.path != "hours_per_year")
            throw InputError(fmt::format("{}: {} is not known here; above the inputs there is hours_per_year only",
                                         entry.where, entry.path));
        hours = number_of(entry.value).value_or(-1);
        if (!(hours > 0 && hours <= leap_year_hours))
            throw InputError(fmt::format("{}: hours_per_year = {} must be above 0 and at most {:g}", entry.where,
                                         to_text(entry.value), leap_year_hours));
    }
    if (hours < 0)
        throw InputError(
            fmt::format("{}: hours_per_year is missing; say how many hours of a year have this ice", file));
    if (document.blocks.size() != 2)
        throw InputError(fmt::format("{}: a contour is of two inputs, and this text has {} of [[input]]", file,
                                     document.blocks.size()));
    for (const Block& block : document.blocks)
        if (block.path != input_block)
            throw InputError(
                fmt::format("{}: [[{}]] is not a table of inputs; did you mean [[input]]?", block.where, block.path));
    made.time = hours * unit::hour;
    for (std::size_t k = 0; k < 2; ++k) made.keys[k] = words_of(document.blocks[k], "key", "ice.thickness_m");
    for (std::size_t k = 0; k < 2; ++k) refuse_stranger(made.keys[k], document.blocks[k].find("key")->where);
    if (made.keys[0] == made.keys[1])
        throw InputError(
            fmt::format("{}: {} is an input already; a contour is of two", document.blocks[1].where, made.keys[1]));
    made.inputs = {distribution_of(document.blocks[0], true), distribution_of(document.blocks[1], false)};
    return made;
}

ClassHours class_of(const Regime& regime, const std::array<std::string, 2>& keys) {
    ClassHours made{.value = {}, .hours = regime.time / unit::hour};
    for (const Entry& entry : regime.values) {
        const auto place = std::ranges::find(keys, entry.path);
        if (place == keys.end())
            throw InputError(fmt::format("{}: {} is a third input; a contour is of two, here {} and {}", entry.where,
                                         entry.path, keys[0], keys[1]));
        const double value = *number_of(entry.value);
        if (!(value > 0))
            throw InputError(fmt::format(
                "{}: {} = {:g} is not above 0, and the distributions that are fitted are of positive inputs",
                entry.where, entry.path, value));
        made.value[static_cast<std::size_t>(place - keys.begin())] = value;
    }
    for (std::size_t k = 0; k < 2; ++k)
        if (made.value[k] == 0) throw InputError(fmt::format("{}: the regime has no {}", regime.where, keys[k]));
    return made;
}

ContourInputs from_regimes(const std::vector<Regime>& regimes, const std::string& file) {
    ContourInputs made;
    const Regime& first = regimes.front();
    if (first.values.size() != 2)
        throw InputError(
            fmt::format("{}: a contour is of two inputs, and this regime has {} of them; give hours for values of two "
                        "keys, as ice.thickness_m and structure.speed_m_s",
                        first.where, first.values.size()));
    made.keys = {first.values[0].path, first.values[1].path};
    for (const Entry& value : first.values) refuse_stranger(value.path, value.where);
    std::array<std::set<double>, 2> values;
    for (const Regime& regime : regimes) {
        made.classes.push_back(class_of(regime, made.keys));
        made.time += regime.time;
        for (std::size_t k = 0; k < 2; ++k) values[k].insert(made.classes.back().value[k]);
    }
    for (std::size_t k = 0; k < 2; ++k)
        if (values[k].size() < fewest_classes)
            throw InputError(fmt::format("{}: {} has {} different values, and a distribution wants at least {}", file,
                                         made.keys[k], values[k].size(), fewest_classes));
    std::ranges::sort(made.classes, {}, &ClassHours::value);  // sums do not depend on the order of the lines
    made.fit = fit_joint_inputs(made.classes);
    made.inputs = made.fit->inputs;
    if (!made.fit->valid())
        throw InputError(
            fmt::format("{}: no distribution can be fitted to these hours; give distributions by [[input]]", file));
    return made;
}

}  // namespace

ContourInputs read_contour_inputs(std::string_view text, const std::string& file) {
    if (has_ending(file, ".csv")) return from_regimes(read_regime_table(text, file), file);
    const Document document = parse_document(text, file);
    const bool regimes = !document.blocks.empty() && document.blocks.front().path == "regime";
    return regimes ? from_regimes(read_regimes(text, file), file) : from_distributions(document, file);
}

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
    const KeyWords words = key_words(key);
    const std::string name = capital(words.name);
    const std::string unit = words.unit.empty() ? "" : " " + words.unit;
    const std::string one = parameter_text(law.first);
    const std::string two = parameter_text(law.second);
    switch (law.law) {
        case InputLaw::normal:
            return fmt::format("{}: normal, mean {}{}, standard deviation {}{}", name, one, unit, two, unit);
        case InputLaw::lognormal:
            return fmt::format("{}: log-normal, median {}{}, standard deviation of the logarithm {}", name, one, unit,
                               two);
        case InputLaw::weibull:
            return fmt::format("{}: Weibull, scale {}{}, shape {}", name, one, unit, two);
        case InputLaw::exponential:
            break;
    }
    return fmt::format("{}: exponential, mean {}{}", name, one, unit);
}

/// Both laws, for programs: each parameter is a + b x^c.
Results laws_of(const ContourInputs& inputs) {
    Results laws{.place = "inputs",
                 .columns = program_columns("key distribution first_a first_b first_c second_a second_b second_c"),
                 .in_csv = false};
    const auto add = [&](const std::string& key, const InputDistribution& law) {
        laws.add(
            {key, name_of(law.law), law.first.a, law.first.b, law.first.c, law.second.a, law.second.b, law.second.c});
    };
    add(inputs.keys[0], inputs.inputs.one);
    add(inputs.keys[1], inputs.inputs.other);
    return laws;
}

/// Values of an input.
ResultColumn column_of(const std::string& key, int digits) {
    return {.key = key, .words = key_words(key).heading(), .digits = digits};
}

Section ice_section(const ContourInputs& inputs, const ContourRequest& request) {
    const double hours = inputs.time / unit::hour;
    const bool smooth = !inputs.inputs.other.first.constant() || !inputs.inputs.other.second.constant();
    std::string text =
        fmt::format("Ice of {:g} h a year: {:.4g} states of {:g} h.\n{}.\n{}{}.\n", hours, inputs.time / request.state,
                    request.state / unit::hour, law_text(inputs.inputs.one, inputs.keys[0]),
                    law_text(inputs.inputs.other, inputs.keys[1]),
                    smooth ? fmt::format("; x is the {}", key_words(inputs.keys[0]).name) : "");
    if (!inputs.fit) return {.before = std::move(text), .results = {laws_of(inputs)}};
    const bool weibull = inputs.inputs.one.law == InputLaw::weibull;
    text += fmt::format(
        "Fitted to the hours of {} classes by maximum likelihood; for the {} {} is likelier than {} (mean "
        "log-likelihood of an hour: {:.2g} more).{} What lies beyond the classes is what these laws make of it.\n\n",
        inputs.classes.size(), key_words(inputs.keys[0]).name, weibull ? "Weibull" : "log-normal",
        weibull ? "log-normal" : "Weibull", inputs.fit->ahead,
        inputs.fit->scatter_fixed ? " Too few classes tell whether the scatter of the second depends on the first."
                                  : "");
    Results classes{.place = "classes",
                    .columns = {column_of(inputs.keys[0], 6),
                                {.key = "hours", .words = "a year", .unit = "h", .digits = 4},
                                {.key = "hours_by_law", .words = "by the law", .unit = "h", .digits = 4}},
                    .in_csv = false};
    for (const ClassCheck& one : inputs.fit->classes) classes.add({one.value, one.hours, one.by_law});
    return {.before = std::move(text), .results = {std::move(classes), laws_of(inputs)}};
}

Section points_section(const ContourInputs& inputs, const std::vector<ContourOf>& contours) {
    Results rows{.place = "contours",
                 .columns = {{"per_year"},
                             {"radius"},
                             {"", "exceeded in a year with, at"},
                             {"angle_deg"},
                             column_of(inputs.keys[0], 4),
                             column_of(inputs.keys[1], 4)}};
    for (const ContourOf& one : contours)
        for (const ContourPoint& point : one.points)
            rows.add({one.per_year, one.radius, fmt::format("{}, {:.0f}°", per_year_text(one.per_year), point.degrees),
                      point.degrees, point.value[0], point.value[1]});
    Section made{.title = "Environmental contours (IFORM)", .results = {std::move(rows)}};
    for (const ContourOf& one : contours)
        made.after += fmt::format("{}{}: radius {:.4g} in standard normal space.", made.after.empty() ? "\n" : " ",
                                  per_year_text(one.per_year), one.radius);
    made.after +=
        "\nRun a short-term case at each point (-o cases.toml --config my.toml), then floes design: the largest over "
        "the points, at a quantile that makes up for the load's own variability, is the load of that probability a "
        "year. Which quantile does is not known beforehand: docs/year.md.\n";
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

Figure contour_figure(const ContourInputs& inputs, const std::vector<ContourOf>& contours) {
    constexpr double largest_dot = 7;  // of the class with most hours
    std::array<std::vector<double>, 2> values;
    for (const ContourOf& one : contours)
        for (const ContourPoint& point : one.curve)
            for (std::size_t k = 0; k < 2; ++k) values[k].push_back(point.value[k]);
    double most = 0;
    for (const ClassHours& one : inputs.classes) {
        most = std::max(most, one.hours);
        for (std::size_t k = 0; k < 2; ++k) values[k].push_back(one.value[k]);
    }
    Figure figure{.description = "Environmental contours of two inputs",
                  .x = axis_around(key_words(inputs.keys[0]).heading(), values[0], true),
                  .y = axis_around(key_words(inputs.keys[1]).heading(), values[1], true),
                  .size = {720, 420}};
    for (const ClassHours& one : inputs.classes)
        figure.dot(one.value[0], one.value[1], "faint", std::max(1.0, largest_dot * std::sqrt(one.hours / most)));
    for (std::size_t k = 0; k < contours.size(); ++k) {
        Figure::Points line;
        for (const ContourPoint& point : contours[k].curve) line.emplace_back(point.value[0], point.value[1]);
        line.push_back(line.front());
        figure.line(std::move(line), colour(k));
        for (const ContourPoint& point : contours[k].points) figure.dot(point.value[0], point.value[1], colour(k), 3);
        figure.legend.emplace_back(colour(k), fmt::format("{} a year", per_year_text(contours[k].per_year)));
    }
    figure.caption = fmt::format(
        "Contours by IFORM: a year has a state outside of a tangent (in standard normal space) with the probability of "
        "the contour. Dots on the lines: the points of the table.{}",
        inputs.classes.empty() ? "" : " Grey dots: the classes of the scatter diagram, their area the hours.");
    return figure;
}

}  // namespace floes
