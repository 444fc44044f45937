#include "inference/precision_stop.hpp"

#include <algorithm>
#include <cmath>

#include "inference/interval.hpp"
#include "inference/mixed_mean.hpp"
#include "inference/unlike_members.hpp"
#include "quantities/quantity.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double normal_half = 1.959963984540054;  // lower bound of t: a target missed with this is missed with t

constexpr int fewest_by_default = 20;  // with fewer, the scatter is itself uncertain

// A kind of member in such a share decides a design load, however wide an interval may be.
constexpr double seen_for_a_design_load = 0.05;

// How the judgements of a design load follow one another, see the header.
constexpr double of_the_needed = 0.5;
constexpr double least_growth = 1.1;
constexpr double most_growth = 1.4;

int minimum_of(const StopRule& rule) {
    return rule.minimum > 0 ? rule.minimum
                            : std::max(fewest_by_default, members_to_see(PrecisionStop::share_seen(rule)));
}

std::vector<std::string> names_of(const Campaign& campaign) {
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) names.push_back(one.name);
    return names;
}

}  // namespace

PrecisionStop::PrecisionStop(const StopRule& rule, const std::vector<std::string>& cases,
                             const std::vector<int>& groups)
    : rule_(rule), minimum_(minimum_of(rule)), cases_(cases.size()), targets_(targets_of(rule, cases, groups)) {}

PrecisionStop::PrecisionStop(const Campaign& campaign)
    : PrecisionStop(campaign.stop, names_of(campaign), sharing_groups(campaign)) {
    if (!rule_.of_design_load()) return;
    std::vector<bool> watched(cases_, false);
    for (const Target& target : targets_) watched[static_cast<std::size_t>(target.case_index)] = true;
    loads_.emplace(campaign, std::move(watched));
    next_ = end_of_batch(std::min(minimum_, fewest_by_default));
}

double PrecisionStop::share_seen(const StopRule& rule) {
    return rule.of_design_load() ? std::min(rule.half_width, seen_for_a_design_load) : rule.half_width;
}

/// Where the member's value goes; nullptr where it is known or no longer wanted.
PrecisionStop::Waiting* PrecisionStop::place_for(int arrangement, int case_index) {
    if (met_ || arrangement < arrangements_) return nullptr;
    Waiting& row = waiting_[arrangement];
    row.values.resize(cases_, undefined);
    row.loads.resize(cases_);
    row.known.resize(cases_, false);
    const auto place = static_cast<std::size_t>(case_index);
    if (row.known[place]) return nullptr;
    row.known[place] = true;
    return &row;
}

void PrecisionStop::put(int arrangement, int case_index, double value) {
    Waiting* row = place_for(arrangement, case_index);
    if (row == nullptr) return;
    row->values[static_cast<std::size_t>(case_index)] = value;
    take_leading();
}

void PrecisionStop::put_member(int arrangement, int case_index, const MemberOutputs* outputs) {
    if (!loads_) {
        put(arrangement, case_index, outputs == nullptr ? undefined : any_quantity(rule_.of)->of(*outputs));
        return;
    }
    Waiting* row = place_for(arrangement, case_index);
    if (row == nullptr) return;
    const auto place = static_cast<std::size_t>(case_index);
    if (outputs != nullptr) row->loads[place] = loads_->member_load(place, *outputs);
    take_leading();
}

/// Takes the arrangements that are whole and follow those taken.
void PrecisionStop::take_leading() {
    const auto whole = [](const Waiting& one) { return std::ranges::find(one.known, false) == one.known.end(); };
    while (!met_ && !waiting_.empty() && waiting_.begin()->first == arrangements_ && whole(waiting_.begin()->second)) {
        Waiting row = std::move(waiting_.begin()->second);
        waiting_.erase(waiting_.begin());
        if (loads_)
            take_loads(std::move(row.loads));
        else
            take(row.values);
    }
}

void PrecisionStop::take_loads(std::vector<std::optional<MemberLoad>> loads) {
    for (std::size_t k = 0; k < loads.size(); ++k)
        if (loads[k]) loads_->add(k, std::move(*loads[k]));
    ++arrangements_;
    if (arrangements_ < next_) return;
    look();
    const bool holds = arrangements_ >= minimum_ && loads_->half_width() <= rule_.half_width;
    if (!holds) held_from_ = 0;
    if (holds && held_from_ == 0) held_from_ = arrangements_;
    met_ = holds && arrangements_ - held_from_ >= rule_.look_ahead;
    next_ = next_judgement(holds);
}

void PrecisionStop::look() {
    if (!loads_ || judged_ == arrangements_) return;
    judged_ = arrangements_;
    loads_->judge();
}

/// The first end of a batch at or after so many arrangements.
int PrecisionStop::end_of_batch(double arrangements) const {
    return static_cast<int>(std::ceil(arrangements / rule_.batch)) * rule_.batch;
}

int PrecisionStop::next_judgement(bool holds) const {
    if (holds) return end_of_batch(std::max(arrangements_ + 1, held_from_ + rule_.look_ahead));
    const double missed = loads_->half_width() / rule_.half_width;
    const double factor =
        std::isfinite(missed) ? std::clamp(of_the_needed * missed * missed, least_growth, most_growth) : least_growth;
    constexpr double most = 1e6;  // arrangements of a campaign
    const double next = std::min(factor * arrangements_, most);
    return end_of_batch(arrangements_ < minimum_ ? std::min<double>(next, minimum_) : next);
}

void PrecisionStop::take(const std::vector<double>& values) {
    for (Target& target : targets_) target.add(values);
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
    if (loads_) return loads_->half_width();
    double largest = 0;
    for (const Target& target : targets_) {
        const double one = target.half_width_over_mean();
        if (std::isnan(one)) return undefined;
        largest = std::max(largest, one);
    }
    return largest;
}

void PrecisionStop::Target::add(const std::vector<double>& values) {
    const double own = values[static_cast<std::size_t>(case_index)];
    const double base = minus ? values[static_cast<std::size_t>(*minus)] : own;
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

}  // namespace floes
