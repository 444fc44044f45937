// Sensitivity, from a design and its members to text.

#include "campaign/read.hpp"
#include "findings/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "findings/evidence.hpp"
#include "findings/example.hpp"

namespace floes {
namespace sensitivity_test {

using testing::HasSubstr;
using testing::IsEmpty;

const char* const saltelli = R"([campaign]
arrangements = 2
[design]
method = "sobol_indices"
points = 8
[[design.axis]]
key = "ice.thickness_m"
from = 0.02
to = 0.04
[[design.axis]]
key = "joint.cfm"
from = 0.001
to = 0.1
scale = "log"
)";

const char* const words = R"([design]
method = "grid"
[[design.axis]]
key = "field.far_end"
values = ["open", "ice_sheet"]
)";

std::string text_of(const Section& section) {
    return text(std::vector{section}, 120);
}

Campaign read(const std::string& text) {
    return read_campaign({text, "a.toml", {}}, nullptr);
}

/// Loads that follow the axes: 20 + 6 x + 2 y + arrangement, with x and y from -1 to 1; the failure ratio does not.
CampaignTable table_of(const Campaign& campaign) {
    CampaignTable table;
    for (const Case& one : campaign.cases) {
        CaseRow row;
        row.name = one.name;
        table.cases.push_back(row);
    }
    for (int arrangement = 0; arrangement < campaign.arrangements; ++arrangement) {
        for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
            const Scenario& scenario = campaign.cases[k].scenario;
            const double x = (scenario.floe.thickness - 0.03) / 0.01;
            const double y = std::log10(scenario.joint.cfm) + 2;
            table.members.push_back(
                example::done(static_cast<int>(k), arrangement, 20 + 6 * x + 2 * y + arrangement, 0.5, 1));
        }
    }
    return table;
}

TEST(Sensitivity, FindsWhatTheLoadFollows) {
    const Campaign campaign = read(saltelli);
    const Sensitivity found = find_sensitivity(evidence_of(campaign, table_of(campaign)));
    ASSERT_EQ(found.rows.size(), 4u);
    const SensitivityRow& mean = found.rows[0];
    EXPECT_EQ(mean.quantity.key.view(), "mean_load");
    EXPECT_EQ(mean.points, 32);
    EXPECT_EQ(mean.base_points, 8);
    ASSERT_TRUE(mean.fit);
    EXPECT_EQ(mean.fit->repetitions, 2);
    EXPECT_NEAR(mean.fit->centre, 20.5, 1e-8);
    EXPECT_NEAR(mean.fit->slopes[0].estimate, 6, 1e-8);
    EXPECT_NEAR(mean.fit->slopes[1].estimate, 2, 1e-8);
    EXPECT_NEAR(mean.fit->r_squared, 1, 1e-8);
    ASSERT_TRUE(mean.indices);
    // 36 of 40 and 4 of 40 in the limit; eight points of a shifted Sobol sequence come within a tenth.
    EXPECT_NEAR(mean.indices->total[0].estimate, 0.9, 0.1);
    EXPECT_NEAR(mean.indices->total[1].estimate, 0.1, 0.05);
    EXPECT_TRUE(std::isnan(found.rows[3].indices->total[0].estimate));  // a ratio that does not vary
}

TEST(Sensitivity, LeavesOutWhatIsNotDone) {
    const Campaign campaign = read(saltelli);
    CampaignTable table = table_of(campaign);
    table.members[5] = example::without_result(5, 0, RowStatus::missing);
    Sensitivity found = find_sensitivity(evidence_of(campaign, table));
    EXPECT_EQ(found.rows[0].points, 32);
    EXPECT_EQ(found.rows[0].fit->repetitions, 0);  // one arrangement alone has every point
    table.members[32 + 5] = example::without_result(5, 1, RowStatus::failed, "no");
    found = find_sensitivity(evidence_of(campaign, table));
    EXPECT_EQ(found.rows[0].points, 31);
    EXPECT_EQ(found.rows[0].base_points, 7);
    EXPECT_NEAR(found.rows[0].fit->slopes[0].estimate, 6, 1e-8);
}

TEST(Sensitivity, IsOfEachCaseByItself) {
    const Campaign campaign =
        read(std::string(saltelli) + "[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\ngeneral.iterations = 20\n");
    CampaignTable table = table_of(campaign);
    for (MemberRow& member : table.members) member.load.mean *= member.case_index >= 32 ? 2 : 1;
    const Sensitivity found = find_sensitivity(evidence_of(campaign, table));
    ASSERT_EQ(found.rows.size(), 8u);
    EXPECT_EQ(found.rows[4].base, "B");
    EXPECT_NEAR(found.rows[4].fit->slopes[0].estimate, 12, 1e-8);
}

TEST(Sensitivity, IsOfNumbersAlone) {
    const Campaign of_words = read(words);
    const Sensitivity found = find_sensitivity(evidence_of(of_words, table_of(of_words)));
    EXPECT_THAT(found.rows, IsEmpty());
    EXPECT_THAT(text_of(sensitivity_section(found)), HasSubstr("The axis field.far_end is not numeric"));
    const Campaign none = read("");
    EXPECT_THAT(text_of(sensitivity_section(find_sensitivity(evidence_of(none, table_of(none))))),
                HasSubstr("has no design"));
}

TEST(Points, SayWhereEachCaseLies) {
    const Campaign campaign = read(words);
    const std::string told = csv(std::vector{points_section(evidence_of(campaign, table_of(campaign)))});
    EXPECT_THAT(told, testing::StartsWith("case,base,point,field.far_end,done,mean_load,"));
    EXPECT_THAT(told, HasSubstr("\nice_sheet,,1,ice_sheet,1,"));
    EXPECT_THAT(text_of(points_section(evidence_of({}, example::campaign()))), HasSubstr("has no design"));
}

TEST(Sensitivity, OfTooFewPointsHasNoPlane) {
    const Campaign campaign =
        read("[design]\nmethod = \"grid\"\n[[design.axis]]\nkey = \"ice.thickness_m\"\nvalues = [0.02, 0.04]\n");
    const Sensitivity found = find_sensitivity(evidence_of(campaign, table_of(campaign)));
    EXPECT_FALSE(found.rows[0].fit);
    EXPECT_THAT(text_of(sensitivity_section(found)), HasSubstr("no plane"));
}

TEST(Sensitivity, IsATableJsonAndCsv) {
    const Campaign campaign = read(saltelli);
    const std::vector<Section> told{sensitivity_section(find_sensitivity(evidence_of(campaign, table_of(campaign))))};
    const std::string text = floes::text(told, 200);
    EXPECT_THAT(text, testing::ContainsRegex("thickness 0\\.02 to 0\\.04 m +12\\.00 – "));
    EXPECT_THAT(text, HasSubstr("Student's t over 2 arrangements"));
    const auto json = nlohmann::json::parse(floes::json(told));
    const auto& row = json.at("sensitivity").at("rows").at(0);
    EXPECT_NEAR(row.at("slope").get<double>(), 6, 1e-8);
    EXPECT_NEAR(row.at("change").get<double>(), 12, 1e-8);
    EXPECT_EQ(row.at("base_points"), 8);
    const std::string csv = floes::csv(told);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 4 * 2);
    EXPECT_EQ(std::ranges::count(csv, ','), 22 * (1 + 4 * 2));
}

}  // namespace sensitivity_test
}  // namespace floes
