// What a model leaves open, as a configuration.

#include "campaign/write.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "campaign/read.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "support/refusal.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace variations_test {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

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

Scenario case_of(const Campaign& campaign, const std::string& name) {
    const auto found = std::ranges::find(campaign.cases, name, &Case::name);
    if (found == campaign.cases.end()) throw InputError("no case is " + name);
    return found->scenario;
}

std::vector<std::string> names_of(const Scenario& scenario) {
    std::vector<std::string> names;
    for (const Variation& one : variations_of(scenario)) names.push_back(one.name);
    return names;
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
    // What follows another key.
    const std::map<std::string, std::size_t> several{
        {"half_width_3.6_m", 2}, {"speed_m_s_0.035", 3}, {"speed_m_s_0.14", 4}};
    for (std::size_t k = 1; k < read.cases.size(); ++k) {
        const auto found = several.find(read.cases[k].name);
        const std::size_t changed = differences(read.cases[0].scenario, read.cases[k].scenario).size();
        EXPECT_EQ(changed, found == several.end() ? 1U : found->second) << read.cases[k].name;
    }
    EXPECT_EQ(case_of(read, "ice_ice_friction_0.4").contact.ice_ice_friction, 0.4);
    const Scenario wide = case_of(read, "half_width_3.6_m");
    EXPECT_EQ(wide.field.floes, 225);
    EXPECT_NEAR(wide.field_length(), mine().field_length(), 1e-9);
}

/// The study of a campaign's first case, read again.
Campaign study_of(const Campaign& campaign) {
    return read_campaign({variations_text(campaign, campaign.cases[0]), "varied.toml", {}, true}, nullptr);
}

// Of joints that follow Σ the reader finds what is not stated of E and Σ, also where it is as by default.
TEST(Variations, StateTheModulusAndTheSigmaThatTheCaseStates) {
    const std::string joints =
        "general.solver = \"lanes\"\njoint.model = \"cfm\"\nwater.heave_damping_from = \"share\"\n"
        "water.added_mass_from = \"share\"\n";
    const std::string modulus = "ice.elastic_modulus_MPa = 60\n";
    const std::string cfm = "joint.cfm = 0.016\n";
    for (const auto& [text, pairing] : {std::pair{"run.nominal_modulus = true\n" + modulus + cfm, Pairing::settled},
                                        {modulus + cfm, Pairing::check},
                                        {cfm, Pairing::find_modulus},
                                        {modulus, Pairing::find_cfm}}) {
        const Campaign campaign = read_campaign({joints + text, "a.toml", {}, true}, nullptr);
        ASSERT_EQ(campaign.cases[0].pairing, pairing) << text;
        const Campaign read = study_of(campaign);
        for (const Case& one : read.cases) EXPECT_EQ(one.pairing, pairing) << text << one.name;
        EXPECT_EQ(case_fingerprint(read, 0), case_fingerprint(campaign, 0)) << text;
    }
}

TEST(Variations, StopByTheRuleOfTheirCampaign) {
    Campaign campaign = of(mine());
    campaign.arrangements = 400;
    campaign.stop = {.half_width = 0.05, .of = "maximum_load", .batch = 4};
    EXPECT_EQ(study_of(campaign).stop, campaign.stop);
    EXPECT_EQ(
        read_campaign({study_text(campaign, campaign.cases[0], variations_of(mine())), "a.toml", {}, true}, nullptr)
            .stop,
        campaign.stop);
    campaign.stop = {.half_width = 0.05, .case_name = "stiff"};
    EXPECT_EQ(study_of(campaign).stop, StopRule{});
    EXPECT_THAT(variations_text(campaign, campaign.cases[0]),
                HasSubstr("# The stop rule of mine does not fit these cases and is left out: all 400 arrangements"));
    EXPECT_THAT(variations_text(of(mine()), of(mine()).cases[0]), Not(HasSubstr("stop")));
}

TEST(Variations, OfTheSpeedCoverTheSameDistances) {
    const Campaign campaign = of(mine());
    const Campaign read = study_of(campaign);
    const double way = mine().structure.speed * mine().general.time_step;
    for (const char* name : {"speed_m_s_0.035", "speed_m_s_0.14"}) {
        const Scenario other = case_of(read, name);
        EXPECT_NEAR(other.towed(), mine().towed(), 1e-12) << name;
        EXPECT_NEAR(other.structure.speed * other.analysis.window, 0.07 * 60, 1e-12) << name;
        EXPECT_LE(other.structure.speed * other.general.time_step, way) << name;
    }
    Scenario turning = mine();
    turning.path.legs = {{.heading = 0, .speed = 0.07, .time = 300, .turn = 0.001}};
    EXPECT_THAT(names_of(turning), Not(Contains(HasSubstr("speed")))) << "the speed is the path's";
}

