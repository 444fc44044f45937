// Designs: their points in the unit that keys have, cases of them, what is written and read back, and what is refused.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "campaign/campaign.hpp"
#include "campaign/case_words.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace design_test {

using testing::ElementsAre;
using testing::HasSubstr;

Campaign read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return read_campaign({text, "a.toml", overrides}, nullptr);
}

std::string message(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal_or("accepted", [&] { read(text, overrides); });
}

std::vector<std::string> names(const Campaign& campaign) {
    std::vector<std::string> all;
    for (const Case& one : campaign.cases) all.push_back(one.name);
    return all;
}

std::string design(const std::string& keys) {
    return "[design]\n" + keys + "\n";
}

std::string axis(const std::string& key, const std::string& rest) {
    return "[[design.axis]]\nkey = \"" + key + "\"\n" + rest + "\n";
}

const std::string two_cases = "[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\ngeneral.iterations = 20\n";

TEST(Design, AGridCombinesAndNamesByValues) {
    const Campaign campaign =
        read(design("method = \"grid\"") + axis("elastic_modulus_MPa", "values = [30, 60.5]") +
             axis("field.far_end", "values = [\"open\", \"ice_sheet\"]") + "[joint]\ncfm = 0.016\n");
    EXPECT_THAT(names(campaign), ElementsAre("30_open", "30_ice_sheet", "60.5_open", "60.5_ice_sheet"));
    EXPECT_EQ(campaign.cases[2].scenario.ice.elastic_modulus, 60.5e6);
    EXPECT_EQ(campaign.cases[2].scenario.field.far_end, FarEnd::open);
    EXPECT_EQ(campaign.cases[3].point, 3);
    EXPECT_EQ(numeric_value(campaign.cases[2], "ice.elastic_modulus_MPa"), 60.5);
    EXPECT_EQ(numeric_value(read("", {"field.concentration_percent=57"}).cases[0], "field.concentration_percent"), 57);
}

TEST(Design, KeepsTheNamesOfItsPointsWhenItGrows) {
    const std::string keys = axis("ice.thickness_m", "from = 0.02\nto = 0.04");
    const auto grown = [&](int points) {
        return names(read(design(fmt::format("method = \"sobol\"\npoints = {}", points)) + keys));
    };
    std::vector<std::string> of_more = grown(1024);
    EXPECT_EQ(of_more.back(), "p1023");
    of_more.resize(4);
    EXPECT_EQ(of_more, grown(4));
}

std::string points(const std::string& path) {
    if (path == "two.csv") return "ice.thickness_m;field.far_end\n0,03;open\n0,04;ice_sheet\n";
    if (path == "short.csv") return "ice.thickness_m,field.far_end\n0.03\n";
    if (path == "empty.csv") return "ice.thickness_m\n";
    if (path == "gap.csv") return "ice.thickness_m,field.far_end\n0.03,\n";
    if (path == "otherwise.csv")
        return "sep=\t\r ice.thickness_m \tfield.far_end\t\r+.03\topen\r4e-2\t\"ice_sheet\"\t\r\t\t\r";
    if (path == "pandas.csv") return ",ice.thickness_m\n0,0.02\n1,0.03\n";
    if (path == "twice.csv") return "ice.thickness_m,field.far_end\n0.03,open\n0.04,open\n3e-2,open\n";
    if (path == "word.csv") return "field.far_end,ice.thickness_m\nopen,0.03\nopen,thin\n";
    return "ice.thicknes_m\n0.03\n";
}

TEST(Design, PointsOfAFileAreTheSameAsAxes) {
    const std::string file = design("method = \"list\"\npoints_file = \"two.csv\"") + two_cases;
    const std::string axes = design("method = \"list\"") + axis("ice.thickness_m", "values = [0.03, 0.04]") +
                             axis("field.far_end", "values = [\"open\", \"ice_sheet\"]") + two_cases;
    const Campaign from_file = read_campaign({file, "a.toml", {}}, points);
    const Campaign from_axes = read(axes);
    EXPECT_EQ(names(from_file), names(from_axes));
    EXPECT_EQ(fingerprint(from_file), fingerprint(from_axes));
    const std::string otherwise = design("method = \"list\"\npoints_file = \"otherwise.csv\"") + two_cases;
    EXPECT_EQ(fingerprint(read_campaign({otherwise, "a.toml", {}}, points)), fingerprint(from_axes));
    EXPECT_EQ(write_campaign(from_file, ""), write_campaign(from_axes, "")) << "stored as axes";
}

