#include "year/contour_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/units.hpp"
#include "keys/document.hpp"
#include "year/regimes.hpp"

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

std::optional<double> number_of(const Value& value) {
    if (const auto* real = std::get_if<double>(&value.data)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
    return {};
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

const Entry* find_entry(const Block& block, std::string_view path) {
    const auto found = std::ranges::find(block.entries, path, &Entry::path);
    return found == block.entries.end() ? nullptr : &*found;
}

/// The text of an entry that must be there.
std::string words_of(const Block& block, std::string_view path, std::string_view example) {
    const Entry* entry = find_entry(block, path);
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
    throw InputError(fmt::format("{}: distribution = \"{}\" is not one of {}", find_entry(block, "distribution")->where,
                                 name, fmt::join(names, ", ")));
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
        const Entry* entry = find_entry(block, words.parameters[k]);
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
        if (!(hours > 0 && hours <= year_hours))
            throw InputError(fmt::format("{}: hours_per_year = {} must be above 0 and at most {:g}", entry.where,
                                         to_text(entry.value), year_hours));
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
            throw InputError(
                fmt::format("{}: {} = {:g} is not above 0, and the distributions that are fitted are of "
                            "positive inputs",
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
    made.fit = fit_joint_inputs(made.classes);
    made.inputs = made.fit->inputs;
    if (!made.fit->valid())
        throw InputError(
            fmt::format("{}: no distribution can be fitted to these hours; give distributions by [[input]]", file));
    return made;
}

}  // namespace

ContourInputs read_contour_inputs(std::string_view text, const std::string& file) {
    if (file.ends_with(".csv")) return from_regimes(read_regime_table(text, file), file);
    const Document document = parse_document(text, file);
    const bool regimes = !document.blocks.empty() && document.blocks.front().path == "regime";
    return regimes ? from_regimes(read_regimes(text, file), file) : from_distributions(document, file);
}

}  // namespace floes
