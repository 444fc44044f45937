// Reading campaigns: cases, overrides, pose files, and every message with its exact text.

#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/read.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace read_test {

const char* const three_cases = R"([campaign]
seed = 7
arrangements = 12
[general]
solver = "lanes"
[joint]
model = "cfm"
[water]
added_mass_from = "share"

[ice]
thickness_m = 0.03

[[case]]
name = "E30"
elastic_modulus_MPa = 30.0
cfm = 0.03

[[case]]
name = "E60"

[[case]]
name = "E200"
ice.elastic_modulus_MPa = 200.0
joint.cfm = 1e-10
)";

std::string load_poses(const std::string& path) {
    if (path == "configs/poses.csv") return "x_m, z_m, yaw_deg\r\n6.4, 0.0, 0.0\n\n20.6, 2.0, 90\n";
    if (path == "configs/over.csv") return "x_m,z_m,yaw_deg\n\n7,0,0\n\n7.5,0,0\n";
    if (path == "configs/wall.csv") return "x_m,z_m,yaw_deg\n7,0,0\n8,2.0995,0\n";
    if (path == "configs/header.csv") return "x,z,yaw\n6.3,0,0\n";
    if (path == "configs/word.csv") return "x_m,z_m,yaw_deg\n6.3,0,0\n6.3,zero,0\n";
    if (path == "configs/four.csv") return "x_m,z_m,yaw_deg\n6.3,0,0,0\n";
    if (path == "configs/far.csv") return "x_m,z_m,yaw_deg\n6.3,1e6,0\n";
    if (path == "configs/empty.csv") return "x_m,z_m,yaw_deg\n\n";
    throw InputError(path + ": this file cannot be read");
}

Campaign read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return read_campaign({text, "configs/a.toml", overrides, true}, load_poses);
}

std::string message(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal_or("accepted", [&] { read(text, overrides); });
}

/// Joints that follow Σ, in sweeps.
const std::string sweeps = "general.solver = \"lanes\"\nwater.added_mass_from = \"share\"\njoint.model = \"cfm\"\n";

/// Two floes in a channel of 15 m, poses to come from `file`.
std::string with_file(const std::string& file) {
    return "[arrangement]\nmethod = \"file\"\nfile = \"" + file +
           "\"\n[field]\nfloes = 2\nconcentration_percent = 1\n[structure]\nspeed_m_s = 0.05\n";
}

TEST(ReadCampaign, CasesOverrideTheTables) {
    const Campaign campaign = read(three_cases);
    EXPECT_EQ(campaign.name, "a");
    EXPECT_EQ(campaign.seed, 7u);
    EXPECT_EQ(campaign.arrangements, 12);
    ASSERT_EQ(campaign.cases.size(), 3u);
    EXPECT_EQ(campaign.cases[0].name, "E30");
    EXPECT_EQ(campaign.cases[0].scenario.joint.cfm, 0.03);
    EXPECT_EQ(campaign.cases[0].scenario.ice.elastic_modulus, 30e6);
    EXPECT_EQ(campaign.cases[1].scenario.joint.cfm, 0.016);
    EXPECT_EQ(campaign.cases[2].scenario.joint.cfm, 1e-10);
    EXPECT_EQ(campaign.cases[2].scenario.ice.elastic_modulus, 200e6);
    for (const Case& one : campaign.cases) EXPECT_EQ(one.scenario.floe.thickness, 0.03);
}

TEST(ReadCampaign, EmptyTextIsTheDefaultCase) {
    const Campaign campaign = read("");
    ASSERT_EQ(campaign.cases.size(), 1u);
    EXPECT_EQ(campaign.cases[0].name, "E60");
    EXPECT_EQ(canonical_text(campaign.cases[0].scenario), canonical_text(Scenario{}));
}

TEST(ReadCampaign, SingleCaseIsNamedFromItsModulus) {
    EXPECT_EQ(read("ice.elastic_modulus_MPa = 7.5\n").cases[0].name, "E7.5");
    EXPECT_EQ(read("", {"ice.elastic_modulus_MPa=200"}).cases[0].name, "E200");
}