TEST(Design, PointsOfAFileAreRefusedWithTheirLine) {
    const auto refused = [](const std::string& keys, const std::string& more = "") {
        return refusal([&] { read_campaign({design(keys) + more, "a.toml", {}, true}, points); });
    };
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"short.csv\""),
                HasSubstr("short.csv:2: \"0.03\" is not a point"));
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"empty.csv\""), HasSubstr("there are no points"));
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"gap.csv\""),
                HasSubstr("gap.csv:2: field.far_end has no value"));
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"word.csv\""),
                HasSubstr("word.csv:3: ice.thickness_m = \"thin\" is not a number"));
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"pandas.csv\""),
                HasSubstr("pandas.csv:1: column 1 has no name"));
    EXPECT_EQ(
        refused("method = \"list\"\npoints_file = \"twice.csv\""),
        "twice.csv:4: this point of the design is there already, at twice.csv:2, and would give the same members; "
        "keep one");
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"typo.csv\""),
                HasSubstr("did you mean \"ice.thickness_m\""));
    EXPECT_THAT(refused("method = \"grid\"\npoints_file = \"two.csv\""), HasSubstr("write design.method = \"list\""));
    EXPECT_THAT(refused("method = \"list\"\npoints_file = \"two.csv\"", axis("ice.thickness_m", "values = [0.03]")),
                HasSubstr("are both given; keep one"));
    EXPECT_THAT(message(design("method = \"list\"\npoints_file = \"two.csv\"")), HasSubstr("cannot be read here"));
}

TEST(Design, AListHasEachPointOnce) {
    const auto read_list = [](const std::string& thicknesses, const std::string& speeds) {
        const std::string text = design("method = \"list\"") + axis("ice.thickness_m", "values = " + thicknesses) +
                                 axis("structure.speed_m_s", "values = " + speeds);
        return read_campaign({text, "a.toml", {}, true}, nullptr);
    };
    EXPECT_EQ(refusal([&] { read_list("[0.02, 0.03, 2e-2]", "[0.05, 0.05, 0.05]"); }),
              "a.toml:3, point 2: this point of the design is there already, at a.toml:3, point 0, and would give the "
              "same members; keep one");
    EXPECT_EQ(read_list("[0.02, 0.03, 0.02]", "[0.05, 0.05, 0.06]").cases.size(), 3u);
}

TEST(Design, AListGoesSideBySide) {
    const std::string profiles =
        "values = [[[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]], [[-0.443, 0.171], [0.122, 0.736]]]";
    const Campaign campaign = read(design("method = \"list\"") + axis("structure.profile_m", profiles) +
                                   axis("general.iterations", "values = [20, 50]") + "[[case]]\nname = \"A\"\n");
    EXPECT_THAT(names(campaign), ElementsAre("A+p000", "A+p001"));  // a profile is no name
    EXPECT_EQ(campaign.cases[0].scenario.structure.shape.rows().size(), 3u);
    EXPECT_EQ(campaign.cases[1].scenario.general.iterations, 50);
}

TEST(Design, EveryCaseIsRunAtEveryPoint) {
    const Campaign campaign =
        read(design("method = \"list\"") + axis("ice.thickness_m", "values = [0.03, 0.04]") + two_cases);
    EXPECT_THAT(names(campaign), ElementsAre("A+0.03", "A+0.04", "B+0.03", "B+0.04"));
    EXPECT_EQ(campaign.cases[2].base, "B");
    EXPECT_EQ(campaign.cases[2].scenario.general.iterations, 20);
    EXPECT_EQ(campaign.cases[2].scenario.floe.thickness, 0.03);
}

