#include "inference/precision_stop.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/stop_rule.hpp"
#include "inference/interval.hpp"
#include "member/design_of.hpp"
#include "member/quantity.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

Exposure exposure_of(const Campaign& campaign) {
    const StopRule& stop = campaign.stop;
    Exposure exposure{.time = stop.exposure, .probabilities = {}, .quick = campaign.cases.size() > most_averaged_cases};
    exposure.expected = stop.quantile == 0;
    if (!exposure.expected) exposure.probabilities.push_back(stop.quantile);
    return exposure;
}

}  // namespace

DesignPrecision::DesignPrecision(const Campaign& campaign, std::vector<bool> watched)
    : of_(campaign.stop.design_of()),
      exposure_(exposure_of(campaign)),
      averaging_(campaign.stop.averaging),
      of_expected_(campaign.stop.quantile == 0),
      half_width_(undefined) {
    for (std::size_t k = 0; k < campaign.cases.size(); ++k)
        cases_.push_back({.name = campaign.cases[k].name,
                          .analysis = campaign.cases[k].scenario.analysis,
                          .separation = separation_of(campaign.cases[k].scenario, *of_),
                          .watched = watched.at(k)});
}

std::optional<MeasuredPeaks> DesignPrecision::peaks_of(std::size_t case_index, const MemberOutputs& outputs) const {
    if (const Response* response = response_of(outputs, *of_)) {
        if (response->segment_maximum.empty()) return {};
        return MeasuredPeaks{{response->peaks, response->segment_maximum}, member_trend(*response)};
    }
    const auto averaged = std::ranges::find(outputs.averaged, averaging_, &AveragedLoad::time);
    if (of_->value != nullptr || averaged == outputs.averaged.end()) return {};
    return MeasuredPeaks{{averaged->peaks, averaged->segment_maximum},
                         member_trend(outputs, cases_.at(case_index).analysis.window)};
}

void DesignPrecision::add(std::size_t case_index, MeasuredPeaks member) {
    OneCase& one = cases_.at(case_index);
    one.rows.push_back(std::move(member.peaks));
    one.trends.push_back(member.trend);
}

void DesignPrecision::judge() {
    half_width_ = 0;
    obstacle_.clear();
    for (const OneCase& one : cases_) {
        if (!std::isfinite(half_width_)) break;
        if (one.watched) half_width_ = std::max(half_width_of(one), half_width_);
    }
}

double DesignPrecision::half_width_of(const OneCase& one) {
    const JointTrend trend = joint_trend(one.trends, of_->noun);
    if (trend.rises()) {
        obstacle_ = fmt::format("case {}: {}, so it has no design value", one.name, trend_text(trend));
        return undefined;
    }
    const Measured measured{one.analysis.window, one.analysis.window / one.analysis.segments, one.separation,
                            trend.mean};
    const DesignLoad load = load_by_both_tails(one.rows, measured, exposure_);
    if (!load.valid()) {
        obstacle_ = fmt::format("case {}: {} members with {} peaks above the threshold are too few for a tail",
                                one.name, one.rows.size(), load.peaks);
        return undefined;
    }
    const DesignLoadEstimate& made = load.estimates.front();
    const LoadFigure& figure = of_expected_ ? made.expected : made.quantiles.front();
    const double longer = std::max(figure.interval.high - figure.value, figure.value - figure.interval.low);
    const double half_width = longer / std::abs(figure.value);
    if (!std::isfinite(half_width))
        obstacle_ = fmt::format("case {}: its expected largest {} is infinite", one.name, of_->noun);
    return half_width;
}

