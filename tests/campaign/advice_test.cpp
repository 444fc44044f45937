// What is allowed but odd, and that what is usual is not.

#include "campaign/case_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "campaign/read.hpp"

namespace floes {
namespace advice_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> advice_for(const std::string& text) {
    return advice(read_campaign({text, "a.toml", {}, true}, nullptr));
}

TEST(Advice, HasNothingToSayOfTheDefaults) {
    EXPECT_THAT(advice_for(""), IsEmpty());
}

TEST(Advice, SaysWhatIsOdd) {
    const std::pair<const char*, const char*> odd[]{
        {"floe.element_m = 0.6", "case E60: floe.element_m = 0.6 is not below 0.377 m, the characteristic length"},
        {"floe.element_m = 0.02",
         "ice.thickness_m = 0.033 is more than floe.element_m = 0.02; elements that are thicker"},
        {"field.concentration_percent = 3", "field.concentration_percent = 3.0 leaves the field of 472.5 m almost"},
        {"ice.bending_strength_kPa = 0.5", "ice.bending_strength_kPa = 0.5 is unlike any ice"},
        {"ice.compressive_strength_kPa = 30", "ice is several times stronger in compression"},
        {"general.iterations = 1", "general.iterations = 1 leaves contacts unsolved"},
        {"general.time_step_s = 0.1", "structure.speed_m_s = 0.07 take the structure 0.007 m on in each step"},
        {"field.half_width_m = 1.25",
         "case E60: field.half_width_m = 1.25 leaves 0.636 m between the structure and the bank, 1.06 sides of a "
         "floe; below two the load depends on the gap (docs/sea_ice.md), and floes vary has a wider channel."},
    };
    for (const auto& [text, sentence] : odd) EXPECT_THAT(advice_for(text), ElementsAre(HasSubstr(sentence))) << text;
}

// 0.636 m beside the structure, and floes whose mean area is that of squares of 0.6 m or of 0.3 m.
TEST(Advice, OfTheGapIsAboutStraightTowsBetweenBanks) {
    const std::string narrow = "field.half_width_m = 1.25\n";
    EXPECT_THAT(advice_for(narrow + "[sizes]\nlaw = \"list\"\nlist_m = [[0.9, 0.4, 100]]\n"
                                    "[floe]\nelement_m = 0.1\n"),
                ElementsAre(HasSubstr("1.06 sides of a floe")));
    EXPECT_THAT(advice_for(narrow + "floe.length_m = 0.3\nfloe.breadth_m = 0.3\nfloe.element_m = 0.1\n"
                                    "analysis.steady_start_s = 50\nanalysis.window_s = 30\n"),
                IsEmpty());
    EXPECT_THAT(advice_for(narrow + "field.sides = \"open\"\n"), IsEmpty());
    EXPECT_THAT(advice_for(narrow + "path.legs = [[0.0, 0.07, 270.0, 0.01]]\n"), IsEmpty());
}

// A cylinder of 1.228 m with a draught of 0.443 m displaces 0.5247 t.
TEST(Advice, OfAMassIsAboutTheWaterThatTheHullDisplaces) {
    const std::string moored =
        "[structure]\nprofile_m = [[-0.443, 0.614], [0.122, 0.614]]\n[moorings]\ngyration_m = 0.44\nsurge_kN_m = "
        "0.8\nsway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\n";
    EXPECT_THAT(advice_for(moored + "mass_t = 0.3\n"),
                testing::Contains(HasSubstr("moorings.mass_t = 0.3 is 57.2 % of the 0.5247 t of water that the hull "
                                            "displaces, and a hull that floats weighs as much")));
    EXPECT_THAT(advice_for(moored + "mass_t = 0.5\n"), testing::Not(testing::Contains(HasSubstr("displaces"))));
}

TEST(Advice, NamesTheOtherCasesOfOneOddity) {
    EXPECT_THAT(advice_for("general.iterations = 5\n[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n"
                           "general.iterations = 20\n[[case]]\nname = \"c\"\n"),
                ElementsAre(testing::AllOf(HasSubstr("case a: general.iterations = 5"),
                                           testing::EndsWith("The same holds for c."))));
}

TEST(Advice, QuotesTheOddestCase) {
    EXPECT_THAT(advice_for("general.iterations = 5\n[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n"
                           "general.iterations = 2\n"),
                ElementsAre(testing::AllOf(HasSubstr("case b: general.iterations = 2"),
                                           testing::EndsWith("Less so, the same holds for a."))));
}

// 0.5 t on 0.1 N/m; a hull that starts 17.5 m before the ice and goes at 0.07 m/s meets it after 250 s.
TEST(Advice, OfWindowsThatMeasureTooLittle) {
    const std::string moored =
        "[structure]\nprofile_m = [[-0.443, 0.614], [0.122, 0.614]]\n[moorings]\ngyration_m = 0.44\nmass_t = 0.5\n"
        "sway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\n";
    EXPECT_THAT(advice_for(moored + "surge_kN_m = 0.0001\n"),
                testing::Contains(HasSubstr("is shorter than three natural periods of 444")));
    EXPECT_THAT(advice_for(moored + "surge_kN_m = 0.8\n"),
                testing::Not(testing::Contains(HasSubstr("natural periods"))));
    EXPECT_THAT(advice_for("structure.start_m = -12\n"),
                testing::Contains(HasSubstr("begins to measure before the hull meets the ice")));
}

// 0.2 m/s in steps of 0.02 s, in one of 300 s.
TEST(Advice, OfLongStepsIsAboutTheFastestLeg) {
    EXPECT_THAT(advice_for("[analysis]\nsteady_start_s = 10\nwindow_s = 290\nsegments = 1\n[path]\n"
                           "legs = [[0, 0.06, 299, 0], [0, 0.2, 1, 0]]\n"),
                ElementsAre(HasSubstr("path.legs take the structure 0.004 m on in its longest step, more than a tenth "
                                      "of the ice's thickness")));
}

TEST(Advice, OfAPathThatEndsBeforeTheWindow) {
    const std::string times = "[analysis]\nsteady_start_s = 10\nwindow_s = 290\nsegments = 1\n[path]\n";
    const auto told = [&](const std::string& path) { return advice_for(times + path); };
    EXPECT_THAT(
        told("legs = [[0, 0.07, 100, 0], [5, 0.05, 55, 0]]\n"),
        ElementsAre(HasSubstr("path.legs ends after 155 s of 300 s, and then the structure stands, for 50 % of the "
                              "window; let it go on, or say that it stands by a leg of speed 0")));
    EXPECT_THAT(
        told("places = [[0, 0, 0, 0], [100, 7, 0, 0]]\n"),
        ElementsAre(HasSubstr("path.places ends after 100 s of 300 s, and then the structure stands, for 69 % of "
                              "the window; let it go on, or say that it stands by a last row at the same place")));
    EXPECT_THAT(told("legs = [[0, 0.07, 100, 0], [0, 0, 1, 0]]\n"), IsEmpty());
    EXPECT_THAT(told("places = [[0, 0, 0, 0], [100, 7, 0, 0], [101, 7, 0, 0]]\n"), IsEmpty());
    EXPECT_THAT(told("legs = [[0, 0.06, 300, 0]]\n"), IsEmpty());
}

TEST(Advice, OfSizesThatNoFloeHas) {
    const auto told = [](const std::string& more) {
        return advice_for("[floe]\nelement_m = 0.2\n[sizes]\nlaw = \"list\"\nlist_m = [[0.6, 0.6, " + more + "]\n");
    };
    EXPECT_THAT(
        told("99.92], [1.2, 0.6, 0.04], [0.8, 0.8, 0.04]"),
        ElementsAre(testing::AllOf(HasSubstr("sizes.list_m[1] and 1 more of its sizes are so rare that none of "),
                                   HasSubstr(" floes has them; take more floes, or leave them out"))));
    EXPECT_THAT(told("99.96], [1.2, 0.6, 0.04]"),
                ElementsAre(testing::AllOf(HasSubstr("sizes.list_m[1] is so rare that none of "),
                                           HasSubstr(" floes has it; take more floes, or leave it out"))));
    EXPECT_THAT(told("95], [1.2, 0.6, 5]"), IsEmpty());
}

TEST(Advice, OfAMassInKilogramsSaysTonnes) {
    EXPECT_THAT(advice_for("[structure]\nprofile_m = [[-0.443, 0.614], [0.122, 0.614]]\n[moorings]\ngyration_m = 0.44\n"
                           "surge_kN_m = 0.8\nsway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\nmass_t = 525\n"),
                testing::Contains(HasSubstr("moorings.mass_t is in tonnes, and this looks like kilograms")));
}

TEST(Advice, OfAddedMassByANumberAndByAMatrix) {
    const std::string moored =
        "[structure]\nprofile_m = [[-0.443, 0.614], [0.122, 0.614]]\n[moorings]\ngyration_m = 0.44\nmass_t = 0.5\n"
        "surge_kN_m = 0.8\nsway_kN_m = 0.7\nyaw_kN_m_rad = 0.1\n";
    const auto matrix = [](double surge, double sway) {
        std::string rows = fmt::format("added_mass = [[{}, 0, 0, 0, 0, 0], [0, {}, 0, 0, 0, 0]", surge, sway);
        for (int k = 0; k < 4; ++k) rows += ", [0, 0, 0, 0, 0, 0]";
        return rows + "]\n";
    };
    const std::string numbers = "added_surge_t = 0.2\nadded_sway_t = 0.3\n";
    EXPECT_THAT(advice_for(moored + numbers + matrix(0.2, 0)),
                testing::Contains(HasSubstr("case E60: moorings.added_mass is in addition to moorings.added_surge_t = "
                                            "0.2; leave that out if both are of the same water")));
    EXPECT_THAT(advice_for(moored + numbers + matrix(0, 0)), testing::Not(testing::Contains(HasSubstr("added_mass"))));
    EXPECT_THAT(advice_for(moored + matrix(0.2, 0.3)), testing::Not(testing::Contains(HasSubstr("added_mass"))));
}

}  // namespace advice_test
}  // namespace floes