const std::string sobol_axes =
    axis("ice.thickness_m", "from = 0.02\nto = 0.04") + axis("joint.cfm", "from = 0.001\nto = 0.1\nscale = \"log\"");

TEST(Design, ALatinHypercubeMeetsEachPartOnce) {
    constexpr int points = 50;
    const Campaign campaign = read(design("method = \"latin_hypercube\"\npoints = 50") + sobol_axes);
    ASSERT_EQ(campaign.cases.size(), 50u);
    std::set<int> thickness;
    std::set<int> cfm;
    for (const Case& one : campaign.cases) {
        thickness.insert(static_cast<int>(points * (one.scenario.floe.thickness - 0.02) / 0.02));
        cfm.insert(static_cast<int>(points * std::log(one.scenario.joint.cfm / 0.001) / std::log(100)));
    }
    EXPECT_EQ(thickness.size(), 50u);
    EXPECT_EQ(cfm.size(), 50u);
    EXPECT_EQ(*thickness.begin(), 0);
    EXPECT_EQ(*thickness.rbegin(), 49);
}

TEST(Design, SixteenSobolPointsMeetEachSixteenthAndEachQuarterSquareOnce) {
    const Campaign campaign = read(design("method = \"sobol\"\npoints = 16") + sobol_axes);
    std::set<int> sixteenths;
    std::set<std::pair<int, int>> squares;
    for (const Case& one : campaign.cases) {
        const double x = (one.scenario.floe.thickness - 0.02) / 0.02;
        const double y = std::log(one.scenario.joint.cfm / 0.001) / std::log(100);
        sixteenths.insert(static_cast<int>(16 * x));
        squares.emplace(static_cast<int>(4 * x), static_cast<int>(4 * y));
    }
    EXPECT_EQ(sixteenths.size(), 16u);
    EXPECT_EQ(squares.size(), 16u);
}

TEST(Design, ASobolDesignGrowsAtItsEnd) {
    const Campaign few = read(design("method = \"sobol_indices\"\npoints = 8") + sobol_axes);
    const Campaign more = read(design("method = \"sobol_indices\"\npoints = 16") + sobol_axes);
    ASSERT_EQ(few.cases.size(), 8u * 4);
    ASSERT_EQ(more.cases.size(), 16u * 4);
    for (int k = 0; k < 32; ++k) EXPECT_EQ(case_fingerprint(few, k), case_fingerprint(more, k));
}

TEST(Design, SaltellisPointsMixAAndB) {
    const Campaign campaign = read(design("method = \"sobol_indices\"\npoints = 8") + sobol_axes);
    for (std::size_t base = 0; base < campaign.cases.size(); base += 4) {
        const auto at = [&](std::size_t r) {
            const Scenario& scenario = campaign.cases[base + r].scenario;
            return std::pair(scenario.floe.thickness, scenario.joint.cfm);
        };
        const auto [a, b] = std::pair(at(0), at(1));
        EXPECT_NE(a.first, b.first);  // the digital shift: without it the first base point is one point four times
        EXPECT_NE(a.second, b.second);
        EXPECT_EQ(at(2), std::pair(b.first, a.second));
        EXPECT_EQ(at(3), std::pair(a.first, b.second));
    }
}

TEST(Design, WholeNumbersAreMetEquallyOften) {
    const Campaign campaign =
        read(design("method = \"latin_hypercube\"\npoints = 300") + axis("general.iterations", "from = 20\nto = 22"));
    std::map<int, int> counts;
    for (const Case& one : campaign.cases) ++counts[one.scenario.general.iterations];
    EXPECT_THAT(counts, ElementsAre(std::pair(20, 100), std::pair(21, 100), std::pair(22, 100)));
}

