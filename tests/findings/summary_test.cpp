// Statistics of a case from its members; a member without a result is missing, never zero.

#include "findings/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "findings/example.hpp"
#include "findings/pairs.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace summary_test {

TEST(Summary, CountsTheMembersOfEachCase) {
    const Summary summary = summarise(example::campaign());
    ASSERT_EQ(summary.cases.size(), 3u);
    const CaseSummary& whole = summary.cases[0];
    EXPECT_EQ(whole.about.name, "E30");
    EXPECT_EQ(whole.members, 4);
    EXPECT_EQ(whole.done, 4);
    EXPECT_EQ(whole.not_steady, 1);
    const CaseSummary& partial = summary.cases[1];
    EXPECT_EQ(partial.members, 4);
    EXPECT_EQ(partial.done, 2);
    EXPECT_EQ(partial.failed_members, 1);
    EXPECT_EQ(partial.missing_members, 1);
    EXPECT_EQ(partial.not_steady, 0);
    EXPECT_FALSE(summary.complete());
    ASSERT_EQ(summary.failed.size(), 1u);
    EXPECT_EQ(summary.failed[0].member, 4);
    EXPECT_EQ(summary.failed[0].reason, "floe 3 sank");
}

// 26, 28, 24, 30 N: mean 27, s = √(20/3), t(3) = 3.18244630528371 (python3 -c "from scipy.stats import t;
// print(t.ppf(.975, 3))")
TEST(Summary, TakesEachArrangementAsOneValue) {
    const CaseSummary row = summarise(example::campaign()).cases[0];
    const double s = std::sqrt(20.0 / 3.0);
    EXPECT_DOUBLE_EQ(row.of(quantity("mean_load")).estimate, 27);
    EXPECT_NEAR(row.of(quantity("mean_load")).low, 27 - 3.18244630528371 * s / 2, 1e-8);
    EXPECT_NEAR(row.of(quantity("mean_load")).prediction_high, 27 + 3.18244630528371 * s * std::sqrt(1.25), 1e-8);
    EXPECT_DOUBLE_EQ(row.of(quantity("sd_load")).estimate, 13.5);
    EXPECT_DOUBLE_EQ(row.of(quantity("maximum_load")).estimate, 135);
    EXPECT_DOUBLE_EQ(row.of(quantity("mean_maximum")).estimate, 108);
    EXPECT_DOUBLE_EQ(row.of(quantity("sd_maximum")).estimate, 28);
    EXPECT_DOUBLE_EQ(row.of(quantity("failure_ratio")).estimate, 0.02);
}

TEST(Summary, LeavesMembersWithoutAResultOut) {
    const CaseSummary row = summarise(example::campaign()).cases[1];
    EXPECT_DOUBLE_EQ(row.of(quantity("mean_load")).estimate, 32);
    EXPECT_TRUE(std::isfinite(row.of(quantity("mean_load")).low));
    EXPECT_EQ(row.totals.at("failures_bending"), 11);
    EXPECT_EQ(row.totals.at("failures_shear"), 2);
    EXPECT_EQ(row.totals.at("failures_compression"), 0);
}

TEST(Summary, CutsTheFailureRatioToItsRange) {
    const Interval ratio = summarise(example::campaign()).cases[2].of(quantity("failure_ratio"));
    EXPECT_EQ(ratio.estimate, 0.5);
    EXPECT_EQ(ratio.low, 0.0);
    EXPECT_EQ(ratio.high, 1.0);
    EXPECT_EQ(ratio.prediction_low, 0.0);
    EXPECT_EQ(ratio.prediction_high, 1.0);
}

