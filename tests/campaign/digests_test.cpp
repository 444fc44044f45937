// Members keep the digests that they had under floes 1.0.0, and its keys that are others now are refused with their
// present names.

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "campaign/campaign_keys.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "keys/key.hpp"
#include "scenario/keys.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace digests_test {

using testing::HasSubstr;

std::string text_of(const std::string& path) {
    return file_text(std::string(FLOES_SOURCE_DIR) + "/" + path);
}

Campaign stored(const std::string& text) {
    return read_campaign({text, "a.h5", {}}, nullptr);
}

Campaign every_key() {
    return stored(text_of("tests/campaign/every_key.toml"));
}

struct Former {
    const char* given;
    const char* now;
};

constexpr Former all_former[]{
    {"joint.threshold_form = \"as_printed\"", "paper.threshold_form = \"as_printed\""},
    {"joint.moment_about = \"element_centre\"", "paper.moment_about = \"element_centre\""},
    {"water.form_drag_on = \"every_element\"", "paper.form_drag_on = \"every_element\""},
    {"contact.internal_edges = true", "paper.internal_edges = true"},
    {"contact.split_impulse = false", "paper.split_impulse_depth_m = inf"},
    {"contact.split_impulse = true", "paper.split_impulse_depth_m = 0.04"},
    {"contact.split_impulse_depth_m = 0.01", "paper.split_impulse_depth_m = 0.01"},
    {"analysis.keep_history = false", "analysis.history_steps = 0"},
    {"analysis.keep_history = true", "analysis.history_steps = 1"},
    {"analysis.history_stride = 10", "analysis.history_steps = 10"},
    {"arrangement.start = \"stripes\"", "arrangement.method = \"scattered\""},
    {"design.indices = true", "design.method = \"sobol_indices\""},
};

TEST(FormerKeys, AreRefusedWithWhatToWrite) {
    for (const auto& [given, now] : all_former) {
        const auto read = [](const std::string& text, const std::vector<std::string>& overrides) {
            return refusal([&] { read_campaign({text, "a.toml", overrides, true}, nullptr); });
        };
        EXPECT_EQ(read(fmt::format("\n{}\n", given), {}),
                  fmt::format("a.toml:2: {} is a key of floes 1.0.0; write {}", given, now));
        EXPECT_THAT(read("", {given}), HasSubstr(fmt::format("is a key of floes 1.0.0; write {}", now)));
        if (std::string_view(given).starts_with("design.")) continue;
        EXPECT_EQ(read(fmt::format("[[case]]\nname = \"a\"\n{}\n", given), {}),
                  fmt::format("a.toml:3: {} is a key of floes 1.0.0; write {}", given, now));
    }
}

TEST(FormerKeys, AreRefusedAsAxes) {
    const std::string text =
        "[design]\nmethod = \"grid\"\n[[design.axis]]\nkey = \"contact.internal_edges\"\nvalues = [true, false]\n";
    EXPECT_EQ(refusal([&] {
                  read_campaign({text, "a.toml", {}, true}, nullptr);
              }),
              "a.toml:4: contact.internal_edges is a key of floes 1.0.0; write paper.internal_edges");
}

TEST(FormerKeys, AreRefusedInWhatWasStored) {
    EXPECT_THAT(refusal([] { stored("joint.threshold_form = \"as_printed\"\n"); }),
                HasSubstr("joint.threshold_form = \"as_printed\" is a key of floes 1.0.0"));
}

/// Paths of a list of keys, those of replaced ones included.
void add_former(const Keys& keys, std::vector<std::string>& former) {
    for (const Key& key : keys) {
        if (!key.former.empty()) former.emplace_back(key.former);
        for (const Key& old : key.before)
            if (old.path != key.path) former.emplace_back(old.path);
    }
}

TEST(FormerKeys, AllAreTestedHereAndOnThePage) {
    Scenario scenario;
    Design design;
    std::vector<std::string> former;
    add_former(describe(scenario), former);
    add_former(describe(design), former);
    EXPECT_EQ(former.size(), 10u);
    const std::string page = text_of("docs/configuration.md");
    for (const std::string& path : former) {
        EXPECT_TRUE(std::ranges::any_of(all_former, [&](const Former& one) {
            return std::string_view(one.given).starts_with(path + " = ");
        })) << path;
        EXPECT_THAT(page, HasSubstr(fmt::format("| `{}", path)));
    }
}