// The radius at the keel is a part of the profile: read after it wherever it stands, never written, and none of its own
// in digests.
TEST(Design, HasAPartOfTheProfileAsAnAxis) {
    const std::string profile = "[structure]\nkeel_radius_m = 0.3\nprofile_m = [[-0.5, 0.4], [0.0, 0.6], [0.1, 0.7]]\n";
    EXPECT_EQ(read(profile).cases[0].scenario.structure.shape, Shape({{-0.5, 0.3}, {0, 0.6}, {0.1, 0.7}}));
    const Campaign campaign =
        read(design("method = \"grid\"") + axis("structure.keel_radius_m", "values = [0.3, 0.5]") + profile);
    ASSERT_EQ(campaign.cases.size(), 2u);
    EXPECT_EQ(campaign.cases[1].scenario.structure.shape, Shape({{-0.5, 0.5}, {0, 0.6}, {0.1, 0.7}}));
    EXPECT_EQ(numeric_value(campaign.cases[1], "structure.keel_radius_m"), 0.5);
    const std::string written = write_campaign(campaign);
    EXPECT_EQ(written.find("keel_radius_m ="), std::string::npos);
    const Campaign again = read(written);
    EXPECT_EQ(fingerprint(again), fingerprint(campaign));
    EXPECT_EQ(again.cases[1].scenario.structure.shape, campaign.cases[1].scenario.structure.shape);
    const Campaign direct = read("[structure]\nprofile_m = [[-0.5, 0.3], [0.0, 0.6], [0.1, 0.7]]\n");
    EXPECT_EQ(case_fingerprint(direct, 0), case_fingerprint(read(profile), 0));
}

TEST(Design, FollowsTheSeed) {
    const std::string text = design("method = \"sobol\"\npoints = 8") + sobol_axes;
    EXPECT_EQ(fingerprint(read(text)), fingerprint(read(text)));
    EXPECT_NE(read(text).cases[0].scenario.floe.thickness,
              read(text, {"campaign.seed=2"}).cases[0].scenario.floe.thickness);
}

TEST(Design, ReadsBackWhatItWrites) {
    for (const std::string& text :
         {design("method = \"sobol_indices\"\npoints = 4") + sobol_axes + two_cases,
          design("method = \"latin_hypercube\"\npoints = 5") + axis("general.iterations", "from = 20\nto = 60"),
          design("method = \"grid\"") + axis("field.far_end", "values = [\"open\", \"ice_sheet\"]") +
              axis("ice.bending_strength_kPa", "values = [30, 40.0]\nscale = \"log\"") + two_cases}) {
        const Campaign campaign = read(text);
        const std::string written = write_campaign(campaign);
        const Campaign again = read(written);
        EXPECT_EQ(fingerprint(again), fingerprint(campaign));
        EXPECT_EQ(write_campaign(again), written);
        EXPECT_EQ(again.cases.back().base, campaign.cases.back().base);
        EXPECT_EQ(again.cases.back().point, campaign.cases.back().point);
        EXPECT_EQ(again.design.axes.size(), campaign.design.axes.size());
        EXPECT_EQ(again.design.axes.back().scale, campaign.design.axes.back().scale);
    }
}

TEST(Design, AnOverrideOfACaseIsForItsPoints) {
    const Campaign campaign = read(design("method = \"sobol\"\npoints = 2") + sobol_axes + two_cases,
                                   {"case.A.general.iterations=30", "design.points=3"});
    ASSERT_EQ(campaign.cases.size(), 6u);
    EXPECT_EQ(campaign.cases[2].scenario.general.iterations, 30);
    EXPECT_EQ(campaign.cases[3].scenario.general.iterations, 20);
}

