// What a model leaves open, as a configuration.

#include "campaign/variations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace variations_test {

using testing::HasSubstr;

Campaign of(const Scenario& scenario) {
    Campaign campaign;
    campaign.name = "mine";
    campaign.seed = 7;
    campaign.arrangements = 3;
    campaign.cases.push_back({"stiff", scenario});
    return campaign;
}

Scenario mine() {
    Scenario scenario;
    scenario.floe.thickness = 0.04;
    scenario.contact.ice_ice_friction = 0.2;
    scenario.field.floes = 150;
    scenario.analysis.window = 60;
    return scenario;
}

TEST(Variations, TextHasTheCaseAsItIsAndOneChangeInEachOther) {
    const Campaign campaign = of(mine());
    const Campaign read =
        read_campaign({variations_text(campaign, campaign.cases[0]), "varied.toml", {}, true}, nullptr);
    EXPECT_EQ(read.name, "varied");
    EXPECT_EQ(read.seed, 7U);
    EXPECT_EQ(read.arrangements, 3);
    ASSERT_EQ(base_case(read), 0U);
    EXPECT_EQ(differences(read.cases[0].scenario, campaign.cases[0].scenario), std::vector<std::string>{});
    EXPECT_GE(read.cases.size(), 15U);
    for (std::size_t k = 1; k < read.cases.size(); ++k) {
        const std::size_t changed = differences(read.cases[0].scenario, read.cases[k].scenario).size();
        EXPECT_EQ(changed, read.cases[k].name.starts_with("half_width") ? 2U : 1U) << read.cases[k].name;
    }
    const auto rough = std::ranges::find(read.cases, "ice_ice_friction_0.4", &Case::name);
    ASSERT_NE(rough, read.cases.end());
    EXPECT_EQ(rough->scenario.contact.ice_ice_friction, 0.4);
    const auto wide = std::ranges::find(read.cases, "half_width_3.6_m", &Case::name);
    ASSERT_NE(wide, read.cases.end());
    EXPECT_EQ(wide->scenario.field.floes, 225);
    EXPECT_NEAR(wide->scenario.field_length(), mine().field_length(), 1e-9);
}

TEST(Variations, LeaveOutWhatHasNoEffect) {
    for (const Variation& one : variations_of(sweeping_scenario())) {
        EXPECT_THAT(one.name, testing::Not(HasSubstr("added_mass"))) << "shares have none in the plane";
        EXPECT_THAT(one.name, testing::Not(HasSubstr("elastic_modulus"))) << "follows Σ";
    }
    Scenario still;
    still.water.flow = WaterFlow::still;
    for (const Variation& one : variations_of(still)) EXPECT_THAT(one.name, testing::Not(HasSubstr("flow")));
}

// Whatever is varied, what comes out can be run.
TEST(Variations, AreConsistentInFieldsWithoutEndAndOfPolygons) {
    Scenario endless = mine();
    endless.field.far_end = FarEnd::never;
    endless.arrangement.method = ArrangementMethod::scattered;
    Scenario polygons = endless;
    polygons.shapes.kind = ShapeKind::polygon;
    Scenario stirred = polygons;
    stirred.field.far_end = FarEnd::ice_sheet;
    for (const Scenario& scenario : {endless, polygons, stirred}) {
        const Campaign campaign = of(scenario);
        const Campaign read =
            read_campaign({variations_text(campaign, campaign.cases[0]), "varied.toml", {}, true}, nullptr);
        EXPECT_GE(read.cases.size(), 12U);
        const bool ordered = std::ranges::find(read.cases, "ordering_sweeps_1000", &Case::name) != read.cases.end();
        EXPECT_EQ(ordered, !scenario.field.endless());
    }
}

TEST(Variations, ABaseCaseThatIsNoneIsRefused) {
    try {
        read_campaign(
            {"[run]\nbase_case = \"bse\"\n[[case]]\nname = \"base\"\n[[case]]\nname = \"other\"\n", "a.toml", {}},
            nullptr);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "a.toml:2: run.base_case = \"bse\" names no case; the cases are base, other");
    }
}

}  // namespace variations_test
}  // namespace floes