TEST(ReadCampaign, WhatIsNotStatedOfEAndSigmaIsToBeFound) {
    const auto with = [&](Pairing pairing, const std::string& text, const std::vector<std::string>& overrides) {
        std::string names;
        for (const Case& one : read(sweeps + text, overrides).cases)
            names += one.pairing == pairing ? one.name + " " : "";
        return names;
    };
    const auto calibrated = [&](const std::string& text, const std::vector<std::string>& overrides = {}) {
        return with(Pairing::find_cfm, text, overrides);
    };
    const auto measured = [&](const std::string& text, const std::vector<std::string>& overrides = {}) {
        return with(Pairing::find_modulus, text, overrides);
    };
    const auto compared = [&](const std::string& text, const std::vector<std::string>& overrides = {}) {
        return with(Pairing::check, text, overrides);
    };
    const std::string modulus = "ice.elastic_modulus_MPa = 45.0\n";
    const std::string cfm = "joint.cfm = 0.02\n";
    const std::string cases =
        "[[case]]\nname = \"plain\"\n"
        "[[case]]\nname = \"short\"\nelastic_modulus_MPa = 30.0\n"
        "[[case]]\nname = \"long\"\nice.elastic_modulus_MPa = 30.0\n"
        "[[case]]\nname = \"both\"\nelastic_modulus_MPa = 30.0\ncfm = 0.03\n"
        "[[case]]\nname = \"cfm\"\ncfm = 0.03\n";
    EXPECT_EQ(calibrated(""), "E60 ");
    EXPECT_EQ(calibrated(modulus), "E45 ");
    EXPECT_EQ(measured(cfm), "cfm0.02 ");
    EXPECT_EQ(compared(modulus + cfm), "E45 ");
    EXPECT_EQ(compared(modulus, {"joint.cfm=0.02"}), "E45 ");
    EXPECT_EQ(calibrated("", {"ice.elastic_modulus_MPa=45"}), "E45 ");
    EXPECT_EQ(calibrated(cases), "plain short long ");
    EXPECT_EQ(measured(cases), "cfm ");
    EXPECT_EQ(compared(cases), "both ");
    EXPECT_EQ(measured(cfm + cases), "plain cfm ");
    EXPECT_EQ(compared(cfm + cases), "short long both ");
    EXPECT_EQ(calibrated(cases, {"case.short.cfm=0.02", "case.plain.elastic_modulus_MPa=30"}), "plain long ");
    EXPECT_EQ(read(sweeps + cases).cases[1].scenario.ice.elastic_modulus, 30e6);
    const Campaign of_file = read_campaign({sweeps + cases, "a.toml", {}}, nullptr);
    EXPECT_EQ(of_file.cases[3].pairing, Pairing::settled) << "a stored text was compared before";
    EXPECT_EQ(compared("run.nominal_modulus = true\n" + modulus + cfm), "");
    EXPECT_EQ(read(modulus).cases[0].pairing, Pairing::settled) << "beams have the E that is stated";
}

TEST(ReadCampaign, RefusesKeysThatNoCaseUses) {
    EXPECT_EQ(message("joint.cfm = 0.02\n"),
              "configs/a.toml:1: joint.cfm = 0.02 has no effect: it needs joint.model = \"cfm\". Add that, or leave "
              "joint.cfm out.");
    EXPECT_EQ(message("", {"joint.erp=0.5"}),
              "--set joint.erp=0.5: joint.erp = 0.5 has no effect: it needs joint.model = \"cfm\". Add that, or leave "
              "joint.erp out.");
    const std::string both = "[joint]\ncfm = 0.02\n[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\n";
    EXPECT_EQ(message(both + "joint.model = \"cfm\"\n"), "accepted") << "one case uses it";
    EXPECT_NE(message(both), "accepted");
    EXPECT_EQ(message("joint.cfm = 0.016\njoint.damping_ratio = 0.05\n"), "accepted") << "as if they were not there";
}

TEST(ReadCampaign, OrderOfTheTextDoesNotMatter) {
    const Campaign one =
        read("[ice]\nthickness_m = 0.03\ndensity_kg_m3 = 900\n[floe]\nelement_m = 0.3\n[campaign]\nseed = 3\n");
    const Campaign other =
        read("campaign.seed = 3\n[floe]\nelement_m = 0.3\n[ice]\ndensity_kg_m3 = 900\nthickness_m = 0.03\n");
    EXPECT_EQ(fingerprint(one), fingerprint(other));
}