TEST(Design, EveryMistakeIsASentence) {
    const std::string grid = design("method = \"grid\"");
    const std::string sobol = design("method = \"sobol\"\npoints = 4");
    const std::string thickness = axis("ice.thickness_m", "values = [0.02, 0.03]");
    const std::pair<std::string, const char*> wrong[]{
        {grid, "a.toml:2: design.method = \"grid\" wants axes; write [[design.axis]]"},
        {thickness, "a.toml:1: this [[design.axis]] has no design; write [design]"},
        {design("points = 4"), "a.toml:2: design.points is given and no design.method"},
        {design("method = \"sobol\"") + sobol_axes, "a.toml:2: design.method = \"sobol\" wants design.points"},
        {design("method = \"grid\"\npoints = 4") + thickness, "a.toml:3: design.points = 4 is not used by"},
        {design("method = \"sobul\""), "did you mean \"sobol\"?"},
        {grid + "[[design.axis]]\nvalues = [1]\n", "a.toml:3: this [[design.axis]] has no key"},
        {grid + axis("ice.thicknes_m", "values = [1]"), "did you mean \"ice.thickness_m\"?"},
        {grid + axis("campaign.seed", "values = [1]"), "is not a key that a case takes"},
        {grid + axis("paper.split_impulse_depth_m", "values = [0.04, inf]"), "the values of an axis are finite"},
        {grid + axis("ice.thickness_m", "value = [0.03]"),
         "a.toml:5: value = [0.03] is not a key of an axis; did you "
         "mean values?"},
        {grid + axis("ice.thickness_m", ""), "a.toml:3: the axis ice.thickness_m has no values"},
        {grid + axis("ice.thickness_m", "values = []"), "allowed: a list of one value or more"},
        {grid + axis("ice.thickness_m", "values = [0.03, -1]"), "a.toml:5: ice.thickness_m = -1 is out of range"},
        {grid + axis("ice.thickness_m", "values = [\"thin\"]"), "is not a number"},
        {grid + axis("ice.thickness_m", "values = [0.03, 0.03]"), "has 0.03 twice"},
        {grid + axis("ice.thickness_m", "from = 0.02\nto = 0.03"), "which are for latin_hypercube and sobol"},
        {grid + axis("contact.ice_ice_friction", "values = [0.0, 0.1]\nscale = \"log\""),
         "a logarithm wants values above 0"},
        {grid + axis("field.far_end", "values = [\"open\"]\nscale = \"log\""), "takes no numbers, so it has no scale"},
        {sobol + thickness, "has values, which are for a grid or a list"},
        {sobol + axis("field.far_end", "from = 1\nto = 2"), "takes no numbers, so it has no from and to"},
        {sobol + axis("ice.thickness_m", "from = 0.02"), "wants from and to"},
        {sobol + axis("ice.thickness_m", "from = 0.03\nto = 0.02"), "goes from 0.03 to 0.02; from must be below to"},
        {sobol + axis("contact.ice_ice_friction", "from = 0.0\nto = 0.1\nscale = \"log\""),
         "a logarithm wants values above 0"},
        {sobol + axis("joint.cfm", "from = 0.1\nto = 2.0"), "a.toml:7: joint.cfm = 2.0 is out of range"},
        {sobol + axis("general.iterations", "from = 20\nto = 30.5"), "is not a whole number"},
        {sobol + sobol_axes + axis("cfm", "from = 0.1\nto = 0.2"), "joint.cfm has an axis already, at a.toml:"},
        {design("method = \"list\"") + thickness + axis("joint.cfm", "values = [0.1]"),
         "so all want equally many, and ice.thickness_m has 2, joint.cfm has 1"},
        {design("method = \"sobol_indices\"\npoints = 30000") + sobol_axes, "makes more than 100000 points"},
        {sobol + sobol_axes + "[[case]]\nname = \"A\"\nice.thickness_m = 0.03\n",
         "a.toml:15: ice.thickness_m = 0.03 is hidden by the axis of the design at a.toml:4"},
        {"[design.axis]\nkey = \"ice.thickness_m\"\n", "begin each axis with [[design.axis]], in double brackets"},
        {"[[design.axes]]\nkey = \"ice.thickness_m\"\n", "did you mean [[design.axis]]?"},
        {"[[case]]\nname = \"A\"\ndesign.point = 0\n", "the case A is a point of a design, and there is no [design]"},
        {sobol + sobol_axes + "[[case]]\nname = \"A\"\ndesign.point = 4\n", "beyond the design's last"},
        {sobol + sobol_axes + "[[case]]\nname = \"A\"\ndesign.point = 3\n[[case]]\nname = \"B\"\n",
         "the case B has no design.point, and others have"},
        {sobol + sobol_axes + "[[case]]\nname = \"A\"\ndesign.point = 3\n[[case]]\nname = \"B\"\ndesign.point = 3\n",
         "the case B has the design.point of an earlier case"},
        {sobol + sobol_axes + "[[case]]\nname = \"A\"\ndesign.point = 3\n",
         "a.toml: 3 of the 4 points of the design have no case"},
    };
    for (const auto& [text, sentence] : wrong) EXPECT_THAT(message(text), HasSubstr(sentence)) << text;
    EXPECT_THAT(message(sobol + sobol_axes, {"ice.thickness_m=0.03"}),
                HasSubstr("is hidden by the axis of the design"));
    EXPECT_THAT(message(sobol + sobol_axes, {"case.p001.general.iterations=3"}), HasSubstr("names no case"));
}

