// What of the scatter of single runs is of their arrangement, and what of their windows.

#include "findings/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "findings/evidence.hpp"
#include "findings/example.hpp"
#include "support/synthetic.hpp"

namespace floes {
namespace scatter_test {

/// Two cases over 20 arrangements: mean loads of 20 and 40 N that vary by `common` with the arrangement, and by `own`
/// with the member, each to either side.
CampaignTable table_of(double common, double own) {
    CampaignTable table = example::campaign();
    table.cases.resize(2);
    table.members.clear();
    for (int k = 0; k < 2; ++k)
        for (int arrangement = 0; arrangement < 20; ++arrangement) {
            const double level = 20.0 * (k + 1);
            const double mean = level * (1 + (arrangement % 2 == 0 ? common : -common) +
                                         ((arrangement / 2 + k * (arrangement / 4)) % 2 == 0 ? own : -own));
            MemberRow row = example::done(k, arrangement, mean, 0.1, 2);
            row.load.sd = 0.5 * level;
            row.load.segment_maximum = {4 * level, 5 * level, 6 * level};
            table.members.push_back(row);
        }
    return table;
}

/// The first two cases of it share their arrangements.
Campaign campaign() {
    Campaign made = synthetic::campaign(20);
    made.cases.resize(2);
    return made;
}

TEST(Scatter, IsOfArrangementsWhereCasesGoTogether) {
    const Results found = find_scatter(evidence_of(campaign(), table_of(0.1, 0.001)), {});
    ASSERT_EQ(found.rows.size(), 3u);
    EXPECT_GT(found.number(0, "arrangement_share"), 0.99);
    EXPECT_NEAR(found.number(0, "sd_over_mean"), 0.1 * std::sqrt(20 / 19.0), 1e-3);
    EXPECT_EQ(found.number(0, "arrangements"), 20);
    EXPECT_TRUE(std::isnan(found.number(0, "time_share")));         // no histories
    EXPECT_TRUE(std::isnan(found.number(2, "arrangement_share")));  // broken floes are all the same
}

// 25 effective samples of a scatter of half the mean are a tenth of the mean.
TEST(Scatter, IsOfWindowsWhereTheyAreShort) {
    SteadyReport steady;
    for (int member = 0; member < 40; ++member) steady.members.push_back({member, {}, 1, 25});
    const Results found = find_scatter(evidence_of(campaign(), table_of(0.1, 0)), steady);
    EXPECT_NEAR(found.number(0, "time_share"), 19 / 20.0, 1e-9);
    const std::string told = text(std::vector{scatter_section(found)}, 400);
    EXPECT_THAT(told, testing::HasSubstr("2 cases x 20 arrangements"));
    EXPECT_THAT(told, testing::ContainsRegex("mean +10.3 +100 \\[.* 95\n"));
    const auto json_told = nlohmann::json::parse(json(std::vector{scatter_section(found)}));
    EXPECT_EQ(json_told.at("scatter").at(0).at("quantity"), "mean_load");
    EXPECT_TRUE(json_told.at("scatter").at(2).at("arrangement_share").is_null());
}

TEST(Scatter, LeavesOutACaseThatIceNeverLoads) {
    Campaign three = synthetic::campaign(20);
    three.cases.resize(3, three.cases.front());
    CampaignTable table = table_of(0.1, 0.001);
    table.cases.push_back(table.cases.back());
    for (int arrangement = 0; arrangement < 20; ++arrangement)
        table.members.push_back(example::done(2, arrangement, 0, 0.1, 2));
    const Results found = find_scatter(evidence_of(three, table), {});
    EXPECT_EQ(found.number(0, "cases"), 2);
    EXPECT_GT(found.number(0, "arrangement_share"), 0.99);
}

TEST(Scatter, OfCasesThatShareNothingIsUnknown) {
    Campaign apart = campaign();
    apart.cases[1].scenario.field.floes = 5;
    EXPECT_TRUE(find_scatter(evidence_of(apart, table_of(0.1, 0)), {}).empty());
    EXPECT_THAT(scatter_section({}).before, testing::HasSubstr("two cases over the same arrangements"));
}

}  // namespace scatter_test
}  // namespace floes
