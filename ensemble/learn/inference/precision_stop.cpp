#include "inference/precision_stop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "campaign/name_list.hpp"
#include "core/error.hpp"
#include "inference/interval.hpp"
#include "inference/mixed_mean.hpp"
#include "inference/unlike_members.hpp"

namespace floes {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double normal_half = 1.959963984540054;  // lower bound of t: a target missed with this is missed with t

constexpr int fewest_by_default = 20;  // with fewer, the scatter is itself uncertain

int minimum_of(const StopRule& rule) {
    return rule.minimum > 0 ? rule.minimum : std::max(fewest_by_default, members_to_see(rule.half_width));
}

int index_of(const std::string& name, const std::vector<std::string>& cases, const char* key) {
    const auto found = std::ranges::find(cases, name);
    if (found == cases.end()) {
        throw InputError(
            fmt::format("stop.{} names the case '{}', but the cases are {}.", key, name, name_list(cases)));
    }
    return static_cast<int>(found - cases.begin());
}

}  // namespace

PrecisionStop::PrecisionStop(const StopRule& rule, const std::vector<std::string>& cases,
                             const std::vector<int>& groups)
    : rule_(rule), minimum_(minimum_of(rule)), cases_(cases.size()) {
    const int count = static_cast<int>(cases.size());
    const auto share = [&](int one, int other) {
        return groups.empty() || groups.at(static_cast<std::size_t>(one)) == groups.at(static_cast<std::size_t>(other));
    };
    const auto no_pair = [&](const std::string& which) {
        return InputError(
            fmt::format("stop.contrast = \"{}\" asks for a paired difference, but {} do not share their arrangements: "
                        "cases can be paired if their fields have the same geometry and "
                        "campaign.common_arrangements is true.",
                        rule.contrast, which));
    };
    if (rule.case_name == "all") {
        for (int one = 0; one < count; ++one) targets_.push_back({.case_index = one, .minus = {}});
    } else if (rule.case_name != "none") {
        targets_.push_back({.case_index = index_of(rule.case_name, cases, "case"), .minus = {}});
    }
    if (rule.contrast == "all") {
        for (int one = 0; one < count; ++one) {
            for (int other = one + 1; other < count; ++other) {
                if (share(one, other)) targets_.push_back({.case_index = other, .minus = one});
            }
        }
        const bool any = std::ranges::any_of(targets_, [](const Target& target) { return target.minus.has_value(); });
        if (count > 1 && !any) throw no_pair("all cases");
    } else if (rule.contrast != "none") {
        const std::size_t minus = rule.contrast.find(" - ");
        if (minus == std::string::npos) {
            throw InputError(fmt::format(
                "stop.contrast = \"{}\" is not a contrast; write \"none\", \"all\", or two cases as in \"{} - {}\".",
                rule.contrast, cases.back(), cases.front()));
        }
        const int second = index_of(rule.contrast.substr(0, minus), cases, "contrast");
        const int first = index_of(rule.contrast.substr(minus + 3), cases, "contrast");
        if (!share(first, second)) throw no_pair("these two");
        targets_.push_back({.case_index = second, .minus = first});
    }
    if (targets_.empty()) {
        throw InputError(
            "stop.half_width_percent is given without stop.case or stop.contrast, which say what it applies to; write "
            "stop.case = \"all\".");
    }
}

void PrecisionStop::put(int arrangement, int case_index, double value) {
    if (met_ || arrangement < arrangements_) return;
    Waiting& row = waiting_[arrangement];
    row.values.resize(cases_, undefined);
    row.known.resize(cases_, false);
    const auto place = static_cast<std::size_t>(case_index);
    if (row.known[place]) return;
    row.values[place] = value;
    row.known[place] = true;
    const auto whole = [](const Waiting& one) { return std::ranges::find(one.known, false) == one.known.end(); };
    while (!met_ && !waiting_.empty() && waiting_.begin()->first == arrangements_ && whole(waiting_.begin()->second)) {
        take(waiting_.begin()->second.values);
        waiting_.erase(waiting_.begin());
    }
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
