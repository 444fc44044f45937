#include "scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"

namespace floes {
namespace scenario_test {

TEST(Scenario, DefaultsAreThePapersField) {
    const Scenario scenario;
    EXPECT_EQ(scenario.floe.elements_long(), 3);
    EXPECT_EQ(scenario.floe.elements_broad(), 3);
    EXPECT_NEAR(scenario.field_length(), 18.9, 1e-12);
    EXPECT_NEAR(scenario.field_end(), 24.9, 1e-12);
    EXPECT_EQ(scenario.step_count(), 13500);
    EXPECT_EQ(scenario.first_window_step(), 6000);
    ASSERT_TRUE(scenario.gap());
    EXPECT_NEAR(scenario.gap()->breadth, 2.4 - 0.614, 1e-12);
    EXPECT_NEAR(scenario.gap()->floes, (2.4 - 0.614) / 0.6, 1e-12);
}

// Westergaard's l of the tank's ice, and Froude's law: times go with the root of lengths where moduli go with lengths.
TEST(Scenario, StressIsAveragedOverATenthOfThePlatesOwnTime) {
    Scenario scenario;
    scenario.ice.elastic_modulus = 60e6;
    const double rigidity = 60e6 * std::pow(0.033, 3) / 12 / (1 - 0.3 * 0.3);
    const double length = std::sqrt(std::sqrt(rigidity / (1000 * 9.81)));
    EXPECT_NEAR(scenario.stress_averaging(), 0.1 * std::sqrt(length / 9.81), 1e-15);
    EXPECT_EQ(scenario.stress_steps(), 1);
    scenario.general.time_step = 0.0025;
    EXPECT_EQ(scenario.stress_steps(), 8);

    Scenario larger = scenario;
    larger.floe.thickness *= 25;
    larger.ice.elastic_modulus *= 25;
    EXPECT_NEAR(larger.stress_averaging() / scenario.stress_averaging(), 5, 1e-12);

    scenario.joint.averaging = 0.05;
    EXPECT_EQ(scenario.stress_averaging(), 0.05);
    EXPECT_EQ(scenario.stress_steps(), 20);
}

// 0.4 m/s for 10 s and 0.2 m/s for 5 s are 5 m in 15 s; it stands for the 5 s between them.
TEST(Scenario, DriftsOnAPathAtItsMeanWhileItMoves) {
    Scenario scenario;
    scenario.general.time_step = 0.02;
    scenario.analysis.steady_start = 5;
    scenario.analysis.window = 25;
    EXPECT_EQ(scenario.drift(), scenario.structure.speed);
    scenario.path.legs = {{3, 0, 4, 0.1}};
    EXPECT_EQ(scenario.drift(), scenario.structure.speed) << "it never moves";
    scenario.path = {.legs = {{3, 0.4, 10, 0}, {3, 0, 5, 0}, {3, 0.2, 5, 0}}, .of = PathOf::ice};
    EXPECT_NEAR(scenario.drift(), 5.0 / 15, 1e-12);
    EXPECT_EQ(scenario.closing_speed(), scenario.drift());
    scenario.field.closing_speed = 0.01;
    EXPECT_EQ(scenario.closing_speed(), 0.01);
}

TEST(ScenarioKeys, PathsAreUniqueAndNamed) {
    Scenario scenario;
    std::set<std::string_view> paths;
    for (const Key& key : describe(scenario)) {
        EXPECT_TRUE(paths.insert(key.path).second) << key.path;
        EXPECT_TRUE(scenario_titles().contains(std::string(key.table()))) << key.path;
        EXPECT_FALSE(key.doc.empty()) << key.path;
        EXPECT_FALSE(key.source.empty()) << key.path;
        EXPECT_EQ(key.doc.back(), '.') << key.path;
    }
}

// The defaults must be in their own ranges, and what is written must read back bit for bit.
TEST(ScenarioKeys, DefaultsReadBackEqual) {
    Scenario written;
    const std::string text = write_tables(describe(written), scenario_titles(), Comments::all);
    Scenario read_back;
    Keys keys = describe(read_back);
    read_back.general.iterations = 1;
    read_back.structure.shape = Shape::of_rows({});
    for (const Entry& entry : parse_document(text, "f").entries) assign_known(keys, entry);
    EXPECT_TRUE(differences(written, read_back).empty());
    EXPECT_EQ(canonical_text(written), canonical_text(read_back));
}

TEST(ScenarioKeys, GivenShowsTheValueInTheUnitOfTheKey) {
    EXPECT_EQ(given(Scenario{}, "ice.bending_strength_kPa"), "ice.bending_strength_kPa = 36.4");
    EXPECT_EQ(given(Scenario{}, "field.concentration_percent"), "field.concentration_percent = 75.0");
}

// What a journal from before these keys holds must still be found under its digest.
TEST(ScenarioKeys, LaterKeysAreSilentWhereTheySayWhatWasSoBefore) {
    Scenario scenario = paper_scenario();
    EXPECT_EQ(canonical_text(scenario).find("analysis.history_stride"), std::string::npos);
    EXPECT_EQ(canonical_text(scenario).find("analysis.exceedance_levels_N"), std::string::npos);
    EXPECT_EQ(canonical_text(scenario).find("contact.friction"), std::string::npos);
    scenario.contact.friction = Friction::cone;
    EXPECT_NE(canonical_text(scenario).find("contact.friction = \"cone\"\n"), std::string::npos);
    EXPECT_EQ(canonical_text(scenario).find("contact.law"), std::string::npos);
    EXPECT_EQ(canonical_text(scenario).find("contact.preset"), std::string::npos) << "it says what others say";
    EXPECT_NE(canonical_text(Scenario{}).find("contact.law = \"crushing\"\n"), std::string::npos);
    EXPECT_EQ(canonical_text(scenario).find("analysis.averaging_s"), std::string::npos);
    scenario.analysis.history_stride = 10;
    scenario.analysis.exceedance_levels = {20, 50};
    EXPECT_NE(canonical_text(scenario).find("analysis.history_stride = 10\n"), std::string::npos);
    EXPECT_NE(canonical_text(scenario).find("analysis.exceedance_levels_N = [20.0, 50.0]\n"), std::string::npos);
}

TEST(ContactPreset, IsFoundAgainInTheLaw) {
    ContactLaw law{.erp = 0.7};
    for (const ContactPreset preset : {ContactPreset::physical, ContactPreset::paper}) {
        law = with_preset(law, preset);
        EXPECT_EQ(preset_of(law), preset);
        EXPECT_EQ(law.erp, 0.7);
    }
    EXPECT_EQ(preset_of(ContactLaw{}), ContactPreset::paper);
    EXPECT_EQ(preset_of(Scenario{}.contact), ContactPreset::physical);
    law.friction = Friction::cone;
    EXPECT_EQ(preset_of(law), ContactPreset::own);
    EXPECT_EQ(with_preset(law, ContactPreset::own), law);
}

}  // namespace scenario_test
}  // namespace floes
