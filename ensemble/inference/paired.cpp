#include "inference/paired.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <fmt/format.h>
#include <boost/math/distributions/non_central_t.hpp>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "statistics/distributions.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

constexpr int most_arrangements = 1'000'000;

double sample_variance(std::span<const double> values) {
    if (values.size() < 2) return undefined;
    return squares_about(values, mean_of(values)) / (static_cast<double>(values.size()) - 1);
}

}  // namespace

PairedComparison compare_paired(std::span<const double> first, std::span<const double> second) {
    if (first.size() != second.size()) {
        throw InputError(fmt::format("{} values cannot be paired with {}.", first.size(), second.size()));
    }
    std::vector<double> differences(first.size());
    std::ranges::transform(second, first, differences.begin(), std::minus<>{});
    const Interval plain = mean_interval(differences);
    PairedComparison found;
    found.arrangements = static_cast<int>(differences.size());
    found.difference = plain.estimate;
    found.t_interval = {plain.low, plain.high};
    found.apart = apart(differences, Sides::both);
    const Interval interval = mixed_interval(differences, plain, found.apart, Sides::both);
    found.interval = {interval.low, interval.high};
    const double variance = sample_variance(differences);
    found.sd = std::sqrt(variance);
    found.t = found.difference / (found.sd / std::sqrt(static_cast<double>(differences.size())));
    if (std::isfinite(found.t)) {
        found.t_p = 2 * student_above(std::abs(found.t), static_cast<double>(differences.size() - 1));
    } else {
        found.t = found.t_p = undefined;
    }
    const SignedRank ranks = wilcoxon_signed_rank(differences);
    found.rank_sum = ranks.rank_sum;
    found.wilcoxon_p = ranks.p;
    found.wilcoxon_exact = ranks.exact;
    const double unrelated = sample_variance(first) + sample_variance(second);
    found.variance_saved = unrelated > 0 ? 1 - variance / unrelated : undefined;
    return found;
}

MeanDifference difference_of_means(std::span<const double> first, std::span<const double> second) {
    FLOES_EXPECTS(!first.empty() && !second.empty());
    const double mean = mean_interval(second).estimate - mean_interval(first).estimate;
    if (std::min(first.size(), second.size()) < 2) return {mean, undefined, {undefined, undefined}};
    const auto error = [](std::span<const double> sample) {
        return sample_variance(sample) / static_cast<double>(sample.size());
    };
    const double one = error(first);
    const double other = error(second);
    const double all = one + other;
    if (!(all > 0)) return {mean, 0, {undefined, undefined}};
    const double freedom =
        all * all /
        (one * one / static_cast<double>(first.size() - 1) + other * other / static_cast<double>(second.size() - 1));
    const double half = student_t(freedom, beyond_limit) * std::sqrt(all);
    return {mean, std::sqrt(all), {mean - half, mean + half}};
}

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!std::isnan(p[i])) order.push_back(i);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
    std::vector<double> adjusted(p.size(), undefined);
    double largest = 0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        largest = std::max(largest, p[order[rank]] * static_cast<double>(order.size() - rank));
        adjusted[order[rank]] = std::min(1.0, largest);
    }
    return adjusted;
}

double power_of_paired_test(int pairs, double difference, double sd) {
    FLOES_EXPECTS(pairs >= 2);
    const double freedom = pairs - 1;
    const double noncentrality = std::abs(difference) / sd * std::sqrt(static_cast<double>(pairs));
    const double limit = student_t(freedom, beyond_limit);
    if (noncentrality > std::max(30.0, 10 * limit)) return 1;  // to double precision; the series below would be slow
    const boost::math::non_central_t shifted(freedom, noncentrality);
    return boost::math::cdf(boost::math::complement(shifted, limit)) + boost::math::cdf(shifted, -limit);
}

int arrangements_to_resolve(double difference, double sd, double power) {
    if (std::isnan(difference) || std::isnan(sd)) return 0;
    if (difference == 0) return most_arrangements;
    if (sd == 0) return 2;
    const auto enough = [&](int pairs) { return power_of_paired_test(pairs, difference, sd) >= power; };
    int too_few = 1;
    int plenty = 2;
    while (!enough(plenty)) {
        if (plenty >= most_arrangements) return most_arrangements;
        too_few = plenty;
        plenty = std::min(2 * plenty, most_arrangements);
    }
    while (plenty - too_few > 1) {
        const int middle = too_few + (plenty - too_few) / 2;
        (enough(middle) ? plenty : too_few) = middle;
    }
    return plenty;
}

namespace {

constexpr std::size_t most_for_exact = 50;

/// Twice the rank of each magnitude, ties sharing the mean of theirs: whole numbers.
std::vector<int> doubled_ranks(std::span<const double> differences) {
    std::vector<std::size_t> order(differences.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto magnitude = [&](std::size_t index) { return std::abs(differences[index]); };
    std::ranges::stable_sort(order, {}, magnitude);
    std::vector<int> ranks(differences.size());
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin;
        while (end < order.size() && magnitude(order[end]) == magnitude(order[begin])) ++end;
        for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = static_cast<int>(begin + 1 + end);
        begin = end;
    }
    return ranks;
}

/// P(sum of the ranks of positive differences <= smaller) if both signs are equally likely. Counts are exact up to
/// 2^53; above that only rounding is lost.
double tail_by_counting(const std::vector<int>& ranks, std::int64_t smaller) {
    std::vector<double> chance(static_cast<std::size_t>(smaller) + 1, 0.0);
    chance[0] = 1;
    for (const int rank : ranks) {
        const auto step = static_cast<std::size_t>(rank);
        for (std::size_t sum = chance.size(); sum-- > 0;) {
            chance[sum] = 0.5 * (chance[sum] + (sum >= step ? chance[sum - step] : 0.0));
        }
    }
    return std::accumulate(chance.begin(), chance.end(), 0.0);
}

}  // namespace

