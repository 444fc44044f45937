// Hulls of a configuration: by sizes, by a CAD file, by stored pieces.

#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "campaign/drawn.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace hull_read_test {

std::string load(const std::string& path) {
    if (path == "configs/box.stl") return stl_bytes(box({-0.5, -0.4, -0.3}, {0.5, 0.4, 0.2}));
    if (path == "configs/other.stl") return stl_bytes(box({-0.5, -0.4, -0.3}, {0.5, 0.4, 0.25}));
    throw InputError(path + ": this file cannot be read");
}

Campaign read(const std::string& hull) {
    return read_campaign({"[hull]\n" + hull, "configs/a.toml", {}, true}, load);
}

std::string message(const std::string& hull) {
    return refusal_or("", [&] { read(hull); });
}

const std::string of_file = "shape = \"file\"\nfile = \"box.stl\"\n";

TEST(ReadHull, StoresThePiecesAndNotThePath) {
    const Campaign campaign = read(of_file);
    const Structure& structure = campaign.cases.front().scenario.structure;
    EXPECT_TRUE(structure.hull_file.path.empty());
    EXPECT_EQ(structure.shape.piece_rows().size(), 8U);
    EXPECT_NEAR(structure.hull_file.volume, 0.4, 1e-6);
    const std::string text = write_campaign(campaign, "here");
    EXPECT_EQ(text.find("box.stl"), std::string::npos);
    const Campaign again = read_campaign({text, "stored", {}}, nullptr);
    EXPECT_EQ(again.cases.front().scenario.structure.shape, structure.shape);
    EXPECT_EQ(canonical_text(again.cases.front().scenario), canonical_text(campaign.cases.front().scenario));
}

TEST(ReadHull, AChangedFileIsAnotherHull) {
    const Scenario one = read(of_file).cases.front().scenario;
    const Scenario other = read("shape = \"file\"\nfile = \"other.stl\"\n").cases.front().scenario;
    EXPECT_NE(canonical_text(one), canonical_text(other));
    EXPECT_EQ(differing_keys(one, other), (std::vector<std::string>{"hull.pieces", "hull.file_volume_m3"}));
}

TEST(ReadHull, UnusedKeysChangeNoDigest) {
    Scenario plain;
    const std::string before = canonical_text(plain);
    EXPECT_EQ(before.find("hull."), std::string::npos);
    plain.structure.shape.set_size(&HullSizes::beam, 3);
    EXPECT_EQ(canonical_text(plain), before);
}

TEST(ReadHull, SaysWhatIsWrong) {
    EXPECT_EQ(message("file = \"box.stl\""),
              "configs/a.toml:2: hull.file = \"box.stl\" is not used by hull.shape = \"profile\"; write hull.shape = "
              "\"file\"");
    EXPECT_EQ(message("shape = \"file\"\nfile = \"none.stl\""), "configs/none.stl: this file cannot be read");
    EXPECT_EQ(message("shape = \"barge\""),
              "configs/a.toml:2: hull.shape = \"barge\" needs hull.length_m; give it above 0");
    EXPECT_EQ(message("beam_m = 2.0"),
              "configs/a.toml:2: hull.beam_m = 2.0 has no effect: it needs a hull.shape that has it "
              "(docs/structures.md). Add "
              "that, or leave hull.beam_m out.");
    EXPECT_NE(message("shape = \"cylinder\"\ndiameter_m = 0.05\ndraught_m = 1.0\nfreeboard_m = 1.0")
                  .find("less than half of floe.element_m = 0.2"),
              std::string::npos);
    EXPECT_NE(message("shape = \"bargee\"").find("did you mean \"barge\"?"), std::string::npos);
    EXPECT_NE(
        message(
            "shape = \"cylinder\"\ndiameter_m = 6.0\ndraught_m = 1.0\nfreeboard_m = 1.0\n[field]\nhalf_width_m = 2.4")
            .find("does not fit between the ice sheets"),
        std::string::npos);
}

}  // namespace hull_read_test
}  // namespace floes
