// Campaigns that end when they are precise enough: after the same arrangement in any order of completion.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign_file/read_campaign_file.hpp"
#include "core/error.hpp"
#include "driver/campaign_status.hpp"
#include "driver/fakes.hpp"

namespace floes {
namespace {

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
    TemporaryFolder folder;
    Campaign made = campaign(0.25);
    made.stop.of = "mean_maximum_0.4s";
    fake::Run run(folder / "a.h5", made);
    EXPECT_EQ(run(fake::compute_out_of_order, Existing::refuse, 2), 0) << run.said;
    EXPECT_THAT(run.said, HasSubstr("precise enough after"));
}

TEST(Precision, EndsTheCampaignAfterTheSameArrangementOnAnyThreads) {
    for (const int threads : {1, 2, 5}) {
        TemporaryFolder folder;
        fake::Run run(folder / "a.h5", campaign(0.25));
        EXPECT_EQ(run(fake::compute_out_of_order, Existing::refuse, threads), 0) << run.said;
        EXPECT_THAT(run.said, HasSubstr("precise enough after 27 of at most 60 arrangements: half-width 23.5 %"));
        const CampaignTable table = read_campaign_file(run.file);
        ASSERT_EQ(table.members.size(), 3u * enough_for_a_quarter);
        for (const MemberRow& row : table.members) EXPECT_EQ(row.status, RowStatus::done);
    }
}

TEST(Precision, GoesOnWhenMoreIsAsked) {
    TemporaryFolder folder;
    fake::Run run(folder / "a.h5", campaign(0.25));
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
    TemporaryFolder folder;
    fake::Run run(folder / "a.h5", campaign(0.01));
    EXPECT_EQ(run(fake::compute), 0) << run.said;
    EXPECT_THAT(run.said,
                HasSubstr("all 60 arrangements are done and the half-width is 15.1 %, target 1 %; to continue, raise"));
    EXPECT_THAT(run.said, HasSubstr("% after 60 arrangements, target 1 %"));
    EXPECT_EQ(read_campaign_file(run.file).members.size(), 180u);
}

TEST(Precision, SaysThatItHadNotHeldLongEnough) {
    TemporaryFolder folder;
    fake::Run run(folder / "a.h5", campaign(0.25));
    run.campaign.arrangements = enough_for_a_quarter - 1;
    EXPECT_EQ(run(fake::compute), 0) << run.said;
    EXPECT_THAT(run.said, HasSubstr("target 25 %, but not met for stop.look_ahead = 2 arrangements in a row"));
}

TEST(Precision, RefusesARuleOfNoCase) {
    TemporaryFolder folder;
    fake::Run run(folder / "a.h5", campaign(0.25));
    run.campaign.stop.case_name = "E61";
    EXPECT_THROW(run(fake::compute), InputError);
    EXPECT_FALSE(std::filesystem::exists(run.file));
}

}  // namespace
}  // namespace floes
