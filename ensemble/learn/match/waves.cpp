#include "match/waves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "campaign/identity.hpp"
#include "campaign_file/read_campaign_file.hpp"
#include "campaign_file/read_details.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"

namespace floes {
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