TEST(ReadCampaign, OverridesComeLast) {
    const Campaign campaign = read(three_cases, {"campaign.seed=8", "ice.thickness_m=0.04", "ice.thickness_m=0.05",
                                                 "field.far_end=open", "case.E30.cfm=0.05", "case.E200.joint.erp=0.7"});
    EXPECT_EQ(campaign.seed, 8u);
    for (const Case& one : campaign.cases) {
        EXPECT_EQ(one.scenario.floe.thickness, 0.05);
        EXPECT_EQ(one.scenario.field.far_end, FarEnd::open);
    }
    EXPECT_EQ(campaign.cases[0].scenario.joint.cfm, 0.05);
    EXPECT_EQ(campaign.cases[1].scenario.joint.erp, 0.8);
    EXPECT_EQ(campaign.cases[2].scenario.joint.erp, 0.7);
}

TEST(ReadCampaign, CaseOverrideFindsTheLongestName) {
    const std::string text = sweeps + "[[case]]\nname = \"E\"\n[[case]]\nname = \"E.b\"\n";
    EXPECT_EQ(read(text, {"case.E.b.joint.erp=0.5"}).cases[1].scenario.joint.erp, 0.5);
}

TEST(ReadCampaign, PoseFileIsRelativeToTheConfiguration) {
    const Campaign campaign = read(with_file("poses.csv"));
    const ArrangementRule& rule = campaign.cases[0].scenario.arrangement;
    ASSERT_EQ(rule.poses.size(), 2u);
    EXPECT_EQ(rule.poses[1].x, 20.6);
    EXPECT_EQ(rule.poses[1].z, 2.0);
    EXPECT_NEAR(rule.poses[1].yaw, 1.5707963267948966, 1e-15);
    EXPECT_EQ(rule.file, "");
}

