// The stop rule on a design load: members with peaks of a known exponential tail.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/units.hpp"
#include "inference/known_members.hpp"
#include "inference/precision_stop.hpp"

namespace floes {
namespace load_stop_test {

using testing::HasSubstr;

std::vector<MemberOutputs> members(int count, std::uint32_t seed = 5, double rise = 0) {
    RandomStream random{91, seed, StreamId::monte_carlo, 0};
    std::vector<MemberOutputs> made;
    for (int k = 0; k < count; ++k) made.push_back(known::member(random, 1, rise));
    return made;
}

using Estimator = DesignLoad(const std::vector<PeakRow>&, const Measured&, const Exposure&);

/// What floes design gives by both tails for the first `count` members.
DesignLoadEstimate estimate(const std::vector<MemberOutputs>& all, int count, const StopRule& rule,
                            Estimator& by = load_by_both_tails) {
    std::vector<PeakRow> rows;
    double mean = 0;
    for (int k = 0; k < count; ++k) {
        const MemberOutputs& one = all[static_cast<std::size_t>(k)];
        rows.push_back({one.averaged[0].peaks, one.averaged[0].segment_maximum});
        mean += one.load.mean;
    }
    const Measured measured{known::window, known::window / 3, known::separation, mean / count};
    const double p = rule.quantile == 0 ? 0.9 : rule.quantile;
    return by(rows, measured, {.time = rule.exposure, .probabilities = {p}}).estimates.front();
}

double half_width(const LoadFigure& figure) {
    return std::max(figure.interval.high - figure.value, figure.value - figure.interval.low) / figure.value;
}

TEST(LoadStop, StopsWhenTheIntervalOfTheDesignLoadSaysSoAndNotBefore) {
    const Campaign campaign = known::load_campaign(0.5);
    const std::vector<MemberOutputs> all = members(400);
    PrecisionStop stop(campaign);
    int judged = 0, judgements = 0;
    for (int k = 0; !stop.met(); ++k) {
        ASSERT_LT(k, 400);
        stop.put_member(k, 0, &all[static_cast<std::size_t>(k)]);
        if (stop.judged() == judged) continue;
        judged = stop.judged();
        ++judgements;
        EXPECT_EQ(judged, k + 1);
        EXPECT_EQ(judged % campaign.stop.batch, 0);
        const double found = half_width(estimate(all, judged, campaign.stop).quantiles[0]);
        EXPECT_EQ(stop.achieved(), found) << judged;
        EXPECT_TRUE(!stop.met() || (found <= 0.5 && judged >= 59)) << judged;
    }
    EXPECT_LE(half_width(estimate(all, stop.arrangements(), campaign.stop).quantiles[0]), 0.5);
    EXPECT_GT(half_width(estimate(all, 59, campaign.stop).quantiles[0]), 0.5);
    EXPECT_GT(stop.arrangements(), 59);
    EXPECT_LE(judgements, 12);
    const LoadFigure load = estimate(all, stop.arrangements(), campaign.stop, design_load).quantiles[0];
    EXPECT_EQ(stop.achieved(), half_width(load));
    const double truth = known::largest_of_alike(campaign.stop.exposure, 0.9);
    EXPECT_LE(load.interval.low, truth);
    EXPECT_GE(load.interval.high, truth);
}

TEST(LoadStop, StopsAtTheSameNumberInAnyOrderOfArrival) {
    const Campaign campaign = known::load_campaign(1.2);
    const std::vector<MemberOutputs> all = members(300);
    std::optional<int> first;
    for (const int shuffle : {1, 7, 97}) {  // within blocks of that many, which is no divisor of 300
        PrecisionStop stop(campaign);
        std::vector<int> order(300);
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t from = 0; from < order.size(); from += static_cast<std::size_t>(shuffle))
            std::reverse(order.begin() + static_cast<std::ptrdiff_t>(from),
                         order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), from + shuffle)));
        for (const int k : order) stop.put_member(k, 0, &all[static_cast<std::size_t>(k)]);
        EXPECT_TRUE(stop.met());
        if (!first) first = stop.arrangements();
        EXPECT_EQ(stop.arrangements(), *first);
    }
    EXPECT_LT(*first, 300);
}

