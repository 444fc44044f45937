// A trend over all members is seen where no single member shows it.

#include "findings/steady.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "findings/answer.hpp"
#include "findings/example.hpp"

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
    const std::vector<JointTrend> trends = joint_trends(table);
    EXPECT_TRUE(trends[0].rises());
    EXPECT_NEAR(trends[0].load.over_window.estimate, 0.04 * 150, 1e-9);
    EXPECT_LT(trends[0].load.p, 1e-6);
    EXPECT_FALSE(trends[1].seen);  // slopes of 0
    EXPECT_THAT(trend_text(trends[0]), testing::StartsWith("the load rises by 6 N of 25 N over the measured window (24 "
                                                           "members, p = "));
    const std::vector<std::string> warnings = warnings_of(table, summarise(table));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], testing::StartsWith("Not steady: E30: the load rises by 6 N"));
}

TEST(JointTrend, OfMaximaIsSeenToo) {
    CampaignTable table = campaign(24, {0.05, -0.05});
    for (MemberRow& row : table.members) row.load.segment_maximum.back() -= row.case_index == 1 ? 20 : 0;
    const std::vector<JointTrend> trends = joint_trends(table);
    EXPECT_FALSE(trends[0].seen);
    EXPECT_TRUE(trends[1].seen);
    EXPECT_FALSE(trends[1].rises());  // falls
    EXPECT_THAT(trend_text(trends[1]), testing::StartsWith("the largest load of a segment falls by 20 N over"));
}

// A hundredth of a percent is there and does not matter; two percent do.
TEST(JointTrend, ThatIsSureAndNegligibleIsNoNews) {
    const double tiny = 0.0025 / 150;  // N/s: 0.01 % of 25 N over the window
    const CampaignTable table = campaign(24, {0.9 * tiny, tiny, 1.1 * tiny});
    const JointTrend small = joint_trends(table)[0];
    EXPECT_LT(small.load.p, 1e-12);
    EXPECT_TRUE(small.negligible());
    EXPECT_FALSE(small.seen);
    EXPECT_TRUE(warnings_of(table, summarise(table)).empty());
    const double two = 0.5 / 150;
    EXPECT_TRUE(joint_trends(campaign(24, {0.9 * two, two, 1.1 * two}))[0].rises());
}

TEST(JointTrend, OfSlopesOfBothSignsOrOfFewMembersIsNone) {
    EXPECT_FALSE(joint_trends(campaign(24, {0.05, -0.05}))[0].seen);
    EXPECT_FALSE(joint_trends(campaign(2, {0.05, 0.051}))[0].seen);
}

TEST(Stationary, IsSaidWithItsTestAndWhatItLeavesOpen) {
    CampaignTable table = campaign(24, {0.02, -0.02, 0.01, -0.01});
    const JointTrend none = joint_trends(table)[0];
    CaseRow about = table.cases[0];
    EXPECT_THAT(
        stationary_text("E30", none, about),
        testing::AllOf(testing::StartsWith("E30: no trend within this window. Slopes of 24 members, Student's t: "
                                           "the load changes by +0 % ["),
                       testing::HasSubstr("ends at an ice sheet")));
    about.far_end = FarEnd::never;
    EXPECT_THAT(stationary_text("E30", none, about),
                testing::AllOf(testing::StartsWith("E30: stationary, and ice comes as long as the run lasts."),
                               testing::Not(testing::HasSubstr("passage"))));
    const JointTrend few = joint_trends(campaign(3, {0.08, -0.08, 0.07}))[0];
    EXPECT_THAT(stationary_text("E30", few, about), testing::StartsWith("E30: not shown to be stationary"));
    const JointTrend rising = joint_trends(campaign(24, {0.02, 0.05, 0.01, 0.08}))[0];
    EXPECT_EQ(stationary_text("E30", rising, about), "");
    EXPECT_EQ(end_text(about), "");
    EXPECT_THAT(end_text(table.cases[0]), testing::HasSubstr("field.far_end = \"never\""));
}

TEST(JointTrend, WarnsOfMembersFarAboveTheOthers) {
    CampaignTable table = campaign(12, {0.05, -0.05});
    table.members[5].load.mean *= 8;
    const std::vector<std::string> warnings = warnings_of(table, summarise(table));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0],
                testing::StartsWith("Members whose mean load is far above the others': 1 of 12 of E30 (5)."));
}

}  // namespace joint_trend_test
}  // namespace floes
