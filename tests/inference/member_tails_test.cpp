// Tails of members that differ: they are those of tails.hpp where members are alike, and find what members were drawn
// from.

#include "inference/tails.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inference/interval.hpp"
#include "inference/known_processes.hpp"

namespace floes {
namespace member_tails_test {

constexpr double window = 150;

UnlikeTail alike(TailKind kind, double shape) {
    UnlikeTail tail{.kind = kind, .threshold = 50, .origin = 30};
    tail.rate = 0.05;
    tail.scale = 20;
    tail.shape = shape;
    return tail;
}

/// The same as a tail of tails.hpp.
Tail plain(const UnlikeTail& tail) {
    const double d = tail.threshold - tail.origin;
    const double scale = tail.kind == TailKind::pareto
                             ? tail.scale
                             : std::pow(tail.scale * tail.shape * std::pow(d, tail.shape - 1), 1 / tail.shape);
    return {.kind = tail.kind,
            .threshold = tail.threshold,
            .rate = tail.rate,
            .origin = tail.origin,
            .scale = scale,
            .shape = tail.shape};
}

TEST(MemberTails, OfMembersThatAreAlikeAreTheTailsThemselves) {
    for (const UnlikeTail& tail :
         {alike(TailKind::pareto, -0.3), alike(TailKind::pareto, 0), alike(TailKind::pareto, 0.3),
          alike(TailKind::weibull, 0.8), alike(TailKind::weibull, 2)}) {
        EXPECT_NEAR(largest_at(tail, window, 100, std::log(0.9)) / quantile_of_largest(plain(tail), 100 * window, 0.9),
                    1, 1e-5);
        EXPECT_NEAR(mean_largest(tail, window, 100) / expected_largest(plain(tail), 100 * window), 1, 0.01);
        EXPECT_NEAR(log_below(tail, window, 100, 120), -100 * window * rate_above(plain(tail), 120), 1e-9);
    }
}

// A member that has such peaks nearly surely still counts by its time.
TEST(MemberTails, AreTheTailsThemselvesFarBelowTheThreshold) {
    const UnlikeTail tail = alike(TailKind::pareto, 0);
    const double expected =
        window * rate_above({.kind = TailKind::pareto, .rate = 0.05, .scale = 20}, 0) * std::exp(50.0 / 20);
    EXPECT_NEAR(log_below(tail, window, 0.01, 0) / (-0.01 * expected), 1, 1e-6);
}

TEST(MemberTails, OfMembersThatDifferAreHigher) {
    UnlikeTail varied = alike(TailKind::pareto, 0);
    varied.scatter = 0.3;
    EXPECT_GT(largest_at(varied, window, 100, std::log(0.9)),
              1.2 * largest_at(alike(TailKind::pareto, 0), window, 100, std::log(0.9)));
    // Of one member in twenty, five times as high, 100 windows have about five.
    UnlikeTail jams = alike(TailKind::pareto, 0);
    jams.out_share = 0.05;
    jams.out_factor = 5;
    EXPECT_NEAR(largest_at(jams, window, 100, std::log(0.9)) /
                    (5 * largest_at(alike(TailKind::pareto, 0), window, 5, std::log(0.9))),
                1, 0.03);
    // However many peaks such a member has, it is one member: without one the load stays low.
    EXPECT_GT(log_below(jams, window, 10, 250), 10 * std::log(0.95) - 0.01);
}

/// Twenty exponential peaks of 20 N above 10 N in a window, times each scale; above the threshold times the scale of
/// its class.
TailData data_of(const std::vector<double>& scales, std::size_t out, double threshold = 24) {
    RandomStream random{43, 0, StreamId::bootstrap, 0};
    TailData data{
        .members = {}, .window = window, .threshold = threshold, .out_threshold = 5 * threshold, .origin = 10};
    for (std::size_t k = 0; k < scales.size(); ++k) {
        MemberPeaks& member = data.members.emplace_back();
        member.stands_out = k < out;
        for (double at = known::exponential(random); at < 20; at += known::exponential(random)) {
            const double peak = scales[k] * (10 + 20 * known::exponential(random));
            if (peak <= (member.stands_out ? data.out_threshold : data.threshold)) continue;
            member.peaks.push_back(peak);
            member.weights.push_back(1);
        }
    }
    return data;
}

Limits range_of(const UnlikeTails& tails, double UnlikeTail::*figure) {
    std::vector<double> values;
    for (const UnlikeTail& tail : tails.draws) values.push_back(tail.*figure);
    std::ranges::sort(values);
    return {quantile_of_sorted(values, 0.005), quantile_of_sorted(values, 0.995)};
}

#define EXPECT_WITHIN(limits, value) \
    EXPECT_LE((limits).low, value);  \
    EXPECT_GE((limits).high, value)

TEST(MemberTails, FindWhatAlikeMembersWereDrawnFrom) {
    const UnlikeTails found = draw_tails(TailKind::pareto, data_of(std::vector<double>(60, 1.0), 0), {});
    ASSERT_FALSE(found.draws.empty());
    EXPECT_WITHIN(range_of(found, &UnlikeTail::scale), 20);
    EXPECT_WITHIN(range_of(found, &UnlikeTail::shape), 0);
    EXPECT_WITHIN(range_of(found, &UnlikeTail::rate), 20 / window * std::exp(-0.7));
    EXPECT_LT(range_of(found, &UnlikeTail::scatter).high, 0.25);
    const auto none = std::ranges::count(found.draws, 0.0, &UnlikeTail::scatter);
    EXPECT_GT(none, std::ssize(found.draws) / 2);  // more than before a peak was seen
}

// Above 80 N a member has 0.6 peaks, and half of them have none; these count as much as the others.
TEST(MemberTails, FindWhatMembersMostlyWithoutPeaksWereDrawnFrom) {
    const TailData data = data_of(std::vector<double>(400, 1.0), 0, 80);
    EXPECT_GT(std::ranges::count_if(data.members, [](const MemberPeaks& one) { return one.peaks.empty(); }), 190);
    for (const TailKind kind : {TailKind::pareto, TailKind::weibull}) {
        const UnlikeTails found = draw_tails(kind, data, {});
        ASSERT_FALSE(found.draws.empty());
        EXPECT_WITHIN(range_of(found, &UnlikeTail::rate), 20 / window * std::exp(-70.0 / 20));
        EXPECT_WITHIN(range_of(found, &UnlikeTail::scale), 20);
    }
}

TEST(MemberTails, FindHowMembersDiffer) {
    RandomStream random{44, 0, StreamId::bootstrap, 0};
    std::vector<double> scales(60);
    for (double& scale : scales) scale = std::exp(0.3 * known::normal(random));
    const UnlikeTails found = draw_tails(TailKind::weibull, data_of(scales, 0), {});
    EXPECT_WITHIN(range_of(found, &UnlikeTail::scatter), 0.3);
    EXPECT_GT(range_of(found, &UnlikeTail::scatter).low, 0.1);
}

TEST(MemberTails, FindTheFactorOfTheClassThatStandsOut) {
    std::vector<double> scales(40, 1.0);
    std::fill_n(scales.begin(), 3, 5);
    const UnlikeTails found = draw_tails(TailKind::pareto, data_of(scales, 3), {});
    EXPECT_WITHIN(range_of(found, &UnlikeTail::out_factor), 5);
    EXPECT_LT(range_of(found, &UnlikeTail::out_factor).high, 12);
    EXPECT_WITHIN(range_of(found, &UnlikeTail::out_share), 3.5 / 41);
}

TEST(MemberTails, OfNoPeaksAreNone) {
    TailData data = data_of(std::vector<double>(5, 1.0), 0);
    for (MemberPeaks& member : data.members) member.peaks.clear();
    for (MemberPeaks& member : data.members) member.weights.clear();
    EXPECT_TRUE(draw_tails(TailKind::pareto, data, {}).draws.empty());
}

}  // namespace member_tails_test
}  // namespace floes
