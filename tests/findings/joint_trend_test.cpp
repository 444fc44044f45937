// A trend over all members is seen where no single member shows it.

#include "findings/steady.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "findings/answer.hpp"
#include "findings/example.hpp"
#include "findings/summary.hpp"

namespace floes {
namespace joint_trend_test {

/// Of each case `members` members with these slopes, N/s, in turn, over a window of 150 s.
CampaignTable campaign(int members, const std::vector<double>& slopes) {
    CampaignTable table = example::campaign();
    table.members.clear();
    for (std::size_t k = 0; k < table.cases.size(); ++k) {
        table.cases[k].analysis.window = 150;
        for (int arrangement = 0; arrangement < members; ++arrangement) {
            MemberRow row = example::done(static_cast<int>(k), arrangement, 24 + arrangement % 3, 0.02, 3);
            row.load.trend = k == 0 ? slopes[static_cast<std::size_t>(arrangement) % slopes.size()] : 0;
            row.load.segment_maximum = {80.0 + arrangement % 2, 80.0, 80.0 + (arrangement / 2) % 2};
            table.members.push_back(row);
        }
    }
    return table;
}

TEST(JointTrend, IsSeenOverMembersOfWhichNoneIsUnsteady) {
    const CampaignTable table = campaign(24, {0.02, 0.05, 0.01, 0.08});
    const JointTrend trend = joint_trend(table, 0);
    EXPECT_TRUE(trend.rises());
    EXPECT_NEAR(trend.load.estimate, 0.04 * 150, 1e-9);
    EXPECT_EQ(joint_trend(table, 1).steadiness, Steadiness::steady);  // slopes of 0
    EXPECT_EQ(trend_text(trend), "the load rises, +24 % [+17, +31] of its mean over the measured window (24 members)");
    const std::vector<std::string> warnings = warnings_of(table, summarise(table));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], testing::StartsWith("Not steady, change through the window: E30: +24 % [+17, +31]."));
    EXPECT_THAT(warnings[0], testing::Not(testing::HasSubstr("E60")));
}

// Four members that rise by half of their load, in a campaign of one case and in one of fifty.
TEST(JointTrend, OfACaseIsTheSameInACampaignOfMany) {
    CampaignTable table = campaign(4, {0.07, 0.08, 0.085, 0.09});
    const JointTrend alone = joint_trend(table, 0);
    EXPECT_TRUE(alone.rises());
    const std::vector<MemberRow> members = table.members;
    for (int copy = 1; copy < 17; ++copy)
        for (std::size_t k = 0; k < 3; ++k) {
            table.cases.push_back(table.cases[k]);
            for (MemberRow row : members)
                if (row.case_index == static_cast<int>(k)) {
                    row.case_index = static_cast<int>(table.cases.size() - 1);
                    table.members.push_back(row);
                }
        }
    EXPECT_EQ(joint_trend(table, 0).load, alone.load);
    int rising = 0;
    for (const CaseSummary& row : summarise(table).cases) rising += row.trend.rises() ? 1 : 0;
    EXPECT_EQ(rising, 17);
    const std::vector<std::string> warnings = warnings_of(table, summarise(table));
    EXPECT_THAT(warnings.at(0), testing::HasSubstr("; and 14 cases more."));
}

TEST(JointTrend, OfMaximaIsSeenToo) {
    CampaignTable table = campaign(24, {0.05, -0.05});
    for (MemberRow& row : table.members) row.load.segment_maximum.back() -= row.case_index == 1 ? 20 : 0;
    EXPECT_EQ(joint_trend(table, 0).steadiness, Steadiness::not_known);
    const JointTrend falls = joint_trend(table, 1);
    EXPECT_EQ(falls.steadiness, Steadiness::falls);
    EXPECT_FALSE(falls.by_load);
    EXPECT_FALSE(falls.rises());
    EXPECT_THAT(trend_text(falls), testing::StartsWith("the largest load of a segment falls, -27 % ["));
}

TEST(JointTrend, IsNotKnownOfFewMembersOrWideIntervalsAndSaysSo) {
    for (const int members : {1, 2}) {
        const CampaignTable few = campaign(members, {0.05, 0.051});
        EXPECT_EQ(joint_trend(few, 0).steadiness, Steadiness::not_known);
        EXPECT_EQ(trend_text(joint_trend(few, 0)),
                  fmt::format("not known whether the load is steady, +{} % of its mean over the measured window ({})",
                              members == 1 ? 31 : 31, members == 1 ? "1 member" : "2 members"));
    }
    const CampaignTable wide = campaign(4, {0.05, -0.05, 0.06, -0.02});
    EXPECT_EQ(joint_trend(wide, 0).steadiness, Steadiness::not_known);
    EXPECT_EQ(warnings_of(wide, summarise(wide)).at(0),
              "Too few arrangements to call it steady within 10 %: E30: +6.1 % [-46, +58].");
}

// One member of twenty whose ice jams, however much its load rises, is no rise of the case.
TEST(JointTrend, OfOneMemberAloneIsNotSeen) {
    std::vector<double> slopes(20, 0.001);
    slopes[7] = 5;
    EXPECT_EQ(joint_trend(campaign(20, slopes), 0).steadiness, Steadiness::not_known);
}

TEST(Steadiness, IsSaidWithWhatTheIceAheadLetsOneConclude) {
    CampaignTable table = campaign(24, {0.002, -0.002, 0.001, -0.001});
    CaseRow about = table.cases[0];
    EXPECT_THAT(steady_text("E30", joint_trend(table, 0), about),
                testing::AllOf(testing::StartsWith("E30: the load is steady, +0 % ["),
                               testing::HasSubstr("ends at an ice sheet")));
    about.far_end = FarEnd::never;
    EXPECT_THAT(steady_text("E30", joint_trend(table, 0), about),
                testing::AllOf(testing::HasSubstr("Ice comes as long as the run lasts."),
                               testing::Not(testing::HasSubstr("passage"))));
    EXPECT_EQ(steady_text("E30", joint_trend(campaign(3, {0.08, -0.08, 0.07}), 0), about), "");
    EXPECT_EQ(steady_text("E30", joint_trend(campaign(24, {0.02, 0.05, 0.01, 0.08}), 0), about), "");
    EXPECT_EQ(end_text(about), "");
    EXPECT_THAT(end_text(table.cases[0]), testing::HasSubstr("field.far_end = \"never\""));
}

TEST(JointTrend, WarnsOfMembersFarAboveTheOthers) {
    CampaignTable table = campaign(12, {0});
    table.members[5].load.mean *= 8;
    const std::vector<std::string> warnings = warnings_of(table, summarise(table));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0],
                testing::StartsWith("Members whose mean load is far above the others': 1 of 12 of E30 (5)."));
}

}  // namespace joint_trend_test
}  // namespace floes