TEST(ReadCampaign, EveryMessageIsOneSentence) {
    const std::string cases = three_cases;
    const std::pair<std::string, const char*> table[] = {
        {"\n[ice]\nthicknes_m = 0.03\n",
         "configs/a.toml:3: ice.thicknes_m = 0.03 is not a key; did you mean ice.thickness_m?"},
        {"campaign.seed = -1\n",
         "configs/a.toml:1: campaign.seed = -1 is out of range; allowed: a whole number from 0"},
        {"campaign.arrangements = 0\n",
         "configs/a.toml:1: campaign.arrangements = 0 is out of range; allowed: a whole number from 1 to 20000000"},
        {"field.floes = 0\n",
         "configs/a.toml:1: field.floes = 0 is out of range; allowed: a whole number from 1 to 1000000"},
        {"joint.cfm = 1.0\n",
         "configs/a.toml:1: joint.cfm = 1.0 is out of range; allowed: above 0 and below 1 (at 1 and above the solver "
         "diverges)"},
        {"joint.cfm = 0\n",
         "configs/a.toml:1: joint.cfm = 0 is out of range; allowed: above 0 and below 1 (at 1 and above the solver "
         "diverges)"},
        {"ice.shear_strength_kPa = 0\n",
         "configs/a.toml:1: ice.shear_strength_kPa = 0 is out of range; allowed: above 0 and at most 1000000"},
        {"structure.profile_m = [[-1, -1], [1, 1]]\n",
         "configs/a.toml:1: structure.profile_m[0] = [-1, -1] has a radius_m out of range; allowed: a list of "
         "[height_m, "
         "radius_m], height_m at least -1000 and at most 1000, radius_m at least 0 and at most 1000"},
        {"[case]\nname = \"a\"\n",
         "configs/a.toml:2: case.name = \"a\" is not in a case; begin each case with [[case]], in double brackets"},
        {"[[cases]]\nname = \"a\"\n",
         "configs/a.toml:1: [[cases]] is not a table of a configuration; did you mean [[case]]?"},
        {"[[case]]\ncfm = 0.1\n", "configs/a.toml:1: this [[case]] has no name; begin it with name = \"E60\""},
        {"[[case]]\nname = 60\n", "configs/a.toml:2: name = 60 is not text; allowed: text in quotes"},
        {"[[case]]\nname = \"E 60\"\n",
         "configs/a.toml:2: name = \"E 60\" cannot name a case; allowed: letters, digits and any of _ - + ."},
        {"[[case]]\nname = \"\"\n",
         "configs/a.toml:2: name = \"\" cannot name a case; allowed: letters, digits and any of _ - + ."},
        {"[[case]]\nname = \"a\"\n[[case]]\nname = \"a\"\n",
         "configs/a.toml:4: name = \"a\" names an earlier case too; give each case its own name"},
        {"[[case]]\nname = \"a\"\ncfm = 0.1\njoint.cfm = 0.2\n",
         "configs/a.toml:4: joint.cfm is given twice in this [[case]], first at configs/a.toml:3; keep one"},
        {"[[case]]\nname = \"a\"\ncampaign.seed = 2\n",
         "configs/a.toml:3: campaign.seed = 2 is for all cases; write it in [campaign]"},
        {"[[case]]\nname = \"a\"\njoint.cmf = 0.2\n",
         "configs/a.toml:3: joint.cmf = 0.2 is not a key; did you mean joint.cfm?"},
        {"[[case]]\nname = \"a\"\ncmf = 0.2\n", "configs/a.toml:3: cmf = 0.2 is not a key; did you mean cfm?"},
        {"[floe]\nelement_m = 0.25\nelements = \"squares\"\n",
         "configs/a.toml:2: floe.element_m = 0.25 does not divide floe.length_m = 0.6; the nearest side that does is "
         "0.3"},
        {"[floe]\nlength_m = 0.5\nelements = \"squares\"\n",
         "configs/a.toml:2: floe.element_m = 0.2 does not divide floe.length_m = 0.5; the nearest side that does is "
         "0.166667"},
        {cases + "floe.element_m = 0.25\n",
         "configs/a.toml:26: case E200: floe.element_m = 0.25 does not divide floe.length_m = 0.6; the nearest side "
         "that does "
         "is 0.3"},
        {"[arrangement]\nfile = \"poses.csv\"\n",
         "configs/a.toml:2: arrangement.file = \"poses.csv\" is not used by arrangement.method = \"scattered\"; "
         "write "
         "arrangement.method = \"file\""},
        {with_file("poses.csv") + "[[case]]\nname = \"a\"\narrangement.poses = [[7, 0, 0]]\n",
         "configs/a.toml:3: arrangement.file = \"poses.csv\" and arrangement.poses are both given; keep one"},
        {with_file("none.csv"), "configs/none.csv: this file cannot be read"},
        {with_file("header.csv"),
         "configs/header.csv:1: \"x,z,yaw\" is not the header of a pose file; write x_m,z_m,yaw_deg, "
         "and behind it keys of which each floe has a value of its own, such as ice.thickness_m"},
        {with_file("word.csv"), "configs/word.csv:3: \"6.3,zero,0\" is not a pose; write 3 numbers, x_m,z_m,yaw_deg"},
        {with_file("four.csv"), "configs/four.csv:2: \"6.3,0,0,0\" is not a pose; write 3 numbers, x_m,z_m,yaw_deg"},
        {with_file("empty.csv"),
         "configs/empty.csv: there are no poses; write x_m,z_m,yaw_deg and a line for each floe"},
        {with_file("far.csv"),
         "configs/far.csv: arrangement.poses[0] = [6.3, 1000000.0, 0.0] has a z_m out of range; allowed: a list of "
         "[x_m, z_m, "
         "yaw_deg], x_m at least -100000 and at most 100000, z_m at least -100000 and at most 100000, yaw_deg at least "
         "-360 and "
         "at most 360"},
        {with_file("poses.csv") + "[[case]]\nname = \"a\"\nfield.floes = 3\nfield.concentration_percent = 1.5\n",
         "configs/a.toml:11: field.floes = 3 is not the number of poses given, 2; make them agree"},
    };
    for (const auto& [text, expected] : table) EXPECT_EQ(message(text), expected) << text;
}

