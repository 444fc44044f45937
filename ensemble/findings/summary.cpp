#include "findings/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "statistics/distributions.hpp"

namespace floes {

Kind kind_of(const Quantity& quantity) {
    return {quantity.least, quantity.most, quantity.positive, quantity.unit == "N"};
}

namespace {

/// The mean of finite values with the interval of their kind, and how many of them stand out.
std::pair<Interval, std::size_t> mean_of_kind(const std::vector<double>& values, const Kind& kind) {
    const Interval plain = kind.positive ? positive_interval(values) : mean_interval(values);
    const Apart out = kind.load ? apart(values, Sides::above) : Apart{};
    // Student's limits can leave the range of the values; those of the bootstrap cannot.
    return {clipped(mixed_interval(values, plain, out, Sides::above), kind.least, kind.most), out.count()};
}

}  // namespace

std::vector<double> measured(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    return values;
}

bool says_something(double estimate, Limits limits, int runs, const Kind& kind) {
    constexpr double widest = 4;                                             // of the estimate
    if (limits.low <= kind.least && limits.high >= kind.most) return false;  // as wide as can be
    if (runs < fewest_for_interval || !std::isfinite(limits.low) || !std::isfinite(limits.high)) return false;
    const bool has_a_sign = kind.least < 0 && std::isfinite(kind.least);  // by its nature, as a correlation has
    const double size = has_a_sign ? limits.high - limits.low : estimate;
    return limits.high > limits.low && limits.high - limits.low <= widest * std::abs(size);
}

Estimate estimate(const Interval& found) {
    return {found.estimate, found.low, found.high};
}

Estimate estimate(const Interval& found, int runs, const Kind& kind) {
    return {found.estimate, found.low, found.high, says_something(found.estimate, {found.low, found.high}, runs, kind)};
}

Estimate over(const std::vector<double>& values, const Kind& kind) {
    const std::vector<double> known = measured(values);
    return estimate(mean_of_kind(known, kind).first, static_cast<int>(known.size()), kind);
}

Estimate over(const Sample& sample, const Members& members, const Quantity& quantity) {
    return over(sample.values(members, quantity), kind_of(quantity));
}

std::string unit_of(const Quantity& quantity) {
    return quantity.percent ? "share" : std::string{quantity.unit};
}

ResultColumn column_of(const Quantity& quantity, ResultColumn::Holds holds) {
    return {.key = std::string{quantity.key.view()},
            .words = quantity.for_programs ? std::string{} : std::string{quantity.label.view()},
            .unit = unit_of(quantity),
            .holds = holds,
            .decimals = quantity.percent || quantity.count ? 1 : -1};
}

std::string change_text(const Estimate& change, const Units& units) {
    const auto number = [&](double value) { return (value < 0 ? "" : "+") + units.number(value, "N"); };
    return fmt::format("{} {}{}", number(change.value), units.of("N").name,
                       change.said && std::isfinite(change.low)
                           ? fmt::format(" ({} to {})", number(change.low), number(change.high))
                           : "");
}

ResultColumn estimates(std::string key, std::string words, std::string unit, int decimals) {
    return {.key = std::move(key),
            .words = std::move(words),
            .unit = std::move(unit),
            .holds = ResultColumn::Holds::estimates,
            .decimals = decimals};
}

int arrangements_for(const Interval& found, int runs, double share) {
    constexpr int most = 10'000;
    constexpr double tail = 0.025;
    const double half = std::max(found.high - found.estimate, found.estimate - found.low);
    if (runs < 2 || !std::isfinite(half) || found.estimate == 0 || half == 0) return 0;
    const double sd = half * std::sqrt(runs) / student_t(runs - 1, tail);
    for (int n = fewest_for_interval; n < most; ++n)
        if (student_t(n - 1, tail) * sd / std::sqrt(n) <= share * std::abs(found.estimate)) return n;
    return most;
}

JointTrend joint_trend(const Sample& sample, std::size_t of_case) {
    const double window = sample.cases[of_case].analysis.window;
    std::vector<MemberTrend> members;
    for (const std::size_t member : sample.done(of_case)) {
        std::span<const double> maxima = sample.along("averaged/segment_maximum", member, 0);
        if (maxima.empty()) maxima = sample.along("members/segment_maximum", member);
        members.push_back(member_trend(sample.value(member, quantity("mean_load")),
                                       sample.value(member, quantity("trend")) * window, maxima));
    }
    return joint_trend(members);
}

namespace {

CaseSummary summarise_case(const Sample& sample, const std::vector<Quantity>& known, std::size_t of_case) {
    CaseSummary row;
    row.about = sample.cases[of_case];
    for (std::size_t member = 0; member < sample.members(); ++member) {
        if (sample.case_of(member) != of_case) continue;
        const RowStatus status = sample.status(member);
        ++row.members;
        ++(status == RowStatus::done     ? row.done
           : status == RowStatus::failed ? row.failed_members
                                         : row.missing_members);
        row.not_steady += status == RowStatus::done && !sample.steady(member) ? 1 : 0;
    }
    row.trend = joint_trend(sample, of_case);
    const Members& done = sample.done(of_case);
    for (const Quantity& one : quantities)
        if (one.count)
            for (const double value : measured(sample.values(done, one)))
                row.totals[std::string{one.key.view()}] += static_cast<std::int64_t>(value);
    for (const Quantity& one : shown_in(known, Shown::in_summary)) {
        // An older version may not have measured it.
        const auto [mean, standing_out] = mean_of_kind(measured(sample.values(done, one)), kind_of(one));
        row.estimates[std::string{one.key.view()}] = {mean, standing_out};
    }
    return row;
}

}  // namespace

MemberCounts Summary::counts() const {
    MemberCounts all;
    for (const CaseSummary& row : cases) {
        all.members += row.members;
        all.done += row.done;
        all.failed_members += row.failed_members;
        all.missing_members += row.missing_members;
        all.not_steady += row.not_steady;
    }
    return all;
}

Summary summarise(const Sample& sample) {
    Summary summary;
    summary.title = sample.title;
    summary.quantities = sample.quantities();
    for (std::size_t k = 0; k < sample.cases.size(); ++k)
        summary.cases.push_back(summarise_case(sample, summary.quantities, k));
    for (std::size_t member = 0; member < sample.members(); ++member)
        if (sample.status(member) == RowStatus::failed)
            summary.failed.push_back({static_cast<int>(member), sample.reason(member)});
    return summary;
}

std::string label_list(const Summary& summary, const std::vector<std::size_t>& cases) {
    std::vector<std::string> names;
    for (const std::size_t k : cases) names.push_back(summary.label_of(k));
    return name_list(names);
}

std::vector<std::pair<std::string, std::string>> case_legend(const Summary& summary) {
    constexpr std::size_t most = 12;
    std::vector<std::pair<std::string, std::string>> legend;
    if (summary.cases.size() > most) return legend;
    for (std::size_t k = 0; k < summary.cases.size(); ++k) legend.emplace_back(colour(k), summary.label_of(k));
    return legend;
}

std::size_t case_index(const Summary& summary, std::string_view name) {
    std::vector<std::string> names;
    for (std::size_t index = 0; index < summary.cases.size(); ++index) {
        if (summary.cases[index].about.name == name) return index;
        names.push_back(summary.cases[index].about.name);
    }
    throw InputError(fmt::format("There is no case '{}' in this campaign; its cases are {}.", name, name_list(names)));
}

double difference_percent(const Summary& summary, std::size_t of_case, std::size_t reference,
                          const Quantity& quantity) {
    const double value = summary.cases.at(of_case).of(quantity).estimate;
    const double base = summary.cases.at(reference).of(quantity).estimate;
    return base == 0 ? std::numeric_limits<double>::quiet_NaN() : 100 * (value - base) / base;
}

}  // namespace floes