TEST(Design, HasTooManyCasesForMessages) {
    const std::string text = design("method = \"sobol\"\npoints = 32\n") + sobol_axes;
    const Campaign many = read(text, {"floe.element_m=0.6", "ice.elastic_modulus_MPa=60"});
    const Campaign more = read(text, {"floe.element_m=0.6", "ice.elastic_modulus_MPa=60", "design.points=64"});
    EXPECT_THAT(differences(many, more),
                ElementsAre("cases: p000, p001, p002 … (32 in all) there, p000, p001, p002 … (64 in all) here"));
    ASSERT_EQ(advice(many).size(), 1u);
    EXPECT_THAT(advice(many).front(), HasSubstr("he same holds for all 31 others."));
}

TEST(CommonArrangements, AreOfCasesWithOneGeometry) {
    const std::string text = design("method = \"grid\"") + axis("field.concentration_percent", "values = [60, 70]") +
                             axis("general.iterations", "values = [20, 50]");
    EXPECT_THAT(sharing_groups(read(text)), ElementsAre(0, 0, 1, 1));
    const std::string ends =
        design("method = \"grid\"") + axis("field.far_end", "values = [\"ice_sheet\", \"open\", \"never\"]");
    EXPECT_THAT(sharing_groups(read(ends)), ElementsAre(0, 0, 1)) << "without an end other floes enter";
    const Campaign own = read(text, {"campaign.common_arrangements=false"});
    EXPECT_THAT(sharing_groups(own), ElementsAre(0, 1, 2, 3));
    std::set<std::uint64_t> seeds;
    for (int k = 0; k < 4; ++k) seeds.insert(arrangement_seed(own, k));
    EXPECT_EQ(seeds.size(), 4u);
    EXPECT_EQ(arrangement_seed(read(text), 3), read(text).seed);
    EXPECT_FALSE(read(write_campaign(own)).common_arrangements);
}

TEST(CommonArrangements, CountForMembers) {
    const Campaign common = read(two_cases);
    const Campaign own = read(two_cases, {"campaign.common_arrangements=false"});
    EXPECT_NE(fingerprint(common), fingerprint(own));
    EXPECT_NE(case_fingerprint(common, 0), case_fingerprint(own, 0));
    EXPECT_THAT(differences(common, own), ElementsAre("campaign.common_arrangements: true there, false here"));
}

TEST(Design, CanBeLeftOut) {
    const std::string text =
        "[design]\nmethod = \"sobol\"\npoints = 4\n" + axis("ice.thickness_m", "from = 0.02\nto = 0.05") + two_cases;
    EXPECT_EQ(read(text).cases.size(), 8u);
    const CampaignSource source{text, "a.toml", {"case.A.ice.thickness_m=0.06"}, true, true};
    const Campaign without = read_campaign(source, nullptr);
    EXPECT_THAT(names(without), ElementsAre("A", "B"));
    EXPECT_FALSE(without.design.active());
    EXPECT_EQ(without.cases[0].scenario.floe.thickness, 0.06);
    EXPECT_THAT(message(text, {"case.A.ice.thickness_m=0.06"}), HasSubstr("axis"));
}

}  // namespace design_test
}  // namespace floes