namespace {

constexpr double normal_half = 1.959963984540054;  // lower bound of t: a target missed with this is missed with t

constexpr int fewest_by_default = 20;  // with fewer, the scatter is itself uncertain

// A kind of member in such a share decides a design load, however wide an interval may be.
constexpr double seen_for_a_design_value = 0.05;

// How the judgements of a design load follow one another, see the header.
constexpr double of_the_needed = 0.5;
constexpr double least_growth = 1.1;
constexpr double most_growth = 1.4;

int minimum_of(const StopRule& rule) {
    return rule.minimum > 0 ? rule.minimum
                            : std::max(fewest_by_default, members_to_see(PrecisionStop::share_seen(rule)));
}

}  // namespace

PrecisionStop::PrecisionStop(const StopRule& rule, const std::vector<std::string>& cases,
                             const std::vector<int>& groups)
    : rule_(rule), minimum_(minimum_of(rule)), cases_(cases.size()), targets_(targets_of(rule, cases, groups)) {}

PrecisionStop::PrecisionStop(const Campaign& campaign)
    : PrecisionStop(campaign.stop, case_names(campaign), sharing_groups(campaign)) {
    if (rule_.design_of() == nullptr) return;
    std::vector<bool> watched(cases_, false);
    for (const Target& target : targets_) {
        const auto k = static_cast<std::size_t>(target.case_index);
        watched[k] = rule_.design_of()->is_of(campaign.cases[k].scenario);
    }
    design_.emplace(campaign, std::move(watched));
    next_ = end_of_batch(std::min(minimum_, fewest_by_default));
}

double PrecisionStop::share_seen(const StopRule& rule) {
    return rule.design_of() == nullptr ? rule.half_width : std::min(rule.half_width, seen_for_a_design_value);
}

void PrecisionStop::put(int arrangement, int case_index, double value) {
    take_in(arrangement, case_index, {value, {}});
}

void PrecisionStop::put_member(int arrangement, int case_index, const MemberOutputs* outputs) {
    Said said;
    if (outputs != nullptr && design_) said.peaks = design_->peaks_of(static_cast<std::size_t>(case_index), *outputs);
    if (outputs != nullptr && !design_) said.value = any_quantity(rule_.of)->of(*outputs);
    take_in(arrangement, case_index, std::move(said));
}

/// Keeps what a member says, and takes the arrangements that are whole and follow those taken.
void PrecisionStop::take_in(int arrangement, int case_index, Said said) {
    if (met_ || arrangement < arrangements_) return;
    Members& members = waiting_[arrangement];
    members.resize(cases_);
    std::optional<Said>& place = members[static_cast<std::size_t>(case_index)];
    if (place) return;
    place = std::move(said);
    const auto is_known = [](const std::optional<Said>& one) { return one.has_value(); };
    while (!met_ && !waiting_.empty() && waiting_.begin()->first == arrangements_ &&
           std::ranges::all_of(waiting_.begin()->second, is_known)) {
        const Members next = std::move(waiting_.begin()->second);
        waiting_.erase(waiting_.begin());
        if (design_)
            take_peaks(next);
        else
            take(next);
    }
}

void PrecisionStop::take_peaks(const Members& members) {
    for (std::size_t k = 0; k < members.size(); ++k)
        if (members[k]->peaks) design_->add(k, *members[k]->peaks);
    ++arrangements_;
    if (arrangements_ < next_) return;
    look();
    const bool holds = arrangements_ >= minimum_ && design_->half_width() <= rule_.half_width;
    if (!holds) held_from_ = 0;
    if (holds && held_from_ == 0) held_from_ = arrangements_;
    met_ = holds && arrangements_ - held_from_ >= rule_.look_ahead;
    next_ = next_judgement(holds);
}

void PrecisionStop::look() {
    if (!design_ || judged_ == arrangements_) return;
    judged_ = arrangements_;
    design_->judge();
}

/// The first end of a batch at or after so many arrangements.
int PrecisionStop::end_of_batch(double arrangements) const {
    return static_cast<int>(std::ceil(arrangements / rule_.batch)) * rule_.batch;
}

