// Control variates as a finding: covariates of real arrangements, drawn as the campaign draws them.

#include "findings/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "arrangement/arrangement.hpp"
#include "core/random.hpp"

namespace floes {
namespace control_test {

Campaign small() {
    Scenario scenario;
    scenario.field.floes = 6;
    scenario.field.concentration = 0.3;
    Campaign campaign;
    campaign.name = "small";
    campaign.seed = 3;
    campaign.arrangements = 40;
    campaign.cases.push_back({"one", scenario});
    campaign.cases.push_back({"other", scenario});
    return campaign;
}

/// The mean load of the first case follows the local order, that of the second does not.
CampaignTable table_of(const Campaign& campaign) {
    CampaignTable table;
    table.title = campaign.name;
    for (const Case& one : campaign.cases) {
        CaseRow row;
        row.name = one.name;
        table.cases.push_back(row);
    }
    RandomStream random{1, 0, StreamId::bootstrap, 0};
    for (int arrangement = 0; arrangement < campaign.arrangements; ++arrangement) {
        const Arrangement made =
            make_arrangement(campaign.cases[0].scenario, campaign.seed, static_cast<std::uint32_t>(arrangement));
        for (int k = 0; k < 2; ++k) {
            MemberRow row;
            row.case_index = k;
            row.arrangement = arrangement;
            row.status = RowStatus::done;
            row.local_order = made.local_order;
            row.coverage_ahead = made.coverage_ahead;
            row.load.mean = 30 + (k == 0 ? 10 * made.local_order : 0) + random.uniform(-1, 1);
            row.load.mean_maximum = 100 + random.uniform(-10, 10);
            table.members.push_back(row);
        }
    }
    return table;
}

TEST(ControlFinding, CorrectsWhatFollowsTheOrderAndNothingElse) {
    const Campaign campaign = small();
    Evidence evidence = evidence_of(campaign, table_of(campaign));
    const Results found = find_control(evidence);
    ASSERT_EQ(data_rows(found).rows.size(), 6u);  // mean, mean maximum, failure ratio of two cases
    // Below the name of each quantity are the two cases.
    EXPECT_TRUE(std::get<bool>(found.at(1, "used").get()));
    EXPECT_GT(found.number(1, "r_squared_left_out"), 0.8);
    EXPECT_GT(found.number(1, "arrangements_saved"), 40);
    EXPECT_EQ(found.name(2, "quantity"), "mean_load");
    EXPECT_LT(found.number(2, "r_squared_left_out"), 0.2);
    EXPECT_EQ(found.name(7, "quantity"), "failure_ratio");
    EXPECT_FALSE(std::get<bool>(found.at(7, "used").get()));  // no floe broke
    const std::string told = text(std::vector{control_section(evidence)}, 100);
    EXPECT_THAT(told, testing::ContainsRegex("\nmean, N *\none "));
    EXPECT_THAT(told, testing::HasSubstr("off"));
}

TEST(ControlFinding, LeavesOutACaseThatLacksAQuantity) {
    const Campaign campaign = small();
    CampaignTable table = table_of(campaign);
    for (MemberRow& row : table.members)
        if (row.case_index == 1) row.load.mean_maximum = std::nan("");
    const Results found = find_control(evidence_of(campaign, table));
    EXPECT_TRUE(std::isfinite(found.number(4, "mean")));
    EXPECT_FALSE(std::isfinite(found.number(5, "mean")));
}

TEST(ControlFinding, HasNothingToDrawWherePosesAreGiven) {
    Campaign campaign = small();
    const CampaignTable table = table_of(campaign);
    for (Case& one : campaign.cases) one.scenario.arrangement.method = ArrangementMethod::file;
    EXPECT_TRUE(find_control(evidence_of(campaign, table)).empty());
}

}  // namespace control_test
}  // namespace floes