SignedRank wilcoxon_signed_rank(std::span<const double> differences) {
    std::vector<double> moved(differences.begin(), differences.end());
    std::erase(moved, 0.0);
    if (moved.empty()) return {undefined, undefined, true};
    const std::vector<int> ranks = doubled_ranks(moved);
    std::int64_t positive = 0;
    double squares = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (moved[i] > 0) positive += ranks[i];
        squares += 0.25 * ranks[i] * static_cast<double>(ranks[i]);
    }
    const std::int64_t all = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
    const std::int64_t smaller = std::min(positive, all - positive);
    const double rank_sum = 0.5 * static_cast<double>(smaller);
    if (moved.size() <= most_for_exact) return {rank_sum, std::min(1.0, 2 * tail_by_counting(ranks, smaller)), true};
    const double z =
        (rank_sum - 0.25 * static_cast<double>(all)) / std::sqrt(0.25 * squares);  // mean and variance given the ranks
    return {rank_sum, 2 * normal_below(-std::abs(z)), false};
}

std::string_view name_of(Steadiness steadiness) {
    constexpr std::array<std::string_view, 4> names{"not known", "steady", "falls", "rises"};
    return names.at(static_cast<std::size_t>(steadiness));
}

Steadiness steadiness_of(const Interval& change, double load) {
    const double small = steady_change * std::abs(load);
    if (change.low > small) return Steadiness::rises;
    if (change.high < -small) return Steadiness::falls;
    // NaN is neither.
    return change.low >= -small && change.high <= small ? Steadiness::steady : Steadiness::not_known;
}

Interval mean_change(std::span<const double> changes) {
    constexpr std::size_t fewest = 3;
    Interval change = mean_interval(changes);
    if (changes.size() < fewest) change.low = change.high = undefined;
    return change;
}

MemberTrend member_trend(double mean, double rise, std::span<const double> maxima) {
    return {.mean = mean,
            .rise = rise,
            .growth = maxima.size() < 2 ? undefined : maxima.back() - maxima.front(),
            .largest = maxima.empty() ? 0 : mean_of(maxima)};
}

MemberTrend member_trend(const MemberOutputs& outputs, double window) {
    return member_trend(
        outputs.load.mean, outputs.load.trend * window,
        outputs.averaged.empty() ? outputs.load.segment_maximum : outputs.averaged.front().segment_maximum);
}

MemberTrend member_trend(const Response& response) {
    return member_trend(response.mean, response.rise, response.segment_maximum);
}

JointTrend joint_trend(std::span<const MemberTrend> members, std::string_view noun) {
    JointTrend one{.noun = noun, .members = static_cast<int>(members.size())};
    std::vector<double> rises, growths;
    for (const MemberTrend& member : members) {
        one.mean += member.mean / static_cast<double>(members.size());
        one.largest += member.largest / static_cast<double>(members.size());
        if (std::isfinite(member.rise)) rises.push_back(member.rise);
        if (std::isfinite(member.growth)) growths.push_back(member.growth);
    }
    one.load = mean_change(rises);
    one.maxima = mean_change(growths);
    const Steadiness of_load = steadiness_of(one.load, one.mean);
    const Steadiness of_maxima = steadiness_of(one.maxima, one.largest);
    one.by_load = of_maxima < Steadiness::falls || of_load >= of_maxima;
    one.steadiness = one.by_load ? of_load : of_maxima;
    return one;
}

std::string judged_words(const JointTrend& trend) {
    return fmt::format("{}{}", name_of(trend.steadiness), trend.by_load ? "" : " (segment maxima)");
}

std::string change_words(const JointTrend& trend) {
    const Interval& change = trend.judged();
    const double whole = trend.whole();
    const auto percent = [&](double part) {
        const double value = part / whole / unit::percent;
        return std::abs(value) < 10 ? fmt::format("{:+.2g}", value) : fmt::format("{:+.0f}", value);
    };
    return fmt::format(
        "{} %{}", percent(change.estimate),
        std::isfinite(change.low) ? fmt::format(" [{}, {}]", percent(change.low), percent(change.high)) : "");
}

std::string trend_text(const JointTrend& trend) {
    const std::string what =
        trend.by_load ? fmt::format("the {}", trend.noun) : fmt::format("the largest {} of a segment", trend.noun);
    return fmt::format("{}, {} of its mean over the measured window ({})",
                       trend.seen()                             ? fmt::format("{} {}", what, name_of(trend.steadiness))
                       : trend.steadiness == Steadiness::steady ? fmt::format("{} is steady", what)
                                                                : fmt::format("not known whether {} is steady", what),
                       change_words(trend), counted(trend.members, "member"));
}

}  // namespace floes
