#include "match/waves.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/identity.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "keys/edit_distance.hpp"
#include "keys/key.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

constexpr const char* target_block = "target";

/// The time that a key ends in, s: 0.5 of "mean_maximum_0.5s"; none where it ends in something else.
std::vector<double> time_in(std::string_view key) {
    double time = 0;
    const char* const end = key.data() + key.size();
    const auto [stop, fault] = std::from_chars(key.data() + (key.rfind('_') + 1), end, time);
    const bool whole = fault == std::errc{} && std::string_view(stop, end) == "s";
    return whole && time > 0 ? std::vector{time} : std::vector<double>{};
}

std::string nearest_quantity(std::string_view key) {
    const std::vector<Quantity> known = quantities_with(time_in(key));
    return std::string{std::ranges::min_element(known, {}, [&](const Quantity& one) {
                           return edit_distance(one.key, key);
                       })->key.view()};
}

/// The values that the quantity can have, in the unit in which it is shown.
Range range_of(const Quantity& quantity) {
    if (quantity.positive) return above(0);
    return at_least(quantity.least * quantity.factor()).at_most(quantity.most * quantity.factor());
}

class TargetReader {
  public:
    explicit TargetReader(const Block& block) : block_(block) {}

    Target read() {
        target_.quantity = find_quantity();
        const double unit = target_.quantity.percent ? unit::percent : unit::one;
        double percent_of_value = 0;
        std::string quantity;
        const Keys keys{
            text_key("quantity", quantity, "", ""),
            text_key("case", target_.case_name, "", ""),
            number_key("value", target_.value, unit, range_of(target_.quantity), "", ""),
            number_key("uncertainty", target_.uncertainty, unit, at_least(0), "", ""),
            integer_key("runs", target_.runs, 1, 1'000'000, "", ""),
            number_key("discrepancy", target_.discrepancy, unit, at_least(0), "", ""),
            number_key("discrepancy_percent", percent_of_value, unit::percent, at_least(0), "", ""),
            switch_key("held_out", target_.held_out, "", ""),
        };
        for (const Entry& entry : block_.entries) assign_known(keys, entry);
        if (block_.find("value") == nullptr)
            throw InputError(fmt::format("{}: the target {} has no value; give the measured one, {}", block_.where,
                                         target_.name(), unit_words()));
        const Entry* relative = block_.find("discrepancy_percent");
        if (relative != nullptr && block_.find("discrepancy") != nullptr)
            throw InputError(fmt::format("{}: discrepancy_percent = {} and discrepancy are both given; keep one",
                                         relative->where, to_text(relative->value)));
        if (relative != nullptr) target_.discrepancy = percent_of_value * std::abs(target_.value);
        return target_;
    }

  private:
    Quantity find_quantity() const {
        const Entry* entry = block_.find("quantity");
        if (entry == nullptr)
            throw InputError(fmt::format("{}: this [[target]] has no quantity; begin it with quantity = \"mean_load\"",
                                         block_.where));
        std::string key;
        assign(text_key("quantity", key, "", ""), *entry);
        if (const auto found = any_quantity(key)) return *found;
        throw InputError(fmt::format("{}: quantity = {} is not a quantity of a member; did you mean {}?", entry->where,
                                     text_literal(key), text_literal(nearest_quantity(key))));
    }

    std::string unit_words() const {
        if (target_.quantity.percent) return "in percent";
        return target_.quantity.unit == "1" ? "which has no unit" : fmt::format("in {}", target_.quantity.unit);
    }

    const Block& block_;
    Target target_;
};

[[noreturn]] void refuse_stranger(const Entry& entry) {
    throw InputError(
        fmt::format("{}: {} = {} is not in a target; begin each target with [[target]], in double brackets",
                    entry.where, entry.path, to_text(entry.value)));
}

}  // namespace

std::string Target::name() const {
    return case_name.empty() ? std::string{quantity.key.view()} : fmt::format("{} {}", case_name, quantity.key);
}

std::string Target::shown(double stored, int digits) const {
    const std::string_view unit = quantity.percent ? "%" : quantity.unit == "1" ? "" : quantity.unit;
    return fmt::format("{:.{}g}{}{}", stored * quantity.factor(), digits, unit.empty() ? "" : " ", unit);
}

std::vector<Target> read_targets(std::string_view text, const std::string& file) {
    const Document document = parse_document(text, file);
    if (!document.entries.empty()) refuse_stranger(document.entries.front());
    std::vector<Target> targets;
    std::map<std::string, std::string> places;
    for (const Block& block : document.blocks) {
        if (block.path != target_block)
            throw InputError(
                fmt::format("{}: [[{}]] is not a table of targets; did you mean [[target]]?", block.where, block.path));
        const Target& target = targets.emplace_back(TargetReader(block).read());
        const auto [earlier, is_new] = places.emplace(target.name(), block.where);
        if (!is_new)
            throw InputError(fmt::format("{}: {} is a target already, at {}; keep one", block.where, target.name(),
                                         earlier->second));
    }
    if (targets.empty())
        throw InputError(
            fmt::format("{}: there are no targets; write [[target]] with quantity and value for each "
                        "measured figure",
                        file));
    return targets;
}

