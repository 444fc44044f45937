#include "run/inventory.hpp"

#include <gtest/gtest.h>

#include "support/synthetic.hpp"

namespace floes {
namespace tally_test {

using std::chrono::seconds;

const Tally::Time begin{seconds(1000)};

Tally tally_of(const Campaign& campaign, const std::vector<MemberRecord>& records = {}) {
    return {campaign, take_inventory(campaign, records, {}), begin};
}

MemberRecord failure(const Campaign& campaign, int number) {
    MemberRecord made = synthetic::failed_record(campaign, number);
    made.attempt = campaign.run.attempts;
    return made;
}

TEST(Tally, AddsTheSessionToWhatWasThere) {
    const Campaign campaign = synthetic::campaign();
    Tally tally = tally_of(campaign, {synthetic::record(campaign, 0), failure(campaign, 4)});
    EXPECT_EQ(tally.done(), 1);
    EXPECT_EQ(tally.failed(), 1);
    tally.kept(synthetic::record(campaign, 2));
    tally.kept(synthetic::record(campaign, 3));
    tally.kept(failure(campaign, 5));
    EXPECT_EQ(tally.computed(), 2);
    EXPECT_EQ(tally.set_aside(), 1);
    EXPECT_EQ(tally.done(), 3);
    EXPECT_EQ(tally.failed(), 2);
    EXPECT_EQ(tally.found().done, 1);
    EXPECT_EQ(tally.published().arrangements, campaign.arrangements);
}

TEST(Tally, HeartbeatHasFinishedCostAndWhoIsUnderWayLongestFirst) {
    const Campaign campaign = synthetic::campaign();
    Tally tally = tally_of(campaign, {synthetic::record(campaign, 0)});
    tally.started(1, 1, begin + seconds(5));
    tally.started(2, 3, begin + seconds(2));
    tally.started(5, 1, begin + seconds(1));
    tally.kept(synthetic::record(campaign, 5));
    const Heartbeat heartbeat = tally.heartbeat(begin + seconds(10));
    EXPECT_EQ(heartbeat.elapsed, 10);
    EXPECT_EQ(heartbeat.finished, 1);
    EXPECT_EQ(heartbeat.finished_cost, expected_cost(campaign, 5));
    EXPECT_DOUBLE_EQ(heartbeat.remaining_cost, tally.found().tasks_cost - expected_cost(campaign, 5));
    ASSERT_EQ(heartbeat.under_way.size(), 2u);
    EXPECT_EQ(heartbeat.under_way[0].number, 2);
    EXPECT_EQ(heartbeat.under_way[0].attempt, 3);
    EXPECT_EQ(heartbeat.under_way[0].seconds, 8);
    EXPECT_EQ(heartbeat.under_way[1].number, 1);
    EXPECT_EQ(heartbeat.under_way[1].seconds, 5);
}

TEST(Tally, KnowsHowFarThoseHaveComeThatRunLongest) {
    const Campaign campaign = synthetic::campaign(4);
    Tally tally = tally_of(campaign);
    for (int number = 0; number < 6; ++number) tally.started(number, 1, begin + seconds(10 * number));
    tally.note({{1, 30, 200}, {2, 20, 200}, {4, 10, 200}, {5, 5, 200}, {7, 1, 200}});  // 7 was not handed out
    EXPECT_EQ(tally.heartbeat(begin + seconds(60)).under_way[1].time, 30);
    EXPECT_TRUE(tally.longest(begin + seconds(60)).empty()) << "none runs long";
    const auto longest = tally.longest(begin + seconds(165));
    ASSERT_EQ(longest.size(), 3u);
    EXPECT_EQ(longest[0].number, 1) << "0 has not told";
    EXPECT_EQ(longest[0].time, 30);
    EXPECT_EQ(longest[0].end, 200);
    EXPECT_EQ(longest[2].number, 4) << "5 has run for less than two minutes";
}

TEST(Tally, SecondAttemptIsUnderWaySinceItsOwnBegin) {
    const Campaign campaign = synthetic::campaign();
    Tally tally = tally_of(campaign);
    tally.started(1, 1, begin + seconds(1));
    tally.started(1, 2, begin + seconds(4));
    const Heartbeat heartbeat = tally.heartbeat(begin + seconds(5));
    ASSERT_EQ(heartbeat.under_way.size(), 1u);
    EXPECT_EQ(heartbeat.under_way[0].attempt, 2);
    EXPECT_EQ(heartbeat.under_way[0].seconds, 1);
}

TEST(Tally, HeartbeatTellsOfTheTwentyLongestAtMost) {
    const Campaign campaign = synthetic::campaign(10);
    Tally tally = tally_of(campaign);
    for (int number = 0; number < 30; ++number) tally.started(number, 1, begin + seconds(number));
    const Heartbeat heartbeat = tally.heartbeat(begin + seconds(30));
    ASSERT_EQ(heartbeat.under_way.size(), 20u);
    EXPECT_EQ(heartbeat.under_way.front().number, 0);
    EXPECT_EQ(heartbeat.under_way.back().number, 19);
}

TEST(Tally, WhatLiesBeyondAPreciseCampaignIsNotPublished) {
    Campaign campaign = synthetic::campaign(60);
    campaign.stop.half_width = 0.25;
    campaign.stop.minimum = 10;
    campaign.stop.look_ahead = 2;
    constexpr int enough = 27;  // precision_test.cpp says why
    Tally tally = tally_of(campaign);
    tally.kept(failure(campaign, 3 * 40));
    EXPECT_EQ(tally.failed(), 1);
    for (int number = 3 * enough - 1; number >= 0; --number) {
        EXPECT_FALSE(tally.precise());
        tally.kept(synthetic::record(campaign, number));
    }
    EXPECT_TRUE(tally.precise());
    EXPECT_FALSE(tally.found().precise());
    EXPECT_EQ(tally.published().arrangements, enough);
    EXPECT_EQ(tally.failed(), 0);
    EXPECT_EQ(tally.set_aside(), 1);
}

}  // namespace tally_test
}  // namespace floes
