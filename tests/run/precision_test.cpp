// Campaigns that end when they are precise enough: after the same arrangement in any order of completion.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "run/campaign_status.hpp"
#include "run/fakes.hpp"

namespace floes {
namespace precision_test {

using testing::HasSubstr;

/// Loads rise with the member's number: n arrangements have a spread of 0.58 of their mean, whatever n.
Campaign campaign(double half_width) {
    Campaign made = synthetic::campaign(60);
    made.stop.half_width = half_width;
    made.stop.minimum = 10;
    made.stop.look_ahead = 2;
    made.stop.batch = 4;
    return made;
}

/// Of the first case 3 √(n (n + 1) / 12) / (1.5 (n - 1) + 1) · t / √n is at most 0.25 from 25 on; and for two more.
constexpr int enough_for_a_quarter = 27;

// Its averaged maxima rise likewise.
TEST(Precision, MayBeOfAnAveragedLoad) {
    fake::RunAside run(campaign(0.25));
    run.campaign.stop.of = "mean_maximum_0.4s";
    EXPECT_EQ(run(fake::compute_out_of_order, Existing::refuse, 2), 0) << run.said;
    EXPECT_THAT(run.said, HasSubstr("precise enough after"));
}

TEST(Precision, EndsTheCampaignAfterTheSameArrangementOnAnyThreads) {
    for (const int threads : {1, 2, 5}) {
        fake::RunAside run(campaign(0.25));
        EXPECT_EQ(run(fake::compute_out_of_order, Existing::refuse, threads), 0) << run.said;
        EXPECT_THAT(run.said, HasSubstr("precise enough after 27 of at most 60 arrangements: half-width 23.5 %"));
        const CampaignTable table = read_campaign_file(run.file);
        ASSERT_EQ(table.members.size(), 3u * enough_for_a_quarter);
        for (const MemberRow& row : table.members) EXPECT_EQ(row.status, RowStatus::done);
    }
}

TEST(Precision, GoesOnWhenMoreIsAsked) {
    fake::RunAside run(campaign(0.25));
    run(fake::compute);
    EXPECT_EQ(run(fake::wait_for_stop, Existing::resume), 0) << run.said;  // nothing is left to compute
    EXPECT_EQ(read_campaign_file(run.file).members.size(), 3u * enough_for_a_quarter);
    run.campaign.stop.half_width = 0.2;
    EXPECT_EQ(run(fake::compute, Existing::resume), 0) << run.said;
    const std::size_t members = read_campaign_file(run.file).members.size();
    EXPECT_GT(members, 3u * enough_for_a_quarter);
    const CampaignStatus status = read_status(run.file);  // by the rule that was asked for last
    EXPECT_EQ(3 * static_cast<std::size_t>(status.stop->arrangements), members);
    EXPECT_EQ(status.cases[0].missing, 0);
}

TEST(Precision, SaysWhatWasReachedWhenArrangementsRunOut) {
    fake::RunAside run(campaign(0.01));
    EXPECT_EQ(run(fake::compute), 0) << run.said;
    EXPECT_THAT(run.said,
                HasSubstr("all 60 arrangements are done and the half-width is 15.1 %, target 1 %; to continue, raise"));
    EXPECT_THAT(run.said, HasSubstr("% after 60 arrangements, target 1 %"));
    EXPECT_EQ(read_campaign_file(run.file).members.size(), 180u);
}

TEST(Precision, SaysThatItHadNotHeldLongEnough) {
    fake::RunAside run(campaign(0.25));
    run.campaign.arrangements = enough_for_a_quarter - 1;
    EXPECT_EQ(run(fake::compute), 0) << run.said;
    EXPECT_THAT(run.said, HasSubstr("target 25 %, but not met for stop.look_ahead = 2 arrangements in a row"));
}

MemberResult compute_peaks(const Campaign& of, int number, std::stop_token) {
    std::this_thread::sleep_for(std::chrono::milliseconds((number * 7) % 11));
    return synthetic::record_with_peaks(of, number).result;
}

/// Of one case: as many peaks as 4 windows of exposure have, so that the tail is hardly extrapolated.
Campaign load_campaign(double half_width) {
    Campaign made = synthetic::campaign(60);
    made.cases.resize(1);
    made.cases[0].scenario.analysis.peak_separation = 0.01;  // peaks hide none
    made.stop = {.half_width = half_width, .of = "design_load", .minimum = 10, .look_ahead = 2, .batch = 4};
    made.stop.exposure = 4 * made.cases[0].scenario.analysis.window;
    made.stop.averaging = 0.4;
    return made;
}

TEST(Precision, OfADesignLoadEndsTheCampaignAfterTheSameArrangementOnAnyThreads) {
    std::optional<std::size_t> arrangements;
    for (const int threads : {1, 3}) {
        fake::RunAside run(load_campaign(0.6));
        EXPECT_EQ(run(compute_peaks, Existing::refuse, threads), 0) << run.said;
        EXPECT_THAT(run.said, HasSubstr("precise enough after "));
        const std::size_t members = read_campaign_file(run.file).members.size();
        EXPECT_EQ(members % 4, 0u);  // the end of a batch
        EXPECT_GE(members, 12u);
        EXPECT_LT(members, 60u);
        if (!arrangements) arrangements = members;
        EXPECT_EQ(members, *arrangements);
        const CampaignStatus status = read_status(run.file);
        EXPECT_TRUE(status.stop->met);
        EXPECT_EQ(status.stop->arrangements, static_cast<int>(members));
        EXPECT_LE(status.stop->achieved, 0.6);
        EXPECT_THAT(
            stop_sentence(*status.stop),
            HasSubstr("Half-width for the 90 % quantile of the largest load in 0.00133333 h, averaged over 0.4 s, "
                      "of every case: "));
    }
}

TEST(Precision, OfADesignLoadSaysWhatWasReachedWhenArrangementsRunOut) {
    fake::RunAside run(load_campaign(0.01));
    run.campaign.arrangements = 14;  // no end of a batch
    EXPECT_EQ(run(compute_peaks), 0) << run.said;
    EXPECT_THAT(run.said, HasSubstr("all 14 arrangements are done and the half-width is "));
    EXPECT_THAT(run.said, HasSubstr("% after 12 arrangements, target 1 %"));
    const CampaignStatus status = read_status(run.file);
    EXPECT_FALSE(status.stop->met);
    EXPECT_GT(status.stop->achieved, 0.1);
}

// Peaks that one member has are too few.
TEST(Precision, OfADesignLoadSaysWhyItIsNotKnown) {
    fake::RunAside run(load_campaign(0.5));
    run.campaign.arrangements = 12;
    EXPECT_EQ(run(fake::compute), 0) << run.said;
    EXPECT_THAT(run.said,
                HasSubstr("all 12 arrangements are done and the half-width is not known, target 50 %: case soft: "));
}

TEST(Precision, RefusesARuleOfNoCase) {
    fake::RunAside run(campaign(0.25));
    run.campaign.stop.case_name = "E61";
    EXPECT_THROW(run(fake::compute), InputError);
    EXPECT_FALSE(std::filesystem::exists(run.file));
}

}  // namespace precision_test
}  // namespace floes
