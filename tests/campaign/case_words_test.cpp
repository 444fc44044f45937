#include "campaign/case_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/read.hpp"

namespace floes {
namespace case_words_test {

std::vector<std::string> words(const std::string& text) {
    return case_words(read_campaign({text, "a.toml", {}, true}, nullptr));
}

TEST(CaseWords, SayNothingOfFloesThatAreAlike) {
    EXPECT_EQ(words("field.floes = 189\n"), std::vector<std::string>{});
}

TEST(CaseWords, SayWhatAListCameTo) {
    // 126 x 0.16 m² + 63 x 0.64 m² = 60.48 m², of 0.75 x 4.8 m.
    EXPECT_EQ(words("[sizes]\nlaw = \"list\"\nlist_m = [[0.4, 0.4, 66.6667], [0.8, 0.8, 33.3333]]\n"),
              std::vector<std::string>{
                  "case E60: 189 floes, sides of their squares 0.4 to 0.8 m, mean 0.5333 m, half of the area in floes "
                  "of 0.8 m and more; 0.4 m x 0.4 m: 66.7 % of the floes, 33.3 % of the area; 0.8 m x 0.8 m: 33.3 % of "
                  "the floes, 66.7 % of the area; 1512 elements of 0.2 m; the field is 16.8 m long."});
}

TEST(CaseWords, SayThePointsOfADesignOnceWithTheirRanges) {
    const auto found = words(
        "structure.start_m = 5.0\n[field]\nfar_end = \"never\"\n[analysis]\nsteady_start_s = 8\nwindow_s = "
        "12\n[design]\nmethod = \"grid\"\n"
        "[[design.axis]]\nkey = \"structure.speed_m_s\"\nvalues = [0.1, 0.2, 0.3]\n");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_THAT(found.front(), testing::StartsWith("points of the design: the field has no end"));
    EXPECT_THAT(found.front(), testing::ContainsRegex("ahead of a tow of [0-9.]+ to [0-9.]+ m in 20 s"));
}

TEST(CaseWords, SayWhatTheBrineGives) {
    EXPECT_EQ(words("[brine]\nsalinity_ppt = 5.0\n"),
              std::vector<std::string>{"case E60: all floes have 461.4 kPa in bending and 8180 MPa."});
}

TEST(CaseWords, SayACaseOnceAndWhatWasDrawn) {
    const auto found = words(
        "[spread]\nthickness = \"uniform\"\nthickness_cov = 0.1\n[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].starts_with("case a: in arrangement 0 the floes have on average thickness 0.03")) << found[0];
    EXPECT_EQ(found[0].find("strength"), std::string::npos);
}

/// Of the only case.
const Scenario& scenario_of(const Campaign& campaign) {
    return campaign.cases.at(0).scenario;
}

Campaign campaign_of(const std::string& text) {
    return read_campaign({text, "a.toml", {}, true}, nullptr);
}

TEST(CaseWords, SayWhatTheFloesAre) {
    EXPECT_EQ(floe_words(scenario_of(campaign_of("field.floes = 189\n"))).text(),
              "189 floes of 0.6 m x 0.6 m, 0.033 m thick, in cells of 0.2 m, at 75 %, scattered at random");
    EXPECT_EQ(floe_words(scenario_of(campaign_of("floe.elements = \"squares\"\n"))).text(),
              "189 floes of 0.6 m x 0.6 m, 0.033 m thick, in squares of 0.2 m, at 75 %, scattered at random");
    EXPECT_EQ(
        floe_words(scenario_of(campaign_of("shapes.kind = \"polygon\"\nspread.thickness = \"normal\"\n"))).text(),
        "189 polygons of 6 corners of 0.36 m² each on average, 0.033 m thick on average, in cells of 0.2 m, at 75 "
        "%, scattered at random");
    EXPECT_EQ(
        floe_words(
            scenario_of(campaign_of("[sizes]\nlaw = \"list\"\nlist_m = [[0.4, 0.4, 66.6667], [0.8, 0.8, 33.3333]]\n")))
            .text(),
        "189 rectangles with sides of 0.4 to 0.8 m, mean 0.5333 m (squares of their area), 0.033 m thick, in cells "
        "of 0.2 m, at 75 %, scattered at random");
}

TEST(CaseWords, OfAFieldWithoutEndAreOfItsParts) {
    const Campaign given =
        campaign_of("[field]\nfloes = 24\nhalf_width_m = 1.25\nfar_end = \"never\"\n[shapes]\nkind = \"polygon\"\n");
    EXPECT_THAT(floe_words(scenario_of(given)).text(),
                testing::StartsWith("parts of 24 polygons of 6 corners of 0.36 m² each"));
}

TEST(CaseWords, SayHowTheStructureMovesAndWhatHoldsIt) {
    EXPECT_EQ(motion_words(scenario_of(campaign_of("structure.speed_m_s = 0.05\n"))).text(), "towed at 0.05 m/s");
    EXPECT_EQ(
        motion_words(scenario_of(campaign_of("structure.speed_m_s = 0.05\nfloe.length_m = 20\nfloe.breadth_m = 2\n"
                                             "[field]\nfloes = 1\nconcentration_percent = 100\nlevel_pushed = true\n"
                                             "[arrangement]\nmethod = \"level\"\n")))
            .text(),
        "at rest; the sheet is pushed on it at 0.05 m/s");
    EXPECT_EQ(motion_words(scenario_of(campaign_of("[moorings]\nmass_t = 0.4\ngyration_m = 0.44\nsurge_kN_m = 0.8\n"
                                                   "sway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\n")))
                  .text(),
              "0.4 t, free in surge, sway and yaw, held by springs of 0.8 kN/m in surge and 0.7 in sway; the ice comes "
              "at 0.07 m/s");
}

TEST(CaseWords, SayHowFastTheIceOfAPathComes) {
    Scenario scenario =
        scenario_of(campaign_of("[moorings]\nmass_t = 0.4\ngyration_m = 0.44\nsurge_kN_m = 0.8\n"
                                "sway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\n"));
    scenario.path = {.legs = {{3, 0.8, 600, 0}}, .of = PathOf::ice};
    scenario.field.closing_speed = 0.01;  // of confining sheets
    EXPECT_THAT(motion_words(scenario).text(), testing::EndsWith("; the ice comes at 0.8 m/s"));
}

// The paper's cone at a draught of 0.443 m: a frustum of 0.445 and 0.614 m and what it weighs.
TEST(CaseWords, SayWhatAMooredHullDisplaces) {
    const std::string moored =
        "[structure]\nprofile_m = [[-0.443, 0.614], [0.122, 0.614]]\n[moorings]\ngyration_m = 0.44\nsurge_kN_m = "
        "0.8\nsway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\n";
    const auto said = words(moored + "mass_t = 0.52467\n");
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(
        said[0],
        "case E60: the hull is 1.228 m long and 1.228 m wide at the waterline with a draught of 0.443 m; it "
        "displaces 0.52467 m³, 0.52467 t, with the centre of buoyancy 0.2215 m below the water, and its waterplane "
        "of 1.184 m² puts the metacentre 0.2128 m above that in roll and 0.2128 m in pitch; without damping the moored "
        "hull "
        "swings with natural periods of 5.088 s in surge, 5.44 s in sway, 6.333 s in yaw.");
}

// Bad input ends in a sentence with file, line and key.
TEST(CaseWords, AreNotReachedByBadInput) {
    const auto refusal = [](const std::string& text) -> std::string {
        try {
            words(text);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(refusal("[sizes]\nlaw = \"list\"\nlist_m = [[0.4, 0.4, 60.0], [0.8, 0.8, 33.0]]\n"),
              "a.toml:3: the shares of sizes.list_m sum to 93 %; they are to sum to 100 %");
    EXPECT_EQ(refusal("[sizes]\nlaw = \"list\"\nlist_m = [[0.6, 0.6, 96.0], [5.0, 6.0, 4.0]]\n"),
              "a.toml:2: field.half_width_m = 2.4 leaves 4.796 m for floes, and one is 5 m wide where it is narrowest; "
              "widen the field or take smaller floes");
    EXPECT_EQ(refusal("[sizes]\nexponent = 2.0\n"),
              "a.toml:2: sizes.exponent = 2.0 has no effect: it needs sizes.law = \"power_law\". Add that, or leave "
              "sizes.exponent out.");
    EXPECT_EQ(refusal("[spread]\nstrength = \"normal\"\nstrength_within = [2.0, 1.0]\n"),
              "a.toml:3: spread.strength_within = [2.0, 1.0] is not two rising factors, such as [0.5, 2.0]");
}

}  // namespace case_words_test
}  // namespace floes
