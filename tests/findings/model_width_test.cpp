// What the model leaves open, of loads that are known.

#include "findings/pairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "findings/example.hpp"

namespace floes {
namespace model_width_test {

using testing::HasSubstr;

/// A base case and three variations of two inputs over the same eight arrangements. Each load is the arrangement's plus
/// what the case changes, plus a scatter that has mean 0 and is no other case's.
Evidence varied(const std::array<double, 4>& means, double scatter) {
    Campaign campaign;
    campaign.arrangements = 8;
    campaign.run.base_case = "base";
    Scenario scenario;
    campaign.cases.push_back({"base", scenario});
    scenario.contact.ice_ice_friction = 0.15;
    campaign.cases.push_back({"smooth", scenario});
    scenario.contact.ice_ice_friction = 0.6;
    campaign.cases.push_back({"rough", scenario});
    scenario = {};
    scenario.water.flow = WaterFlow::still;
    campaign.cases.push_back({"still", scenario});

    CampaignTable table;
    table.averaging_times = {};
    for (const Case& one : campaign.cases) {
        CaseRow row;
        row.name = one.name;
        row.analysis = one.scenario.analysis;
        table.cases.push_back(std::move(row));
    }
    for (int arrangement = 0; arrangement < 8; ++arrangement) {
        for (int k = 0; k < 4; ++k) {
            MemberRow row;
            row.case_index = k;
            row.arrangement = arrangement;
            row.status = RowStatus::done;
            const double sign = k > 0 && (arrangement >> (k - 1)) % 2 == 0 ? -1 : 1;
            row.load.mean = means[static_cast<std::size_t>(k)] + arrangement + (k == 0 ? 0 : scatter * sign);
            row.load.mean_maximum = 2 * row.load.mean;
            row.failure_ratio = 0.1;
            table.members.push_back(std::move(row));
        }
    }
    return evidence_of(std::move(campaign), std::move(table));
}

TEST(ModelWidth, IsTheRootOfTheSumOfSquaresOfInputs) {
    const std::optional<ModelWidth> width = find_model_width(varied({30, 27, 34, 33}, 0));
    ASSERT_TRUE(width);
    EXPECT_EQ(width->inputs, 2U);
    EXPECT_NEAR(width->widths[0].down, -3, 1e-12);
    EXPECT_NEAR(width->widths[0].up, 5, 1e-12);  // 4 of friction, 3 of the flow
    EXPECT_NEAR(width->widths[1].up, 10, 1e-12);
    EXPECT_EQ(width->widths[2].up, 0);  // as many broken floes in all
    EXPECT_EQ(width->variations.front().input, "contact.ice_ice_friction");
    EXPECT_EQ(width->variations.front().of_case, 2U);  // the largest change comes first
    EXPECT_TRUE(width->variations.front().changes.front().paired);
}

// A change that is no more than chance adds nothing: its square is, in the mean, the square of its standard error.
TEST(ModelWidth, LeavesOutWhatSamplingAdds) {
    const double scatter = 2;
    const double error = scatter * std::sqrt(8.0 / 7) / std::sqrt(8.0);  // sign changes alone
    const std::optional<ModelWidth> width = find_model_width(varied({30, 30, 34, 30}, scatter));
    ASSERT_TRUE(width);
    EXPECT_NEAR(width->widths[0].up, std::sqrt(16 - error * error), 1e-9);
    EXPECT_EQ(width->widths[0].down, 0);
}

// Where a member of the base stands out, its interval is the mixture's that its row shows.
TEST(ModelWidth, SaysOfSamplingWhatTheBaseRowSays) {
    Evidence evidence = varied({30, 27, 34, 33}, 0);
    evidence.table.members.front().load.mean = 300;
    evidence = evidence_of(evidence.campaign, evidence.table);
    const std::optional<ModelWidth> width = find_model_width(evidence);
    ASSERT_TRUE(width);
    const Estimate shown = over(evidence.sample, evidence.sample.done(0), width->widths[0].quantity);
    EXPECT_EQ(width->widths[0].base, shown.value);
    EXPECT_EQ(width->widths[0].sampling, std::max(shown.high - shown.value, shown.value - shown.low));
}

TEST(ModelWidth, ComparesOtherFloesWithoutPairs) {
    Evidence evidence = varied({30, 27, 34, 33}, 0);
    for (MemberRow& row : evidence.table.members)
        if (row.case_index == 3) row.arrangement += 100;
    evidence = evidence_of(evidence.campaign, evidence.table);
    const std::optional<ModelWidth> width = find_model_width(evidence);
    ASSERT_TRUE(width);
    const auto still = std::ranges::find(width->variations, 3U, &VariationRow::of_case);
    EXPECT_FALSE(still->changes.front().paired);
    EXPECT_NEAR(still->changes.front().change.value, 3, 1e-12);
    EXPECT_NEAR(still->changes.front().standard_error, std::sqrt(2 * 6.0 / 8), 1e-12);  // variance of 0 to 7 is 6
}

TEST(ModelWidth, TakesAFasterTowInShorterStepsForTheInputOfASlowerOne) {
    Evidence evidence = varied({30, 27, 34, 33}, 0);
    evidence.campaign.cases[1].scenario = evidence.campaign.cases[2].scenario = {};
    evidence.campaign.cases[1].scenario.structure.speed = 0.035;
    evidence.campaign.cases[1].scenario.analysis.window = 300;
    evidence.campaign.cases[2].scenario.structure.speed = 0.14;
    evidence.campaign.cases[2].scenario.analysis.window = 75;
    evidence.campaign.cases[2].scenario.general.time_step = 0.01;
    const std::optional<ModelWidth> width = find_model_width(evidence);
    ASSERT_TRUE(width);
    EXPECT_EQ(width->inputs, 2U);
    EXPECT_EQ(width->variations.front().input, "structure.speed_m_s, analysis.window_s");
    evidence.campaign.cases[2].scenario = {};
    evidence.campaign.cases[2].scenario.general.time_step = 0.01;
    EXPECT_EQ(find_model_width(evidence)->variations.front().input, "general.time_step_s") << "by itself it is one";
}

TEST(ModelWidth, SaysWhichIsLarger) {
    Evidence evidence = varied({30, 27, 34, 33}, 0);
    EXPECT_EQ(width_sentence(find_model_width(evidence), {}),
              "Sampling leaves the mean load open by ± 2 N, the 2 inputs varied here by -3 to +5 N together: more "
              "arrangements do not narrow that.");
    Evidence alike = varied({30, 30, 30.5, 30}, 0);
    EXPECT_THAT(width_sentence(find_model_width(alike), {}), HasSubstr("would narrow the result"));
    const std::vector<Section> sections{model_section(evidence)};
    EXPECT_THAT(text(sections, 120), testing::ContainsRegex("rough +4.00 \\[4.00, 4.00\\]"));
    EXPECT_THAT(text(sections, 120), testing::ContainsRegex("base, n = 8 +33.50 \\[31.45, 35.55\\]"));
    EXPECT_THAT(csv(sections), HasSubstr("smooth,contact.ice_ice_friction,mean_load,33.5,-3,"));
}

TEST(ModelWidth, IsUnknownWithoutABaseCase) {
    Evidence evidence = varied({30, 27, 34, 33}, 0);
    evidence.campaign.run.base_case.clear();
    EXPECT_FALSE(find_model_width(evidence));
    EXPECT_THAT(model_section(evidence).missing, HasSubstr("floes vary"));
}

}  // namespace model_width_test
}  // namespace floes