// Those of strong, lattice and poses are what floes 1.0.0 made of the same values.
TEST(Digests, AreThoseOf1_0) {
    const Campaign campaign = every_key();
    EXPECT_EQ(fingerprint(campaign), "0909bd9711d2c2ce3cfb65d6e0eacce9");
    const std::pair<const char*, const char*> cases[]{{"monte_carlo", "91371f272b321eaf5094aab414726dbe"},
                                                      {"strong", "9568a2d1fe1c93a51ee9f62e55baec40"},
                                                      {"lattice", "44b5014b357c35ec4143cb01b51eb9c2"},
                                                      {"poses", "8d16659420d188aca17ef73eabbc680f"}};
    ASSERT_EQ(campaign.cases.size(), std::size(cases));
    for (std::size_t k = 0; k < std::size(cases); ++k) {
        EXPECT_EQ(campaign.cases[k].name, cases[k].first);
        EXPECT_EQ(case_fingerprint(campaign, static_cast<int>(k)), cases[k].second) << cases[k].first;
    }
}

TEST(Digests, OfATextThatHasAnotherValueOfEveryKey) {
    Scenario defaults = paper_scenario();
    const Keys usual = keys_of_digest(describe(defaults));
    Scenario scenario;
    const Keys keys = keys_of_digest(describe(scenario));
    const Campaign campaign = every_key();
    const std::set<std::string_view> came_later{"arrangement.columns",
                                                "arrangement.start",  // a key of then, without effect now
                                                "contact.ice_ice_friction_law",
                                                "contact.ice_ice_friction_exponent",
                                                "contact.ice_structure_friction_law",
                                                "contact.ice_structure_friction_exponent",
                                                "contact.friction_speed_m_s",
                                                "contact.least_friction",
                                                "contact.largest_friction",
                                                "contact.friction_direct",
                                                "contact.friction_evolution",
                                                "contact.friction_memory_s",
                                                "general.tolerance_mm_s",
                                                "joint.failure",
                                                "joint.averaging_s",
                                                "floe.elements",
                                                "floe.elements_draw",
                                                "ice.fracture_energy_J_m2",
                                                "water.shelter_draughts",
                                                "water.heave_damping_from",
                                                "water.added_mass_from",
                                                "water.added_mass_in_plane",
                                                "field.sides",
                                                "field.confining_N_m",
                                                "field.closing_speed_m_s",
                                                "water.current_m_s",
                                                "water.current_direction_deg",
                                                "water.turning_deg",
                                                "wind.speed_m_s",
                                                "wind.direction_deg",
                                                "wind.drag",
                                                "wind.air_density_kg_m3",
                                                "field.ahead_m",
                                                "field.behind_m",
                                                "field.level_held",
                                                "field.level_pushed",
                                                "water.depth_m",
                                                "water.bed_slope_deg",
                                                "water.bed_friction"};
    const std::set<std::string_view> tables_came_later{"sizes", "spread", "brine",   "shapes",
                                                       "hull",  "path",   "moorings"};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (tables_came_later.contains(keys[i].table())) continue;
        if (keys[i].path == "arrangement.file" || came_later.contains(keys[i].path)) continue;  // the file: now poses
        EXPECT_TRUE(std::ranges::any_of(campaign.cases, [&](const Case& one) {
            scenario = one.scenario;
            return exact_text(keys[i]) != exact_text(usual[i]);
        })) << keys[i].path;
    }
}

TEST(Digests, StayWhenACampaignIsWrittenAndRead) {
    const Campaign campaign = every_key();
    const std::string text = write_campaign(campaign);
    EXPECT_EQ(fingerprint(stored(text)), fingerprint(campaign));
    EXPECT_TRUE(differences(stored(text), campaign).empty());
    EXPECT_EQ(fingerprint(read_campaign({text, "a.toml", {}, true}, nullptr)), fingerprint(campaign))
        << "a user may give it";
}

// Fingerprints that floes 1.0.0 gives these files of the paper's preset, which then had the keys of 1.0.0 and relied on
// its defaults.
TEST(Digests, OfTheConfigurationsOfFloesStay) {
    const std::pair<const char*, const char*> digests[]{{"table3", "ebf7a12797d15664f2ff500d651ed3bf"},
                                                        {"validation/readings", "055b70b8d2b2cd9dc184e11f766ebf49"}};
    for (const auto& [name, digest] : digests) {
        const std::string path = fmt::format("configs/{}.toml", name);
        EXPECT_EQ(fingerprint(read_campaign({text_of(path), path, {}, true}, text_of)), digest) << path;
    }
}

}  // namespace digests_test
}  // namespace floes