TEST(ReadCampaign, AllThatIsWrongIsToldAtOnce) {
    EXPECT_EQ(message("[ice]\nthicknes_m = 0.03\n[floe]\nlength_m = 2000.0\n[field]\nfloes = 0.5\n[[case]]\nname = "
                      "\"a\"\nfloe.element = 1\n"),
              "configs/a.toml:2: ice.thicknes_m = 0.03 is not a key; did you mean ice.thickness_m?\n"
              "configs/a.toml:4: floe.length_m = 2000.0 is out of range; allowed: above 0 and at most 1000\n"
              "configs/a.toml:6: field.floes = 0.5 is not a whole number; allowed: a whole number from 1 to 1000000\n"
              "configs/a.toml:9: floe.element = 1 is not a key; did you mean floe.element_m?")
        << "keys, each by itself";
    EXPECT_EQ(
        message("[floe]\nelement_m = 0.25\n[analysis]\nexceedance_levels_N = [2.0, 1.0]\nwindow_s = 100.01\n[field]\n"
                "ahead_m = 4.0\n[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\nice.thickness_m = 0.02\n"),
        "configs/a.toml:5: case a: analysis.window_s = 100.01 is not a whole number of steps of "
        "general.time_step_s = 0.02; the nearest that is: 100.02\n"
        "configs/a.toml:4: case a: analysis.exceedance_levels_N = [2.0, 1.0] does not rise from each to the "
        "next\n"
        "configs/a.toml:7: field.ahead_m = 4.0 has no effect: it needs field.far_end = \"never\". Add that, or "
        "leave field.ahead_m out.")
        << "what they say together, of several cases once";
}

TEST(ReadCampaign, EveryMessageAboutOverridesIsOneSentence) {
    const std::pair<const char*, const char*> table[] = {
        {"iterations", "--set iterations: this is not key=value; write --set general.iterations=50"},
        {"ice.thicknes_m=0.03",
         "--set ice.thicknes_m=0.03: ice.thicknes_m = 0.03 is not a key; did you mean ice.thickness_m?"},
        {"joint.cfm=0.5",
         "--set joint.cfm=0.5: the [[case]] at configs/a.toml:14 sets joint.cfm itself; override it there, --set "
         "case.NAME.joint.cfm=0.5"},
        {"case.E61.cfm=0.5",
         "--set case.E61.cfm=0.5: case.E61.cfm names no case; the cases are E30, E60, E200, written case.E30.KEY"},
        {"case.E60.cfm=2",
         "--set case.E60.cfm=2: cfm = 2 is out of range; allowed: above 0 and below 1 (at 1 and above the solver "
         "diverges)"},
        {"case.E60.name=E61", "--set case.E60.name=E61: a case cannot be renamed here; rename it in configs/a.toml"},
        {"case.E60.campaign.seed=1",
         "--set case.E60.campaign.seed=1: campaign.seed = 1 is for all cases; write it in [campaign]"},
        {"floe.element_m=0.25",
         "--set floe.element_m=0.25: case E30: floe.element_m = 0.25 does not divide floe.length_m = 0.6; the nearest "
         "side that "
         "does is 0.3"},
    };
    for (const auto& [override_text, expected] : table) EXPECT_EQ(message(three_cases, {override_text}), expected);
}

const std::string two_floes =
    "[arrangement]\nmethod = \"file\"\nposes = [[7, 0, 0], [7.6, 0, 0]]\n[field]\nfloes = 2\nconcentration_percent = "
    "1\n"
    "[structure]\nspeed_m_s = 0.05\n";

TEST(ReadCampaign, GivenPosesThatAreNoArrangementAreRefusedWithTheirPlace) {
    EXPECT_EQ(message(with_file("over.csv")),
              "configs/over.csv, lines 3 and 5: floes 0 and 1, at x = 7.0000 m, z = 0.0000 m and x = 7.5000 m, z = "
              "0.0000 m, overlap by 0.1 m; they are to be 0.002 m apart, the clearance");
    EXPECT_EQ(message(with_file("wall.csv") + "[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\n"),
              "configs/wall.csv, line 3: case a: floe 1 at x = 8.0000 m, z = 2.0995 m is not inside the field: it "
              "lies 0.0005 m from its edge at z = 2.4 m and is to stay 0.002 m within");
    EXPECT_EQ(message(two_floes),
              "configs/a.toml:3: floes 0 and 1, at x = 7.0000 m, z = 0.0000 m and x = 7.6000 m, z = 0.0000 m, touch; "
              "they are to be 0.002 m apart, the clearance");
}

