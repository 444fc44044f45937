// The [stop] table: read, written, and no part of what a member is.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "member/design_of.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace stop_keys_test {

Campaign read(const std::string& text, std::vector<std::string> overrides = {}) {
    return read_campaign({text, "a.toml", std::move(overrides)}, nullptr);
}

TEST(StopKeys, AreReadAndWritten) {
    const Campaign campaign = read(
        "[stop]\nhalf_width_percent = 5\nof = \"mean_maximum\"\ncase = \"none\"\ncontrast = \"B - A\"\nminimum = 30\n"
        "look_ahead = 4\nbatch = 7\n[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\njoint.cfm = 0.01\n");
    StopRule wanted{0.05, "mean_maximum", "none", "B - A", 30, 4, 7};
    EXPECT_EQ(campaign.stop, wanted);
    EXPECT_EQ(read(write_campaign(campaign)).stop, wanted);
}

TEST(StopKeys, AreOffUnlessAsked) {
    EXPECT_FALSE(read("").stop.active());
    EXPECT_TRUE(read("", {"stop.half_width_percent=5"}).stop.active());
}

TEST(StopKeys, ChangeNoMember) {
    const Campaign without = read("");
    const Campaign with = read("[stop]\nhalf_width_percent = 5\n");
    EXPECT_EQ(fingerprint(without), fingerprint(with));
    EXPECT_TRUE(differences(without, with).empty());
}

TEST(StopKeys, MayNameAnAveragedLoadThatEveryCaseTakes) {
    const std::string rule = "[stop]\nof = \"mean_maximum_0.5s\"\n[analysis]\n";
    EXPECT_EQ(read(rule).stop.of, "mean_maximum_0.5s");
    EXPECT_EQ(refusal([&] { read(rule + "averaging_s = [0.2, 1]\n[[case]]\nname = \"A\"\n"); }),
              "a.toml:2: stop.of = \"mean_maximum_0.5s\" is of a time that case A does not average over; its times are "
              "0.2, 1 s (analysis.averaging_s)");
    for (const char* word : {"trend", "trend_0.5s", "load", "mean_maximum_0.50s"})
        EXPECT_THAT(refusal([&] { read("[stop]\nof = \"" + std::string{word} + "\"\n"); }),
                    testing::HasSubstr("is not allowed; use mean_load, sd_load, "));
}

TEST(StopKeys, MayNameADesignLoad) {
    const std::string rule = "[stop]\nhalf_width_percent = 20\nof = \"design_load\"\n";
    const StopRule usual = read(rule).stop;
    EXPECT_EQ(usual.design_of(), find_design_of("load"));
    EXPECT_EQ(usual.exposure, 3 * 3600);
    EXPECT_EQ(usual.averaging, 1);
    EXPECT_EQ(usual.quantile, 0.9);
    const Campaign other = read(rule + "exposure_h = 10\naveraging_s = 0.5\nquantile = 0\n");
    EXPECT_EQ(other.stop.exposure, 10 * 3600);
    EXPECT_EQ(read(write_campaign(other)).stop, other.stop);
    EXPECT_EQ(fingerprint(other), fingerprint(read("")));
}

TEST(StopKeys, RefuseADesignLoadThatNobodyMeasures) {
    const std::string rule = "[stop]\nof = \"design_load\"\n";
    const auto said = [&](const std::string& more) { return refusal([&] { read(rule + more); }); };
    EXPECT_EQ(
        said("averaging_s = 0.3\n[[case]]\nname = \"A\"\n"),
        "a.toml:2: stop.of = \"design_load\" wants peaks of the load averaged over stop.averaging_s = 0.3 s, which "
        "case A does not take; its times are 0.1, 0.5, 1, 2 s (analysis.averaging_s)");
    EXPECT_THAT(said("[analysis]\naveraging_s = []\n"),
                testing::HasSubstr("does not take; it averages over no time (analysis.averaging_s)"));
    EXPECT_THAT(said("averaging_s = 60\n"),
                testing::HasSubstr("stop.averaging_s = 60 is longer than a segment of case"));
    EXPECT_THAT(said("quantile = 0.0001\n"), testing::HasSubstr("stop.quantile = 0.0001 is below 0.001"));
    EXPECT_THAT(said("contrast = \"all\"\n"), testing::HasSubstr("has no paired difference"));
    EXPECT_THAT(said("quantile = 1\n"), testing::HasSubstr("stop.quantile"));
}