namespace {

/// They decide what else is stored about a member, not what it measures.
constexpr std::array storage_keys{"analysis.history_steps", "analysis.exceedance_levels_N", "analysis.averaging_s",
                                  "analysis.peak_separation_s"};

double on_scale(double value, AxisScale scale) {
    return scale == AxisScale::log ? std::log(value) : value;
}

void refuse_design(const MatchWave& wave) {
    const Design& design = wave.campaign.design;
    if (!design.active())
        throw InputError(
            fmt::format("{} has no design, so its cases lie on no axes; give its configuration a [design] whose axes "
                        "are the inputs to be matched",
                        wave.file));
    for (const DesignAxis& axis : design.axes) {
        if (!axis.numeric)
            throw InputError(
                fmt::format("{}: the axis {} takes words or lists, and a matching wants numbers; run them as separate "
                            "designs, one for "
                            "each value, and match each by itself",
                            wave.file, axis.key));
    }
}

std::set<std::string> axis_keys(const MatchWave& wave) {
    std::set<std::string> keys;
    for (const DesignAxis& axis : wave.campaign.design.axes) keys.insert(axis.key);
    return keys;
}

MatchAxis match_axis(const MatchWave& wave, const DesignAxis& axis) {
    MatchAxis made{axis.key, axis.from, axis.to, axis.scale, axis.whole};
    if (!wave.campaign.design.has_ranges()) {
        std::vector<double> values;
        for (const Case& one : wave.campaign.cases) values.push_back(numeric_value(one, axis.key));
        const auto [least, most] = std::ranges::minmax(values);
        made.from = least;
        made.to = most;
    }
    if (made.from < made.to) return made;
    throw InputError(
        fmt::format("{}: the axis {} has the one value {}; take it out of the design, since it varies "
                    "nothing",
                    wave.file, axis.key, made.from));
}

/// Gives a case the values of another one on the axes. An axis may be a part of another key's value, so it is not
/// enough to leave out the axes' own keys in a comparison.
void take_axes(Scenario& to, Scenario from, const std::set<std::string>& axes) {
    const Keys to_keys = describe(to);
    const Keys from_keys = describe(from);
    for (const std::string& axis : axes) {
        const auto& there = find_key(to_keys, axis)->field;
        const auto& here = find_key(from_keys, axis)->field;
        if (const auto* number = std::get_if<NumberField>(&there))
            number->set(std::get<NumberField>(here).get());
        else if (const auto* count = std::get_if<IntegerField>(&there))
            count->set(std::get<IntegerField>(here).get());
    }
}

/// What differs between two cases beside the axes.
std::vector<std::string> other_conditions(Case there, Case here, const std::set<std::string>& axes) {
    there.name = here.name;
    take_axes(there.scenario, here.scenario, axes);
    Campaign of_there;
    Campaign of_here;
    of_there.cases = {std::move(there)};
    of_here.cases = {std::move(here)};
    std::vector<std::string> lines = differences(of_there, of_here);
    std::erase_if(lines, [&](const std::string& line) {
        return std::ranges::find(storage_keys, line.substr(0, line.find(':'))) != storage_keys.end();
    });
    return lines;
}

void refuse_other(const MatchWave& first, const MatchWave& other) {
    const std::set<std::string> axes = axis_keys(first);
    if (axes != axis_keys(other))
        throw InputError(fmt::format("{} has the axes {}, and {} has {}; waves of one matching vary the same keys",
                                     first.file, fmt::join(axes, ", "), other.file, fmt::join(axis_keys(other), ", ")));
    std::set<std::string> seen;
    for (const Case& here : other.campaign.cases) {
        if (!seen.insert(here.base).second) continue;
        const auto there = std::ranges::find(first.campaign.cases, here.base, &Case::base);
        if (there == first.campaign.cases.end()) continue;
        const std::vector<std::string> lines = other_conditions(*there, here, axes);
        if (lines.empty()) continue;
        throw InputError(fmt::format(
            "{} (there) and {} (here) are not waves of one matching, because keys that are not axes differ{}: {}",
            first.file, other.file, here.base.empty() ? "" : fmt::format(" in case {}", here.base),
            fmt::join(lines, "; ")));
    }
}

}  // namespace

MatchWave read_wave(const std::filesystem::path& path) {
    const CampaignFile file(path);
    return {path.string(), file.campaign(), read_campaign_file(file)};
}

double MatchAxis::coordinate(double value) const {
    const double low = on_scale(from, scale);
    return 2 * (on_scale(value, scale) - low) / (on_scale(to, scale) - low) - 1;
}

double MatchAxis::value(double coordinate) const {
    const double low = on_scale(from, scale);
    const double on = low + (coordinate + 1) / 2 * (on_scale(to, scale) - low);
    return scale == AxisScale::log ? std::exp(on) : on;
}

std::vector<MatchAxis> match_axes(std::span<const MatchWave> waves) {
    if (waves.empty()) throw InputError("A matching wants a campaign file at least.");
    for (const MatchWave& wave : waves) refuse_design(wave);
    for (std::size_t k = 1; k < waves.size(); ++k)
        for (std::size_t earlier = 0; earlier < k; ++earlier) refuse_other(waves[earlier], waves[k]);
    std::vector<MatchAxis> axes;
    for (const DesignAxis& axis : waves.front().campaign.design.axes) axes.push_back(match_axis(waves.front(), axis));
    return axes;
}

std::vector<std::string> match_cases(std::span<const MatchWave> waves) {
    std::vector<std::string> names;
    for (const MatchWave& wave : waves)
        for (const Case& one : wave.campaign.cases)
            if (std::ranges::find(names, one.base) == names.end()) names.push_back(one.base);
    return names;
}

}  // namespace floes
