// What a campaign is: members, fingerprints, differences, and that its text says all of it.

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include <set>

#include "campaign/campaign_keys.hpp"
#include "scenario/keys.hpp"
#include "support/file_bytes.hpp"
#include "support/sweeping_scenario.hpp"

namespace floes {
namespace campaign_test {

Campaign sample() {
    const Scenario scenario = sweeping_scenario();
    Campaign campaign{{"sample", 7, 4}, {{"E30", scenario}, {"E60", scenario}, {"E200", scenario}}, {}};
    campaign.cases[0].scenario.joint.cfm = 0.03;
    campaign.cases[0].scenario.ice.elastic_modulus = 30e6;
    campaign.cases[2].scenario.joint.cfm = 1e-10;
    campaign.cases[2].scenario.ice.elastic_modulus = 200e6;
    return campaign;
}

/// A change of one field that stays within its kind.
struct Perturb {
    void operator()(const NumberField& field) const { field.set(field.get() * 1.0000001 + 1e-12); }
    void operator()(const NumbersField& field) const { field.values->push_back(0.5); }
    void operator()(const IntegerField& field) const { field.set(field.get() + 1); }
    void operator()(const SwitchField& field) const { *field.value = !*field.value; }
    void operator()(const WordField& field) const { field.set((field.get() + 1) % field.words.size()); }
    void operator()(const WordsField& field) const {
        std::vector<bool> chosen = field.get();
        chosen.back() = !chosen.back();
        field.set(chosen);
    }
    void operator()(const TextField& field) const { *field.value += "x"; }
    void operator()(const RowsField& field) const {
        auto rows = field.get();
        rows.emplace_back(field.columns.size(), 0.5);
        field.set(rows);
    }
};

bool can_change(const Key& key) {
    const auto* word = std::get_if<WordField>(&key.field);
    return word == nullptr || word->words.size() > 1;
}

std::string text_of(const std::string& path) {
    return file_text(std::string(FLOES_SOURCE_DIR) + "/" + path);
}

TEST(Campaign, MembersAreArrangementMajor) {
    const Campaign campaign = sample();
    EXPECT_EQ(member_count(campaign), 12);
    std::set<std::pair<int, int>> seen;
    for (int number = 0; number < member_count(campaign); ++number) {
        const MemberKey key = member_key(campaign, number);
        EXPECT_EQ(number, key.arrangement * 3 + key.case_index);
        seen.insert({key.case_index, key.arrangement});
    }
    EXPECT_EQ(seen.size(), 12u);
}

TEST(Campaign, MoreArrangementsKeepTheNumbersOfTheFirst) {
    Campaign more = sample();
    more.arrangements = 40;
    for (int number = 0; number < member_count(sample()); ++number) {
        EXPECT_EQ(member_key(more, number), member_key(sample(), number));
    }
}

TEST(Campaign, CostIsStepsTimesElements) {
    Campaign campaign = sample();
    EXPECT_EQ(expected_cost(campaign, 0), 13500.0 * 189 * 9);
    campaign.cases[1].scenario.floe.element = 0.1;
    EXPECT_EQ(expected_cost(campaign, 1), 4 * expected_cost(campaign, 0));
}

// Of level ice half as much for a step, and for each element in the channel what it costs that the sheet breaks there.
TEST(Campaign, CostOfLevelIceIsOfItsStepsAndOfItsBreaks) {
    Campaign campaign = sample();
    Scenario& scenario = campaign.cases[0].scenario;
    scenario.arrangement.method = ArrangementMethod::level;
    scenario.field.floes = 1;
    scenario.floe.length = scenario.floe.breadth = 2;
    scenario.floe.element = 0.1;
    const auto cost = [&](double speed) {
        scenario.structure.speed = speed;
        return expected_cost(campaign, 0);
    };
    const double width = 2 * scenario.structure.shape.waterline_radius() + scenario.characteristic_length();
    const double still = cost(0);
    EXPECT_EQ(still, 0.5 * 400 * scenario.step_count());
    const double slow = cost(0.02);
    EXPECT_NEAR(slow - still, 0.6 * scenario.towed() * width / 0.01 * 8000, 1);
    EXPECT_NEAR(cost(0.04) - slow, slow - still, 1);
}

TEST(Fingerprint, EveryKeyCounts) {
    const Campaign campaign = sample();
    Campaign changed = sample();
    std::set<std::string> digests{fingerprint(campaign)};
    std::set<std::string> case_digests{case_fingerprint(campaign, 1)};
    int keys_changed = 0;
    for (std::size_t i = 0; i < describe(changed.cases[1].scenario).size(); ++i) {
        changed = sample();
        const Key key = describe(changed.cases[1].scenario)[i];
        if (key.derived() || !can_change(key) || (key.late && key.idle())) continue;
        std::visit(Perturb{}, key.field);
        ++keys_changed;
        EXPECT_TRUE(digests.insert(fingerprint(changed)).second) << key.path;
        EXPECT_TRUE(case_digests.insert(case_fingerprint(changed, 1)).second) << key.path;
        EXPECT_EQ(case_fingerprint(changed, 0), case_fingerprint(campaign, 0)) << key.path;
        const std::vector<std::string> lines = differences(campaign, changed);
        ASSERT_EQ(lines.size(), 1u) << key.path;
        EXPECT_TRUE(lines[0].starts_with(fmt::format("case E60: {}: ", key.path))) << lines[0];
    }
    EXPECT_GT(keys_changed, 50);
}

TEST(Fingerprint, SeedArrangementsAndCaseNamesCountForTheCampaign) {
    const std::string before = fingerprint(sample());
    Campaign changed = sample();
    changed.seed = 8;
    EXPECT_NE(fingerprint(changed), before);
    EXPECT_NE(case_fingerprint(changed, 0), case_fingerprint(sample(), 0));
    changed = sample();
    changed.arrangements = 5;
    EXPECT_NE(fingerprint(changed), before);
    EXPECT_EQ(case_fingerprint(changed, 0), case_fingerprint(sample(), 0));
    changed = sample();
    changed.cases[0].name = "soft";
    EXPECT_NE(fingerprint(changed), before);
    EXPECT_EQ(case_fingerprint(changed, 0), case_fingerprint(sample(), 0));
    changed = sample();
    changed.name = "another";
    EXPECT_EQ(fingerprint(changed), before);
    EXPECT_TRUE(differences(changed, sample()).empty());
    EXPECT_EQ(before.size(), 32u);
}

TEST(Differences, SharedLinesAreGivenOnce) {
    Campaign here = sample();
    for (Case& one : here.cases) one.scenario.general.iterations = 20;
    here.seed = 8;
    here.cases[2].scenario.joint.cfm = 0.001;
    const std::vector<std::string> expected{"campaign.seed: 7 there, 8 here", "general.iterations: 50 there, 20 here",
                                            "case E200: joint.cfm: 1e-10 there, 0.001 here"};
    EXPECT_EQ(differences(sample(), here), expected);
}

TEST(Differences, OtherCasesAreNamed) {
    Campaign here = sample();
    here.cases.pop_back();
    EXPECT_EQ(differences(sample(), here), std::vector<std::string>{"cases: E30, E60, E200 there, E30, E60 here"});
}

TEST(Differences, OfCommonCasesAreNamedBesideOtherCases) {
    Campaign here = sample();
    here.cases.erase(here.cases.begin());
    here.cases[1].scenario.general.iterations = 20;
    const std::vector<std::string> expected{"cases: E30, E60, E200 there, E60, E200 here",
                                            "case E200: general.iterations: 50 there, 20 here"};
    EXPECT_EQ(differences(sample(), here), expected);
}

TEST(WriteCampaign, ReadsBackEqual) {
    Campaign written = sample();
    written.cases[1].scenario.structure.shape = Shape({{-1.0 / 3, 0.1}, {0.0, 0.5}, {0.0, 0.6}, {0.2, 0.7}});
    written.cases[2].scenario.field.far_end = FarEnd::open;
    for (Case& one : written.cases) one.scenario.floe.thickness = 0.1 * 0.3;
    const std::string text = write_campaign(written);
    const Campaign read_back = read_campaign({text, "other.toml", {}}, nullptr);
    EXPECT_EQ(read_back.name, "sample");
    EXPECT_EQ(fingerprint(read_back), fingerprint(written));
    EXPECT_TRUE(differences(written, read_back).empty());
    EXPECT_EQ(write_campaign(read_back), text);
}

TEST(WriteCampaign, GivenPosesReadBackBitForBit) {
    Scenario scenario = sweeping_scenario();
    scenario.arrangement.method = ArrangementMethod::file;
    scenario.field.floes = 9;
    scenario.field.concentration = 0.04;
    for (int i = 0; i < 9; ++i) scenario.arrangement.poses.push_back({7.0 + 0.7 * i, 0.1 * i, 1.1 * i * unit::degree});
    const Campaign written{{"poses", 1, 1}, {{"one", scenario}}, {}};
    const Campaign read_back = read_campaign({write_campaign(written), "f.toml", {}}, nullptr);
    EXPECT_EQ(fingerprint(read_back), fingerprint(written));
}

TEST(WriteCampaign, CasesListOnlyWhatDiffers) {
    const std::string text = write_campaign(sample());
    const std::string cases = text.substr(text.find("[[case]]"));
    EXPECT_EQ(cases,
              "[[case]]\nname = \"E30\"\nice.elastic_modulus_MPa = 30.0\njoint.cfm = 0.03\n\n"
              "[[case]]\nname = \"E60\"\nice.elastic_modulus_MPa = 60.0\njoint.cfm = 0.016\n\n"
              "[[case]]\nname = \"E200\"\nice.elastic_modulus_MPa = 200.0\njoint.cfm = 1e-10\n");
}

TEST(WriteCampaign, WhatIsToBeFoundReadsBackSo) {
    constexpr Pairing settled = Pairing::settled;
    constexpr Pairing cfm = Pairing::find_cfm;
    constexpr Pairing modulus = Pairing::find_modulus;
    for (const std::array<Pairing, 3>& pairings : {std::array{settled, cfm, settled},
                                                   {cfm, settled, cfm},
                                                   {cfm, cfm, cfm},
                                                   {modulus, settled, cfm},
                                                   {modulus, modulus, modulus}}) {
        Campaign written = sample();
        for (std::size_t i = 0; i < 3; ++i) {
            written.cases[i].pairing = pairings[i];
            if (pairings[i] == cfm) written.cases[i].scenario.joint.cfm = Joint{}.cfm;
            if (pairings[i] == modulus) written.cases[i].scenario.ice.elastic_modulus = Ice{}.elastic_modulus;
        }
        const Campaign read_back = read_campaign({write_campaign(written), "other.toml", {}}, nullptr);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read_back.cases[i].pairing, pairings[i]) << i;
        EXPECT_EQ(fingerprint(read_back), fingerprint(written));
        EXPECT_TRUE(differences(written, read_back).empty());
    }
}

TEST(Campaign, AStatedSigmaIsNotTheSameAsOneToBeFound) {
    const Campaign stated = sample();
    Campaign wanted = sample();
    wanted.cases[1].pairing = Pairing::find_cfm;
    EXPECT_NE(fingerprint(wanted), fingerprint(stated));
    EXPECT_NE(case_fingerprint(wanted, 1), case_fingerprint(stated, 1));
    EXPECT_EQ(case_fingerprint(wanted, 0), case_fingerprint(stated, 0));
    EXPECT_EQ(differences(stated, wanted),
              std::vector<std::string>{"case E60: joint.cfm: 0.016 there, to be calibrated here"});
}

TEST(Configurations, DefaultsAreAConfigurationThatSaysTheDefaults) {
    const Campaign campaign = read_campaign({default_configuration(), "defaults.toml", {}, true}, nullptr);
    const Campaign empty = read_campaign({"", "defaults.toml", {}, true}, nullptr);
    EXPECT_EQ(fingerprint(campaign), fingerprint(empty));
    EXPECT_EQ(campaign.name, "defaults");
}

/// Cases of Table 3 that are this scenario but for E and Σ.
void expect_table3(const char* path, const Scenario& expected) {
    const Campaign table3 = read_campaign({text_of(path), path, {}, true}, nullptr);
    EXPECT_EQ(table3.arrangements, 50);
    ASSERT_EQ(table3.cases.size(), 3u);
    const std::pair<double, double> pairs[] = {{30e6, 0.03}, {60e6, 0.016}, {200e6, 1e-10}};
    for (std::size_t i = 0; i < 3; ++i) {
        Scenario wanted = expected;
        wanted.ice.elastic_modulus = pairs[i].first;
        if (expected.joint.model == JointModel::cfm) wanted.joint.cfm = pairs[i].second;
        EXPECT_EQ(differences(table3.cases[i].scenario, wanted), std::vector<std::string>{})
            << path << ", " << table3.cases[i].name;
    }
}

TEST(Configurations, Table3IsThePapersScenario) {
    Scenario papers = paper_scenario();
    papers.contact.erp = 0.8;
    papers.joint.moment_about = MomentAbout::element_centre;
    expect_table3("configs/table3.toml", papers);
}

TEST(Configurations, Table3PhysicalIsThePhysicsThatIsTheDefault) {
    expect_table3("configs/table3_physical.toml", Scenario{});
}

TEST(Configurations, TheExampleOfADesignHasSaltellisPoints) {
    const Campaign design =
        read_campaign({text_of("configs/design_sobol.toml"), "configs/design_sobol.toml", {}}, nullptr);
    EXPECT_EQ(design.cases.size(), 4u * (design.design.axes.size() + 2));
    EXPECT_EQ(design.design.axes.size(), 3u);
}

TEST(Configurations, PageHasTheReferenceThatTheProgramPrints) {
    const std::string page = text_of("docs/configuration.md");
    EXPECT_NE(page.find(reference_markdown()), std::string::npos)
        << "docs/configuration.md does not contain what `floes config --reference` prints";
}

TEST(Configurations, ReferenceNamesEveryKeyOnce) {
    std::set<std::string> keys;
    const CampaignTables all;
    for (const Key& key : all.keys) {
        const std::string path(key.path);
        EXPECT_TRUE(keys.insert(path).second) << path;
        EXPECT_NE(reference_markdown().find("| `" + path + "` |"), std::string::npos) << path;
    }
}

}  // namespace campaign_test
}  // namespace floes