/// Of the variation, heights and radii.
std::vector<std::vector<double>> profile_of(const Scenario& scenario, const std::string& name) {
    const Campaign campaign = of(scenario);
    return case_of(read_campaign({variations_text(campaign, campaign.cases[0]), "varied.toml", {}, true}, nullptr),
                   name)
        .structure.shape.rows();
}

TEST(Variations, OfTheWallTurnItBelowTheWaterline) {
    using Rows = std::vector<std::vector<double>>;
    // The default: atan(0.443/0.169) = 69.12°, so the radius is 0.614 - 0.443/tan(67.12°), and with 71.12°.
    EXPECT_EQ(profile_of(mine(), "wall_deg_67.1"), (Rows{{-0.443, 0.427}, {0, 0.614}, {0.122, 0.736}}));
    EXPECT_EQ(profile_of(mine(), "wall_deg_71.1"), (Rows{{-0.443, 0.4625}, {0, 0.614}, {0.122, 0.736}}));
    Scenario straight = mine();  // the wall above the waterline stays
    straight.structure.shape = Shape({{-0.4, 0.2}, {0.2, 0.8}});
    EXPECT_EQ(profile_of(straight, "wall_deg_43.0"), (Rows{{-0.4, 0.1711}, {0, 0.6}, {0.2, 0.8}}));
    Scenario up = mine();  // steeper is steeper for a cone that narrows upwards, too
    up.structure.shape = Shape({{-0.4, 1.0}, {0, 0.6}, {0.2, 0.4}});
    EXPECT_EQ(profile_of(up, "wall_deg_43.0"), (Rows{{-0.4, 1.029}, {0, 0.6}, {0.2, 0.4}}));
    Scenario skirt = mine();  // a vertical wall above a sloped one, and a flat bottom
    skirt.structure.shape = Shape({{-0.6, 0}, {-0.6, 0.2}, {-0.5, 0.2}, {-0.1, 0.6}, {0.2, 0.6}});
    EXPECT_EQ(profile_of(skirt, "wall_deg_43.0"),
              (Rows{{-0.6, 0}, {-0.6, 0.1711}, {-0.5, 0.1711}, {-0.1, 0.6}, {0.2, 0.6}}));
    Scenario vertical = mine();
    vertical.structure.shape = Shape({{-0.4, 0.6}, {0, 0.6}, {0.1, 0.7}});
    Scenario cylinder = mine();
    cylinder.structure.shape = Shape(HullKind::cylinder, {.diameter = 1.2, .draught = 0.4, .freeboard = 0.1});
    for (const Scenario& scenario : {vertical, cylinder})
        EXPECT_THAT(names_of(scenario), Not(Contains(HasSubstr("wall"))));
}

TEST(Variations, LeaveOutWhatCouldNotBeRun) {
    Scenario scenario = mine();
    scenario.analysis.averaging = {15};  // longer than a segment of the window of a tow of twice the speed
    EXPECT_THAT(names_of(scenario),
                testing::AllOf(Contains("speed_m_s_0.035"), Not(Contains("speed_m_s_0.14")), Contains("flow_still")));
}

TEST(Variations, LeaveOutWhatHasNoEffect) {
    EXPECT_THAT(names_of(sweeping_scenario()), Not(Contains(HasSubstr("added_mass"))))
        << "shares have none in the plane";
    EXPECT_THAT(names_of(sweeping_scenario()), Not(Contains(HasSubstr("elastic_modulus")))) << "follows Σ";
    Scenario still;
    still.water.flow = WaterFlow::still;
    EXPECT_THAT(names_of(still), testing::AllOf(Contains("heave_drag_1.2"), Not(Contains(HasSubstr("flow")))));
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
    const char* const text = "[run]\nbase_case = \"bse\"\n[[case]]\nname = \"base\"\n[[case]]\nname = \"other\"\n";
    EXPECT_EQ(refusal([&] {
                  read_campaign({text, "a.toml", {}}, nullptr);
              }),
              "a.toml:2: run.base_case = \"bse\" names no case; the cases are base, other");
}

}  // namespace variations_test
}  // namespace floes