// Files of runs from before poses were refused can still be read.
TEST(ReadCampaign, PosesOfAStoredCampaignAreNotJudged) {
    EXPECT_EQ(read_campaign({two_floes, "a.h5", {}}, nullptr).cases.front().scenario.arrangement.poses.size(), 2u);
}

// A stored configuration has its poses inline, so whoever reads it needs no files.
TEST(ReadCampaign, WithoutLoaderAPoseFileIsRefused) {
    EXPECT_EQ(refusal([] {
                  read_campaign({with_file("poses.csv"), "a.toml", {}}, nullptr);
              }),
              "a.toml:3: arrangement.file = \"poses.csv\" cannot be read here; give arrangement.poses");
}

const Case& only_case(const Campaign& campaign) {
    return campaign.cases.front();
}

TEST(ReadCampaign, APresetOfACaseOverrulesNoOverrideUnseen) {
    const std::string text = sweeps + "[[case]]\nname = \"a\"\ncontact.preset = \"paper\"\n[[case]]\nname = \"b\"\n";
    EXPECT_EQ(refusal([&] { read(text, {"contact.law=crushing"}); }),
              "--set contact.law=crushing: the preset of case a says contact.law = \"rigid\"; override it there, --set "
              "case.a.contact.law=\"crushing\"");
    EXPECT_EQ(read(text, {"contact.law=rigid"}).cases[0].scenario.contact.normal, NormalLaw::rigid);
    EXPECT_EQ(read(text, {"case.a.contact.law=crushing"}).cases[0].scenario.contact.normal, NormalLaw::crushing);
    EXPECT_EQ(read(text, {"contact.erp=0.5"}).cases[0].scenario.contact.erp, 0.5);
}

TEST(Preset, SetsItsKeysBeforeThoseThatAreGiven) {
    const Campaign paper = read(sweeps + "[contact]\nlaw = \"crushing\"\npreset = \"paper\"\n");
    EXPECT_EQ(only_case(paper).scenario.contact.normal, NormalLaw::crushing) << "given beside it, before or after";
    EXPECT_EQ(only_case(paper).scenario.contact.friction, Friction::one_direction);
    const Campaign overridden = read(sweeps + "[contact]\nfriction = \"cone\"\n", {"contact.preset=paper"});
    EXPECT_EQ(only_case(overridden).scenario.contact.friction, Friction::one_direction) << "--set comes after the file";
    const Campaign cases = read(sweeps +
                                "[contact]\npreset = \"paper\"\n[[case]]\nname = \"a\"\ncontact.friction = \"cone\"\n"
                                "contact.preset = \"physical\"\n[[case]]\nname = \"b\"\n");
    EXPECT_EQ(preset_of(cases.cases[0].scenario.contact), ContactPreset::physical);
    EXPECT_EQ(preset_of(cases.cases[1].scenario.contact), ContactPreset::paper);
}

TEST(Preset, OfACaseByOverrideComesBeforeItsKeysToo) {
    const Campaign campaign =
        read(sweeps + "[[case]]\nname = \"a\"\n", {"case.a.contact.law=rigid", "case.a.contact.preset=physical"});
    EXPECT_EQ(only_case(campaign).scenario.contact.normal, NormalLaw::rigid);
    EXPECT_EQ(only_case(campaign).scenario.contact.friction, Friction::cone);
}

TEST(Preset, OfAUserIsPhysicalAndOfAStoredTextThatHasNoneThePapers) {
    EXPECT_EQ(preset_of(only_case(read("")).scenario.contact), ContactPreset::physical);
    EXPECT_EQ(preset_of(only_case(read_campaign({"", "a.h5", {}}, nullptr)).scenario.contact), ContactPreset::paper);
}

}  // namespace read_test
}  // namespace floes
