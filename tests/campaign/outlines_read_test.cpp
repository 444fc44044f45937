// Outlines of a configuration: by a file, by what was stored of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "arrangement/arrangement.hpp"
#include "campaign/campaign.hpp"
#include "campaign/case_words.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "core/error.hpp"
#include "scenario/keys.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace outlines_read_test {

using testing::HasSubstr;

std::string load(const std::string& path) {
    const std::string triangle = "A,0,0\nA,1.5,0\nA,0.5,1\n";
    const std::string square = "B,2,0\nB,3,0\nB,3,1\nB,2,1\n";
    const std::string bay = "C,0,2\nC,1,2\nC,0.6,2.3\nC,1,3\nC,0,3\n";
    if (path == "configs/two.csv") return "floe,x,y\n" + triangle + square;
    if (path == "configs/overlapping.csv") return "floe,x,y\n" + triangle + "B,1,0\nB,2,0\nB,2,1\nB,1,1\n";
    if (path == "configs/bay.csv") return "floe,x,y\n" + triangle + square + bay;
    if (path == "configs/rounded.csv")  // its area, summed in another order, is 2.2e-14 percent larger
        return "floe,x,y\nA,107.128,50.300\nA,106.680,51.027\nA,105.871,51.301\nA,105.133,50.766\nA,105.195,49.864\nA,"
               "105.867,49.278\nA,106.745,49.491\n";
    if (path == "configs/holed.geojson")
        return R"({"type": "Feature", "id": "C", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [
                  [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]],
                  [[0.2, 0.2], [0.2, 0.6], [0.7, 0.6], [0.7, 0.2], [0.2, 0.2]]]}})";
    throw InputError(path + ": this file cannot be read");
}

Campaign read(const std::string& shapes, const std::string& more = "field.floes = 8\n") {
    return read_campaign({"joint.failure = \"moment\"\n" + more + "[shapes]\n" + shapes,
                          "configs/a.toml",
                          {"field.half_width_m=1.6", "analysis.steady_start_s=60", "analysis.window_s=3"},
                          true},
                         load);
}

std::string message(const std::string& shapes, const std::string& more = "field.floes = 8\n") {
    return refusal_or("", [&] { read(shapes, more); });
}

/// Of the first case's floes in an arrangement.
std::vector<double> places(const Campaign& campaign, std::uint32_t number) {
    std::vector<double> found;
    for (const PlanarPose& pose : make_arrangement(campaign.cases.front().scenario, campaign.seed, number).poses())
        found.insert(found.end(), {pose.x, pose.z, pose.yaw});
    return found;
}

const std::string of_file = "kind = \"file\"\nfile = \"two.csv\"\n";

TEST(ReadOutlines, StoresThemAndNotThePath) {
    const Campaign campaign = read(of_file);
    const TracedOutlines& traced = campaign.cases.front().scenario.shapes.traced;
    ASSERT_EQ(traced.outlines.size(), 2u);
    EXPECT_EQ(traced.names, "A, B");
    const std::string text = write_campaign(campaign, "here");
    EXPECT_EQ(text.find("two.csv"), std::string::npos);
    const Campaign again = read_campaign({text, "stored", {}}, nullptr);
    EXPECT_EQ(again.cases.front().scenario.shapes.traced.outlines, traced.outlines);
    EXPECT_EQ(fingerprint(again), fingerprint(campaign));
    EXPECT_EQ(places(again, 3), places(campaign, 3));
    EXPECT_NE(places(again, 3), places(again, 4));
}

TEST(ReadOutlines, ScaleMayBeAnAxis) {
    const Campaign campaign =
        read(of_file +
             "[design]\nmethod = \"grid\"\n[[design.axis]]\nkey = \"shapes.scale\"\nvalues = [1.0, "
             "1.2]\n");
    ASSERT_EQ(campaign.cases.size(), 2u);
    EXPECT_NE(case_fingerprint(campaign, 0), case_fingerprint(campaign, 1));
}

TEST(ReadOutlines, MayBeOfOneCaseOnly) {
    const Campaign campaign = read(
        "file = \"two.csv\"\n[[case]]\nname = \"traced\"\nshapes.kind = \"file\"\n[[case]]\nname = \"drawn\"\n"
        "shapes.kind = \"polygon\"\nfield.floes = 24\n");
    EXPECT_EQ(campaign.cases[0].scenario.shapes.traced.outlines.size(), 2u);
    EXPECT_TRUE(campaign.cases[1].scenario.shapes.traced.outlines.empty());
    const Campaign again = read_campaign({write_campaign(campaign, "here"), "stored", {}}, nullptr);
    EXPECT_EQ(fingerprint(again), fingerprint(campaign));
}