TEST(Summary, OfACaseWithoutResultsIsUndefined) {
    CampaignTable table = example::campaign();
    for (MemberRow& member : table.members)
        member = example::without_result(member.case_index, 0, RowStatus::failed, "x");
    const Summary summary = summarise(table);
    EXPECT_TRUE(summary.complete());
    for (const CaseSummary& row : summary.cases) {
        EXPECT_EQ(row.done, 0);
        EXPECT_TRUE(row.totals.empty());
        for (const Quantity& one : shown_in(summary.quantities, Shown::in_summary))
            EXPECT_TRUE(std::isnan(row.of(one).estimate));
    }
}

// A quantity that is younger than the file, or than some of its journal.
TEST(Summary, LeavesOutWhatADoneMemberDoesNotHave) {
    CampaignTable table = example::campaign();
    table.members[0].load.sd = std::nan("");
    const Summary summary = summarise(table);
    EXPECT_DOUBLE_EQ(summary.cases[0].of(quantity("sd_load")).estimate, (28 + 24 + 30) / 6.0);
    EXPECT_EQ(summary.cases[0].done, 4);
    const std::vector<PairRow> pairs = compare_pairs(evidence_of({}, table));
    const auto of_sd =
        std::ranges::find_if(pairs, [](const PairRow& row) { return row.quantity.key.view() == "sd_load"; });
    EXPECT_EQ(of_sd->found.arrangements, pairs.front().found.arrangements - 1);
    for (MemberRow& row : table.members) row.load.sd = std::nan("");
    EXPECT_TRUE(std::isnan(summarise(table).cases[0].of(quantity("sd_load")).estimate));
    EXPECT_NO_THROW(compare_pairs(evidence_of({}, table)));
}

TEST(Summary, OfOneArrangementHasNoLimits) {
    CampaignTable table = example::campaign();
    table.members.resize(3);
    const Summary summary = summarise(table);
    EXPECT_TRUE(summary.complete());
    EXPECT_EQ(summary.cases[0].of(quantity("mean_load")).estimate, 26);
    EXPECT_TRUE(std::isnan(summary.cases[0].of(quantity("mean_load")).low));
    EXPECT_TRUE(std::isnan(summary.cases[0].of(quantity("failure_ratio")).prediction_high));
}

// The brackets of Table 3, which print the size alone: 12.5 and 6.5 % for the mean, 20.8 and 2.9 % for the mean
// maximum.
TEST(Summary, ComparesAsTable3Does) {
    CampaignTable table = example::campaign();
    table.members = {example::done(0, 0, 26.50, 0.106, 0), example::done(1, 0, 30.28, 0.101, 0),
                     example::done(2, 0, 28.32, 0.175, 0)};
    table.members[0].load.mean_maximum = 93.39;
    table.members[1].load.mean_maximum = 117.94;
    table.members[2].load.mean_maximum = 121.38;
    const Summary summary = summarise(table);
    const std::size_t reference = case_index(summary, "E60");
    EXPECT_EQ(reference, 1u);
    const Quantity& mean = quantity("mean_load");
    const Quantity& mean_maximum = quantity("mean_maximum");
    const Quantity& ratio = quantity("failure_ratio");
    EXPECT_NEAR(difference_percent(summary, 0, reference, mean), -12.5, 0.05);
    EXPECT_NEAR(difference_percent(summary, 2, reference, mean), -6.5, 0.05);
    EXPECT_NEAR(difference_percent(summary, 0, reference, mean_maximum), -20.8, 0.05);
    EXPECT_NEAR(difference_percent(summary, 2, reference, mean_maximum), 2.9, 0.05);
    EXPECT_EQ(difference_percent(summary, 1, reference, mean), 0.0);
    table.members[1].failure_ratio = 0;
    EXPECT_TRUE(std::isnan(difference_percent(summarise(table), 0, reference, ratio)));
}

TEST(Summary, NamesTheCasesThereAre) {
    const Summary summary = summarise(example::campaign());
    EXPECT_EQ(refusal([&] { case_index(summary, "E61"); }),
              "There is no case 'E61' in this campaign; its cases are E30, E60, E200.");
}

}  // namespace summary_test
}  // namespace floes