int PrecisionStop::next_judgement(bool holds) const {
    if (holds) return end_of_batch(std::max(arrangements_ + 1, held_from_ + rule_.look_ahead));
    const double missed = design_->half_width() / rule_.half_width;
    const double factor =
        std::isfinite(missed) ? std::clamp(of_the_needed * missed * missed, least_growth, most_growth) : least_growth;
    constexpr double most = 1e6;  // arrangements of a campaign
    const double next = std::min(factor * arrangements_, most);
    return end_of_batch(arrangements_ < minimum_ ? std::min<double>(next, minimum_) : next);
}

void PrecisionStop::take(const Members& members) {
    for (Target& target : targets_) target.add(members);
    ++arrangements_;
    if (arrangements_ < minimum_) return;
    const bool holds = std::ranges::all_of(targets_, [&](const Target& target) {
        if (target.count < 2) return false;
        const double by_normal = normal_half * std::sqrt(target.squares / (target.count - 1) / target.count);
        return by_normal <= rule_.half_width * std::abs(target.base_mean) && target.by_student() <= rule_.half_width &&
               target.half_width_over_mean() <= rule_.half_width;
    });
    held_for_ = holds ? held_for_ + 1 : 0;
    met_ = held_for_ > rule_.look_ahead;
}

double PrecisionStop::achieved() const {
    if (design_) return design_->half_width();
    double largest = 0;
    for (const Target& target : targets_) {
        const double one = target.half_width_over_mean();
        if (std::isnan(one)) return undefined;
        largest = std::max(largest, one);
    }
    return largest;
}

void PrecisionStop::Target::add(const Members& members) {
    const double own = members[static_cast<std::size_t>(case_index)]->value;
    const double base = minus ? members[static_cast<std::size_t>(*minus)]->value : own;
    const double value = minus ? own - base : own;
    if (std::isnan(value)) return;
    ++count;
    const double before = value - mean;
    mean += before / count;
    squares += before * (value - mean);
    base_mean += (base - base_mean) / count;
    taken.push_back(value);
}

double PrecisionStop::Target::by_student() const {
    if (count < 2) return undefined;
    return student_t(count - 1, 0.025) * std::sqrt(squares / (count - 1) / count) / std::abs(base_mean);
}

double PrecisionStop::Target::half_width_over_mean() const {
    const Sides sides = minus ? Sides::both : Sides::above;
    const Apart found = apart(taken, sides);
    if (found.count() == 0) return by_student();
    const Interval mixed = mixed_interval(taken, mean_interval(taken), found, sides);
    return std::max(mixed.high - mean, mean - mixed.low) / std::abs(base_mean);
}

std::vector<PrecisionStop::Target> PrecisionStop::targets_of(const StopRule& rule,
                                                             const std::vector<std::string>& cases,
                                                             const std::vector<int>& groups) {
    std::vector<Target> targets;
    const int count = static_cast<int>(cases.size());
    const auto share = [&](int one, int other) {
        return groups.empty() || groups.at(static_cast<std::size_t>(one)) == groups.at(static_cast<std::size_t>(other));
    };
    if (rule.case_name == "all") {
        for (int one = 0; one < count; ++one) targets.push_back({.case_index = one, .minus = {}});
    } else if (const std::optional<int> one = stop_case(rule, cases)) {
        targets.push_back({.case_index = *one, .minus = {}});
    }
    const std::optional<StopPair> pair = stop_pair(rule, cases, groups);
    if (rule.contrast == "all") {
        for (int one = 0; one < count; ++one) {
            for (int other = one + 1; other < count; ++other) {
                if (share(one, other)) targets.push_back({.case_index = other, .minus = one});
            }
        }
        const bool any = std::ranges::any_of(targets, [](const Target& target) { return target.minus.has_value(); });
        if (count > 1 && !any) throw no_stop_pair(rule, "all cases");
    } else if (pair) {
        targets.push_back({.case_index = pair->of, .minus = pair->minus});
    }
    return targets;
}

}  // namespace floes