TEST(ReadOutlines, SaysWhatItRead) {
    const std::vector<std::string> words = case_words(read(of_file));
    ASSERT_EQ(words.size(), 1u);
    EXPECT_THAT(words[0], HasSubstr("2 outlines of 0.75 to 1 m², 1.75 m² together"));
    EXPECT_THAT(words[0], HasSubstr("each is that of 4 floes"));
    EXPECT_THAT(words[0], HasSubstr("in arrangement 0 8 traced floes of 3.5 corners on average"));
    const std::vector<std::string> bay = case_words(read("kind = \"file\"\nfile = \"bay.csv\"\n"));
    EXPECT_THAT(bay.at(0), HasSubstr("cover 0 % more"));
    EXPECT_THAT(bay.at(0), HasSubstr("each is that of 2 or 3 floes"));
    const std::vector<std::string> rounded = case_words(read("kind = \"file\"\nfile = \"rounded.csv\"\n"));
    EXPECT_THAT(rounded.at(0), HasSubstr("cover 0 % more than as they were traced, at most 0 % ("));
    const std::vector<std::string> holed =
        case_words(read("kind = \"file\"\nfile = \"holed.geojson\"\nmost_added_percent = 30\n"));
    EXPECT_THAT(holed.at(0), HasSubstr("at most 25 % (outline 1 \"C\")"));
}

TEST(ReadOutlines, LieAsTracedOrAreRefusedWithTheFloes) {
    const std::string as_traced =
        "field.floes = 2\narrangement.method = \"traced\"\nfield.concentration_percent = 10\n";
    const Campaign campaign = read(of_file, as_traced);
    EXPECT_EQ(places(campaign, 0), places(campaign, 9));
    EXPECT_THAT(case_words(campaign).at(0), HasSubstr("every arrangement is the same"));
    const std::string dense = "field.floes = 2\narrangement.method = \"traced\"\nfield.concentration_percent = 30\n";
    EXPECT_THAT(message(of_file, dense), HasSubstr("the outlines reach over 3 m x 1 m, for which "
                                                   "field.concentration_percent is at most 18.2 and field.half_width_m "
                                                   "at least 0.502"));  // 1.75 m² in 3.004 m x 3.2 m
    EXPECT_THAT(message("kind = \"file\"\nfile = \"overlapping.csv\"\n", as_traced),
                HasSubstr("configs/a.toml:3: floes 0 and 1 are "));
}

TEST(ReadOutlines, SaysWhatIsWrong) {
    EXPECT_EQ(
        message("file = \"two.csv\"", ""),
        "configs/a.toml:3: shapes.file = \"two.csv\" has no effect: it needs shapes.kind = \"file\". Add that, or "
        "leave shapes.file out.");
    EXPECT_EQ(message("kind = \"file\"\nfile = \"none.csv\""), "configs/none.csv: this file cannot be read");
    EXPECT_EQ(message("kind = \"file\""),
              "configs/a.toml:4: shapes.kind = \"file\" needs outlines; give shapes.file or shapes.outlines");
    EXPECT_THAT(message("kind = \"file\"\nfile = \"holed.geojson\""),
                HasSubstr("configs/a.toml:5: outline 1 \"C\" has holes: filled it would cover 25 % more"));
    EXPECT_EQ(message(of_file + "outlines = [[0, 0, 0], [0, 1, 0], [0, 1, 1]]"),
              "configs/a.toml:5: shapes.file = \"two.csv\" and shapes.outlines are both given; keep one");
    EXPECT_THAT(message("scale = 2.0", ""), HasSubstr("has no effect: it needs shapes.kind = \"file\""));
}

TEST(ReadOutlines, UnusedKeysChangeNoDigest) {
    Scenario plain;
    const std::string before = canonical_text(plain);
    plain.shapes.traced.scale = 3;
    plain.shapes.traced.outlines = {{{0, 0}, {1, 0}, {0, 1}}};
    EXPECT_EQ(canonical_text(plain), before);
    EXPECT_EQ(before.find("shapes"), std::string::npos);
}

}  // namespace outlines_read_test
}  // namespace floes