TEST(LoadStop, AFailedMemberIsNoGapAndNoPeak) {
    Campaign campaign = known::load_campaign(5);
    campaign.stop.minimum = 20;
    campaign.stop.look_ahead = 0;
    std::vector<MemberOutputs> all = members(40);
    PrecisionStop stop(campaign);
    for (int k = 0; k < 40; ++k) stop.put_member(k, 0, k == 3 ? nullptr : &all[static_cast<std::size_t>(k)]);
    ASSERT_TRUE(stop.met());
    EXPECT_EQ(stop.arrangements(), 20);
    all.erase(all.begin() + 3);
    EXPECT_EQ(stop.achieved(), half_width(estimate(all, 19, campaign.stop).quantiles[0]));
}

TEST(LoadStop, MayBeOfTheExpectedLargest) {
    Campaign campaign = known::load_campaign(5);
    campaign.stop.quantile = 0;
    campaign.stop.exposure = 10 * unit::hour;
    campaign.stop.minimum = 20;
    campaign.stop.look_ahead = 0;
    const std::vector<MemberOutputs> all = members(20);
    PrecisionStop stop(campaign);
    for (int k = 0; k < 20; ++k) stop.put_member(k, 0, &all[static_cast<std::size_t>(k)]);
    EXPECT_EQ(stop.achieved(), half_width(estimate(all, 20, campaign.stop).expected));
}

TEST(LoadStop, DoesNotStopWhileTheLoadRises) {
    Campaign campaign = known::load_campaign(0.9);
    campaign.stop.minimum = 20;
    const std::vector<MemberOutputs> all = members(60, 5, 2);
    PrecisionStop stop(campaign);
    for (int k = 0; k < 60; ++k) stop.put_member(k, 0, &all[static_cast<std::size_t>(k)]);
    EXPECT_FALSE(stop.met());
    EXPECT_TRUE(std::isnan(stop.achieved()));
    EXPECT_THAT(stop.obstacle(), HasSubstr("case one: the load rises, +"));
    EXPECT_THAT(stop.obstacle(), HasSubstr(" (60 members), so it has no design value"));
}

TEST(LoadStop, DoesNotStopWithTooFewPeaks) {
    Campaign campaign = known::load_campaign(0.9);
    campaign.stop.minimum = 20;
    std::vector<MemberOutputs> all = members(60);
    PrecisionStop stop(campaign);
    for (int k = 0; k < 60; ++k) {
        all[static_cast<std::size_t>(k)].averaged[0].peaks.resize(1);
        stop.put_member(k, 0, &all[static_cast<std::size_t>(k)]);
    }
    EXPECT_FALSE(stop.met());
    EXPECT_THAT(stop.obstacle(), HasSubstr("peaks above the threshold are too few for a tail"));
}

/// Only the case that the rule names decides; a look changes nothing but what is seen.
TEST(LoadStop, WatchesTheCaseThatIsNamed) {
    Campaign campaign = known::load_campaign(5);
    campaign.stop.minimum = 20;
    campaign.stop.look_ahead = 0;
    campaign.cases.push_back({"silent", campaign.cases[0].scenario});
    const auto after = [&](int count, bool looks) {
        const std::vector<MemberOutputs> all = members(20);
        PrecisionStop stop(campaign);
        MemberOutputs silent;
        silent.averaged.emplace_back().time = 1;
        for (int k = 0; k < count; ++k) {
            stop.put_member(k, 1, &silent);
            stop.put_member(k, 0, &all[static_cast<std::size_t>(k)]);
            if (looks && k % 6 == 0) stop.look();
        }
        return stop;
    };
    EXPECT_FALSE(after(20, false).met());
    EXPECT_THAT(after(20, false).obstacle(), HasSubstr("case silent: "));
    campaign.stop.case_name = "one";
    EXPECT_TRUE(after(20, false).met());
    EXPECT_EQ(after(20, false).arrangements(), after(20, true).arrangements());
    EXPECT_EQ(after(13, false).judged(), 0);
    EXPECT_EQ(after(13, true).judged(), 13);
}

}  // namespace load_stop_test
}  // namespace floes