constexpr const char* moored =
    "[moorings]\nmass_t = 2\ngyration_m = 0.5\nsurge_kN_m = 10\nsway_kN_m = 10\nyaw_kN_m_rad = 5\n";

TEST(StopKeys, MayNameADesignValueOfAStructureThatGivesWay) {
    const std::string rule = "[stop]\nhalf_width_percent = 20\nof = \"design_mooring_force\"\n";
    EXPECT_EQ(read(rule + moored).stop.design_of(), find_design_of("mooring_force"));
    EXPECT_THAT(
        refusal([&] { read(rule); }),
        testing::HasSubstr("a.toml:3: stop.of = \"design_mooring_force\" is the horizontal resultant of springs, "
                           "lines and turret, which no case has: it is of structures that give way "
                           "(moorings.mass_t) in surge or sway; write"));
    EXPECT_THAT(refusal([&] { read("[stop]\nof = \"design_line_tension\"\n" + std::string{moored}); }),
                testing::HasSubstr("on lines with a break load"));
    EXPECT_THAT(
        refusal([&] { read(rule + moored + "[analysis]\nwindow_s = 3\nsegments = 1\n", {"moorings.mass_t=2000"}); }),
        testing::HasSubstr("is shorter than three natural periods of"));
    EXPECT_EQ(read("[stop]\nof = \"mean_surge_mooring\"\n" + std::string{moored}).stop.design_of(), nullptr);
    EXPECT_THAT(refusal([&] { read("[stop]\nof = \"mean_surge_mooring\"\n"); }),
                testing::HasSubstr("is of structures that give way (moorings.mass_t), and case"));
}

// Of all cases it is those that have the design value.
TEST(StopKeys, AskOfTheCasesThatHaveADesignValue) {
    const std::string cases = "[[case]]\nname = \"fixed\"\n[[case]]\nname = \"soft\"\nmoorings.mass_t = 2\n";
    const std::string held = "[moorings]\ngyration_m = 0.5\nsurge_kN_m = 10\nsway_kN_m = 10\nyaw_kN_m_rad = 5\n";
    const std::string rule = "[stop]\nhalf_width_percent = 20\nof = \"design_offset\"\n";
    EXPECT_EQ(read(rule + "case = \"soft\"\n" + held + cases).stop.case_name, "soft");
    EXPECT_EQ(read(rule + held + cases).stop.case_name, "all");
    EXPECT_THAT(refusal([&] { read(rule + "case = \"fixed\"\n" + held + cases); }),
                testing::HasSubstr("which case fixed has not: it is of structures that give way"));
}

TEST(StopKeys, RefuseCasesThatTellNothing) {
    const std::string cases =
        "[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\n[[case]]\nname = \"C\"\nice.thickness_m = 0.03\n";
    const auto given = [&](const std::string& rule) {
        return read_campaign({"[stop]\nhalf_width_percent = 5\n" + rule + "\n" + cases, "a.toml", {}, true}, nullptr);
    };
    const auto said = [&](const std::string& rule) { return refusal([&] { given(rule); }); };
    EXPECT_EQ(
        said("contrast = \"A - A\""),
        "a.toml:3: stop.contrast = \"A - A\" is 0 in every arrangement, because it is a case less itself; name two "
        "cases that differ");
    EXPECT_EQ(
        said("contrast = \"B - A\""),
        "a.toml:3: stop.contrast = \"B - A\" is 0 in every arrangement, because the two cases differ by their names "
        "alone; name two cases that differ");
    EXPECT_EQ(said("case = \"X\""), "a.toml:3: stop.case names the case 'X', but the cases are A, B, C");
    EXPECT_EQ(said("contrast = \"A - X\""), "a.toml:3: stop.contrast names the case 'X', but the cases are A, B, C");
    EXPECT_THAT(said("contrast = \"A-B\""), testing::HasSubstr("a.toml:3: stop.contrast = \"A-B\" is not a contrast"));
    EXPECT_THAT(said("case = \"none\""), testing::HasSubstr("which say what it applies to"));
    EXPECT_EQ(given("contrast = \"C - A\"").stop.contrast, "C - A");
}

TEST(StopKeys, AreForAllCases) {
    EXPECT_THAT(refusal([] { read("[[case]]\nname = \"A\"\nstop.minimum = 3\n"); }),
                testing::HasSubstr("stop.minimum = 3 is for all cases; write it in [stop]"));
}

}  // namespace stop_keys_test
}  // namespace floes
