// floes config: what it prints and how it ends.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "campaign/campaign_keys.hpp"
#include "campaign/write.hpp"
#include "cli/given.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace config_test {

using testing::HasSubstr;

const std::string table3 = std::string(FLOES_SOURCE_DIR) + "/configs/table3.toml";

/// Standard output of `floes config ARGUMENTS`; throws what main() would turn into an exit status.
std::string config(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "config");
    return verb_output(add_config, arguments);
}

TEST(Config, PrintsDefaultsAndReference) {
    EXPECT_EQ(config({"--defaults"}), default_configuration());
    EXPECT_EQ(config({"--reference"}), reference_markdown());
}

TEST(Config, ReferenceOfOneTableHasItsKeysAlone) {
    const std::string stop = config({"--reference", "stop"});
    EXPECT_NE(reference_markdown().find(stop), std::string::npos);
    EXPECT_TRUE(stop.starts_with("## [stop]\n")) << stop;
    std::size_t rows = 0;
    const CampaignTables all;
    for (const Key& key : all.keys) {
        const bool has = stop.find("| `" + std::string(key.path) + "` |") != std::string::npos;
        EXPECT_EQ(has, key.table() == "stop") << key.path;
        rows += has ? 1 : 0;
    }
    const nlohmann::json keys = nlohmann::json::parse(config({"--reference", "stop", "--format", "json"})).at("keys");
    EXPECT_EQ(keys.size(), rows);
    EXPECT_THROW(config({"--reference", "stops"}), InputError);
    EXPECT_THROW(config({"stop"}), CommandLineEnd);
}

TEST(Config, ReferenceAsJsonHasEveryKey) {
    const nlohmann::json keys = nlohmann::json::parse(config({"--reference", "--format", "json"})).at("keys");
    const CampaignTables all;
    ASSERT_EQ(keys.size(), all.keys.size());
    for (std::size_t i = 0; i < all.keys.size(); ++i) {
        const Key& key = all.keys[i];
        EXPECT_EQ(keys[i].at("key"), std::string(key.path));
        EXPECT_EQ(keys[i].at("default"), literal(key));
        EXPECT_EQ(keys[i].at("allowed"), allowed(key));
        EXPECT_EQ(keys[i].at("meaning"), std::string(key.doc));
        EXPECT_EQ(keys[i].at("source"), std::string(key.source));
    }
}

TEST(Config, CheckCountsMembers) {
    EXPECT_EQ(config({"--check", table3}), "ok: 3 cases x 50 arrangements = 150 members\n");
    EXPECT_EQ(config({"--check", table3, "--set", "campaign.arrangements=1"}),
              "ok: 3 cases x 1 arrangement = 3 members\n");
}

TEST(Config, CheckWarnsOfElementsTooLargeToBreakWhereTheIceWould) {
    const std::string answer = config({"--check", table3, "--set", "floe.element_m=0.3"});
    EXPECT_EQ(answer, "ok: 3 cases x 50 arrangements = 150 members\n");
    const std::string coarse = config({"--check", table3, "--set", "floe.element_m=0.6"});
    EXPECT_NE(coarse.find("but case E30: floe.element_m = 0.6 is not below 0.317 m"), std::string::npos) << coarse;
    EXPECT_NE(coarse.find("Less so, the same holds for E60, E200."), std::string::npos) << coarse;
}

TEST(Config, SaysOfAnEmptyFileThatItStatesNoKey) {
    const TemporaryFolder folder;
    std::ofstream(folder / "empty.toml") << "# to be written\n\n";
    std::ofstream(folder / "one.toml") << "campaign.seed = 2";
    for (const auto& [name, said] : {std::pair{"empty.toml", true}, {"one.toml", false}}) {
        testing::internal::CaptureStderr();
        verb_output(add_config, {"config", "--check", folder / name});
        const bool remark = testing::internal::GetCapturedStderr().find(
                                "states no key, so everything has its default") != std::string::npos;
        EXPECT_EQ(remark, said) << name;
    }
}

// Costs go with elements and steps: half the side is four times the elements, twice the window not quite twice the run.
TEST(Config, CheckSaysWhatMooredMembersCost) {
    const std::string answer = config({"--check", std::string(FLOES_SOURCE_DIR) + "/configs/kulluk.toml"});
    EXPECT_THAT(answer, HasSubstr("case 0.3_m: a member takes about "));
    EXPECT_THAT(answer, HasSubstr(" elements over 7000 steps; with floe.element_m of "));
    EXPECT_THAT(answer, HasSubstr("; with analysis.window_s of 225 s "));
    EXPECT_THAT(answer, HasSubstr(", of 900 s "));
}

TEST(Config, CheckSaysThatNoHullIsStated) {
    const TemporaryFolder folder;
    std::ofstream(folder / "ice.toml") << "ice.thickness_m = 0.03\n";
    EXPECT_THAT(config({"--check", (folder / "ice.toml").string()}), HasSubstr("\nNo hull is stated: the paper's "));
}

TEST(Config, ResolvedSaysWhatIsDerived) {
    const std::string file = std::string(FLOES_SOURCE_DIR) + "/ensemble/cli/starters/turret.toml";
    EXPECT_THAT(config({"--resolved", file}), HasSubstr("\nhalf_width_m = 260.0  # derived: the path goes "));
}

TEST(Config, ResolvedIsTheWholeCampaign) {
    EXPECT_EQ(config({"--resolved", table3, "--set", "general.iterations=20"}),
              write_campaign(load_campaign(table3, {"general.iterations=20"})));
}

TEST(Config, RefusesBadInputAndUsage) {
    EXPECT_THROW(config({"--check", table3, "--set", "floe.element_m=0.25"}), InputError);
    EXPECT_THROW(config({"--check", table3 + ".none"}), InputError);
    EXPECT_THROW(config({"--check", FLOES_SOURCE_DIR}), InputError);
    const TemporaryFolder folder;
    std::ofstream(folder / "photo.csv") << "x_m,z_m,yaw_deg\n7,0,0\n7.5,0,0\n";
    std::ofstream(folder / "photo.toml") << "[arrangement]\nmethod = \"file\"\nfile = \"photo.csv\"\n"
                                            "[field]\nfloes = 2\nconcentration_percent = 1\n"
                                            "[structure]\nspeed_m_s = 0.05\n";
    EXPECT_THROW(config({"--check", (folder / "photo.toml").string()}), InputError);
    EXPECT_THROW(config({}), CommandLineEnd);
    EXPECT_THROW(config({"--defaults", "--reference"}), CommandLineEnd);
    EXPECT_THROW(config({"--defaults", "--format", "json"}), CommandLineEnd);
}

}  // namespace config_test
}  // namespace floes
