#include "match/waves.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "keys/key.hpp"
#include "keys/meant.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"
#include "statistics/load_statistics.hpp"

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
        if (percent_of_value > 0 && target_.value == 0)
            throw InputError(
                fmt::format("{}: discrepancy_percent = {} of value = 0 is no discrepancy; give discrepancy instead, {}",
                            relative->where, to_text(relative->value), unit_words()));
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
    if (!document.entries.empty())
        throw InputError(fmt::format(
            "{}: {} = {} is not in a target; begin each target with [[target]], in double brackets",
            document.entries.front().where, document.entries.front().path, to_text(document.entries.front().value)));
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
        throw InputError(fmt::format(
            "{}: there are no targets; write [[target]] with quantity and value for each measured figure", file));
    return targets;
}

namespace {

/// They decide what else is stored about a member, not what it measures.
constexpr std::array storage_keys{"analysis.history_steps", "analysis.exceedance_levels_N", "analysis.averaging_s",
                                  "analysis.peak_separation_s"};

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
                            "designs, one for each value, and match each by itself",
                            wave.file, axis.key));
    }
}

std::set<std::string> axis_keys(const MatchWave& wave) {
    std::set<std::string> keys;
    for (const DesignAxis& axis : wave.campaign.design.axes) keys.insert(axis.key);
    return keys;
}

RangedAxis match_axis(const MatchWave& wave, const DesignAxis& axis) {
    RangedAxis made = ranged_axis(wave.campaign, axis);
    if (made.from < made.to) return made;
    throw InputError(
        fmt::format("{}: the axis {} has the one value {}; take it out of the design, since it varies nothing",
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

std::vector<RangedAxis> match_axes(std::span<const MatchWave> waves) {
    if (waves.empty()) throw InputError("A matching wants a campaign file at least.");
    for (const MatchWave& wave : waves) refuse_design(wave);
    for (std::size_t k = 1; k < waves.size(); ++k)
        for (std::size_t earlier = 0; earlier < k; ++earlier) refuse_other(waves[earlier], waves[k]);
    std::vector<RangedAxis> axes;
    for (const DesignAxis& axis : waves.front().campaign.design.axes) axes.push_back(match_axis(waves.front(), axis));
    return axes;
}

std::string nearest(const std::vector<std::string>& names, const std::string& name) {
    return *std::ranges::min_element(names, {}, [&](const std::string& one) { return edit_distance(one, name); });
}

std::vector<std::string> match_cases(std::span<const MatchWave> waves) {
    std::vector<std::string> names;
    for (const MatchWave& wave : waves)
        for (const Case& one : wave.campaign.cases)
            if (std::ranges::find(names, one.base) == names.end()) names.push_back(one.base);
    return names;
}

namespace {

/// Covariance of single runs of two points on one arrangement. Of two points with m and n runs, c of them on common
/// arrangements, the product of two deviations from the points' means has the expectation
/// (1 - 1/m - 1/n + c/(m n)) times the covariance.
double covariance(std::span<const PointRuns> points, const std::vector<double>& means) {
    std::vector<std::map<int, double>> deviations;
    for (std::size_t p = 0; p < points.size(); ++p) {
        std::map<int, double>& of_point = deviations.emplace_back();
        for (std::size_t k = 0; k < points[p].values.size(); ++k)
            of_point[points[p].arrangements[k]] = points[p].values[k] - means[p];
    }
    double products = 0;
    double weight = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t q = p + 1; q < points.size(); ++q) {
            if (points[p].wave != points[q].wave) continue;
            double common = 0;
            for (const auto& [arrangement, deviation] : deviations[p]) {
                const auto other = deviations[q].find(arrangement);
                if (other == deviations[q].end()) continue;
                products += deviation * other->second;
                common += 1;
            }
            const auto m = static_cast<double>(deviations[p].size());
            const auto n = static_cast<double>(deviations[q].size());
            weight += common * (1 - 1 / m - 1 / n + common / (m * n));
        }
    }
    return weight > 0 ? products / weight : 0;
}

}  // namespace

Scatter scatter_of(std::span<const PointRuns> points) {
    Scatter found;
    found.pooled = undefined;
    double squares = 0;
    double freedom = 0;
    std::vector<double> own_squares;
    for (const PointRuns& point : points) {
        const double own_freedom = static_cast<double>(point.values.size()) - 1;
        found.mean.push_back(mean_of(point.values));
        own_squares.push_back(squares_about(point.values, found.mean.back()));
        found.sample_variance.push_back(own_freedom > 0 ? own_squares.back() / own_freedom : undefined);
        squares += own_squares.back();
        freedom += own_freedom;
    }
    if (freedom > 0) found.pooled = squares / freedom;
    for (std::size_t p = 0; p < points.size(); ++p)
        found.variance.push_back((pooled_runs * found.pooled + own_squares[p]) /
                                 (pooled_runs + static_cast<double>(points[p].values.size()) - 1));
    if (found.pooled > 0) found.shared = std::clamp(covariance(points, found.mean) / found.pooled, 0.0, 1.0);
    return found;
}

namespace {

/// The cases of all waves that are used: by wave and point, then by [[case]].
struct UsedCase {
    int wave;
    int number;  ///< of the point
    std::string base;
    std::size_t index;  ///< in the wave's campaign
};

std::vector<UsedCase> used_cases(std::span<const MatchWave> waves) {
    std::vector<UsedCase> used;
    std::map<std::pair<std::string, std::string>, std::pair<int, std::string>> seen;
    for (std::size_t w = 0; w < waves.size(); ++w) {
        const Campaign& campaign = waves[w].campaign;
        for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
            const Case& one = campaign.cases[k];
            const auto [place, is_new] = seen.try_emplace({one.base, case_fingerprint(campaign, static_cast<int>(k))},
                                                          static_cast<int>(w), one.name);
            if (is_new) {
                used.push_back({static_cast<int>(w), one.point, one.base, k});
                continue;
            }
            const auto& [wave, name] = place->second;
            if (wave == static_cast<int>(w)) continue;
            throw InputError(
                fmt::format("{} has in its case {} the simulations of {}'s case {}; give each wave once, and a later "
                            "wave points or a campaign.seed of its own",
                            waves[w].file, one.name, waves[static_cast<std::size_t>(wave)].file, name));
        }
    }
    std::ranges::stable_sort(used, {}, [](const UsedCase& one) { return std::pair(one.wave, one.number); });
    return used;
}

/// Members are arrangement-major.
std::vector<const MemberRow*> done_members(const MatchWave& wave, std::size_t case_index) {
    std::vector<const MemberRow*> members;
    for (std::size_t k = case_index; k < wave.table.members.size(); k += wave.campaign.cases.size())
        if (wave.table.members[k].done()) members.push_back(&wave.table.members[k]);
    return members;
}

/// The name of the [[case]] that the target is about; none where it is held out and no wave has it.
std::optional<std::string> case_of(const Target& target, const std::vector<std::string>& cases) {
    if (target.case_name.empty() && cases.size() == 1) return cases.front();
    if (target.case_name.empty())
        throw InputError(fmt::format("The target {} names no case, and there are {}; give it a case.", target.name(),
                                     name_list(cases)));
    if (std::ranges::find(cases, target.case_name) != cases.end()) return target.case_name;
    if (target.held_out) return {};
    if (cases.size() == 1 && cases.front().empty())
        throw InputError(
            fmt::format("The target {} is about a case, and the design has no [[case]]; take case = \"{}\" away from "
                        "the target, or give the design a [[case]] of that name.",
                        target.name(), target.case_name));
    throw InputError(
        fmt::format("The target {} is about a case that no campaign has: the cases are {}; did you mean {}? A target "
                    "that is held out may lack its case.",
                    target.name(), name_list(cases), nearest(cases, target.case_name)));
}

/// Collects the results of all waves, point by point.
class Collector {
  public:
    explicit Collector(std::span<const MatchWave> waves)
        : waves_(waves), axes_(match_axes(waves)), cases_(match_cases(waves)), used_(used_cases(waves)) {
        for (const UsedCase& one : used_) members_.push_back(done_members(wave_of(one), one.index));
    }

    MatchData collect(std::span<const Target> targets) {
        MatchData data{axes_, points(), {}};
        for (const Target& target : targets) data.targets.push_back(of_target(target));
        return data;
    }

  private:
    const MatchWave& wave_of(const UsedCase& one) const { return waves_[static_cast<std::size_t>(one.wave)]; }

    /// Numbers the points that have a done member in some case.
    std::vector<MatchPoint> points() {
        std::vector<MatchPoint> made;
        for (std::size_t k = 0; k < used_.size(); ++k) {
            const UsedCase& one = used_[k];
            if (members_[k].empty()) continue;
            const auto [place, is_new] =
                numbers_.try_emplace(std::pair(one.wave, one.number), static_cast<int>(made.size()));
            if (!is_new) continue;
            MatchPoint& point = made.emplace_back(MatchPoint{{}, one.wave, one.number});
            for (const RangedAxis& axis : axes_)
                point.coordinates.push_back(
                    axis.coordinate(numeric_value(wave_of(one).campaign.cases[one.index], axis.key)));
        }
        return made;
    }

    TargetData of_target(const Target& target) const {
        TargetData data;
        data.target = target;
        std::vector<PointRuns> all;
        const std::optional<std::string> name = case_of(target, cases_);
        for (std::size_t k = 0; name && k < used_.size(); ++k) {
            const UsedCase& one = used_[k];
            if (one.base != *name) continue;
            PointRuns point{one.wave, {}, {}};
            for (const MemberRow* member : members_[k]) {
                const double value = member->value(target.quantity);
                if (!std::isfinite(value)) continue;
                point.arrangements.push_back(member->arrangement);
                point.values.push_back(value);
            }
            if (point.values.empty()) continue;
            data.point.push_back(numbers_.at({one.wave, one.number}));
            data.runs.push_back(static_cast<int>(point.values.size()));
            all.push_back(std::move(point));
        }
        if (all.empty() && !target.held_out) throw no_data(target);
        static_cast<Scatter&>(data) = scatter_of(all);
        if (!all.empty() && std::isnan(data.pooled))
            throw InputError(
                fmt::format("The target {} has one run at every point, which says nothing of the scatter; run two "
                            "arrangements or more.",
                            target.name()));
        return data;
    }

    InputError no_data(const Target& target) const {
        std::set<double> times;
        for (const MatchWave& wave : waves_)
            times.insert(wave.table.averaging_times.begin(), wave.table.averaging_times.end());
        const double time = target.quantity.averaging;
        if (time > 0 && !times.contains(time))
            return InputError(fmt::format(
                "The target {} is of a time that no campaign averages the load over; {} (analysis.averaging_s).",
                target.name(),
                times.empty() ? "they average over none" : fmt::format("the times are {} s", fmt::join(times, ", "))));
        return InputError(
            fmt::format("The target {} has no member that is done and measured it in any campaign.", target.name()));
    }

    std::span<const MatchWave> waves_;
    std::vector<RangedAxis> axes_;
    std::vector<std::string> cases_;
    std::vector<UsedCase> used_;
    std::vector<std::vector<const MemberRow*>> members_;  ///< done ones of each used case
    std::map<std::pair<int, int>, int> numbers_;          ///< wave and point -> index of the point
};

}  // namespace

MatchData match_data(std::span<const MatchWave> waves, std::span<const Target> targets) {
    return Collector(waves).collect(targets);
}

}  // namespace floes
