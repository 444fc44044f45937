// Configurations that leave their field open: hulls, floes, moorings, paths and far ends of many kinds together, none
// of which is refused, and what is printed of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <fmt/format.h>

#include "campaign/case_words.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "scenario/layout.hpp"

namespace floes {
namespace laid_test {

using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Campaign read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return read_campaign({text, "mine.toml", overrides, true}, nullptr);
}

/// At full scale: steps and ice.
const std::string sea =
    "general.time_step_s = 0.1\nice.thickness_m = 1.0\nice.density_kg_m3 = 910.0\nwater.density_kg_m3 = 1025.0\n"
    "ice.elastic_modulus_MPa = 5000.0\nice.bending_strength_kPa = 500.0\nice.compressive_strength_kPa = 2000.0\n"
    "general.runaway_speed_m_s = 50.0\nfloe.element_m = 5.0\n";

const std::string turret_ship =
    "hull.shape = 'drillship'\nhull.length_m = 150\nhull.beam_m = 28\nhull.draught_m = 9\nhull.freeboard_m = 8\n"
    "hull.entrance_deg = 35\nhull.stem_deg = 45\n";

const std::vector<std::string> hulls{
    "structure.profile_m = [[-11.5, 25.2], [-7.0, 23.35], [0.0, 35.0], [3.3, 40.5]]\n",
    turret_ship,
    "hull.shape = 'cylinder'\nhull.diameter_m = 18\nhull.draught_m = 9\nhull.freeboard_m = 8\n",
    "hull.shape = 'four_legs'\nhull.diameter_m = 8\nhull.spacing_m = 45\nhull.draught_m = 15\nhull.freeboard_m = 8\n",
    "hull.shape = 'barge'\nhull.length_m = 90\nhull.beam_m = 30\nhull.draught_m = 4\nhull.freeboard_m = 3\n"
    "hull.stem_deg = 45\n",
    "hull.shape = 'wedge_bow'\nhull.length_m = 60\nhull.beam_m = 40\nhull.draught_m = 6\nhull.freeboard_m = 4\n"
    "hull.entrance_deg = 45\nhull.stem_deg = 60\n"};

const std::vector<std::string> floes{
    "floe.length_m = 20\nfloe.breadth_m = 20\n", "floe.length_m = 40\nfloe.breadth_m = 20\n",
    "sizes.law = 'list'\nsizes.list_m = [[20, 20, 60], [40, 40, 40]]\n",
    "sizes.law = 'lognormal'\nsizes.mean_m = 25\nsizes.cov = 0.3\nsizes.smallest_m = 15\nsizes.largest_m = 40\n"
    "shapes.kind = 'polygon'\n",
    "floe.length_m = 30\nfloe.breadth_m = 30\nshapes.kind = 'voronoi'\n"};

const std::vector<std::string> fields{"field.far_end = 'never'\n", "field.far_end = 'ice_sheet'\n",
                                      "field.far_end = 'open'\nwater.current_m_s = 0.02\n",
                                      "field.far_end = 'ice_sheet'\nfield.floes = 900\n"};

const std::vector<std::string> moorings{
    "structure.speed_m_s = 0.5\n", "structure.speed_m_s = 0.05\nanalysis.history_steps = 4\n",
    "structure.speed_m_s = 1.0\nmoorings.mass_t = 90000\nmoorings.gyration_m = 30\nmoorings.surge_kN_m = 2600\n"
    "moorings.sway_kN_m = 50\nmoorings.yaw_kN_m_rad = 3e6\nmoorings.damping_percent = 5\n",
    "structure.speed_m_s = 0.4\nmoorings.mass_t = 91000\nmoorings.gyration_m = 37\nmoorings.turret = true\n"
    "moorings.turret_m = 5\nmoorings.hanging_lines = ["
    "[5, -9, 0, 0, 900, 100, 925, 2000, 1e6, 0.5, 0], [-2.5, -9, 4.33, 120, 900, 100, 925, 2000, 1e6, 0.5, 0], "
    "[-2.5, -9, -4.33, 240, 900, 100, 925, 2000, 1e6, 0.5, 0]]\n"};

const std::vector<std::string> ways{
    "", "path.of = 'ice'\npath.legs = [[180, 0.4, 600, 0], [180, 0.4, 200, 0.1], [200, 0.4, 700, 0]]\n",
    "path.legs = [[0, 0.5, 900, 0], [0, 0, 60, 0], [90, 0.5, 120, 0]]\n"};

const std::vector<std::string> analyses{"",
                                        "analysis.window_s = 1000\n",
                                        "analysis.steady_start_s = 250\n",
                                        "analysis.averaging_s = [1.0, 60.0]\n",
                                        "field.concentration_percent = 80\n",
                                        "field.begin_m = 40\n",
                                        "analysis.segments = 7\n"};

/// One of each list, by a number that mixes them.
std::vector<std::string> chosen(std::size_t number) {
    std::vector<std::string> parts;
    for (const auto& list : {hulls, floes, fields, moorings, ways, analyses}) {
        parts.push_back(list[number % list.size()]);
        number = number / list.size() + 7 * (number % list.size());
    }
    return parts;
}

TEST(Laid, NoneOfManyConfigurationsIsRefused) {
    std::size_t laid = 0;
    for (std::size_t number = 0; number < 20160; number += 53) {
        std::string text = sea;
        for (const std::string& part : chosen(number)) text += part;
        SCOPED_TRACE(text);
        ASSERT_NO_THROW({
            const Campaign campaign = read(text);
            const Scenario& scenario = campaign.cases.front().scenario;
            laid += campaign.cases.front().laid.empty() ? 0 : 1;
            EXPECT_GT(scenario.analysis.window, 0);
        });
    }
    EXPECT_EQ(laid, 381u);
}

TEST(Laid, NothingIsOddAboutWhatIsLaid) {
    for (const std::string& hull : hulls) {
        for (const std::string& mooring : moorings) {
            const Campaign campaign = read(sea + hull + floes[1] + fields[0] + mooring);
            for (const std::string& sentence : advice(campaign))
                EXPECT_THAT(sentence, Not(AnyOf(HasSubstr("begins to measure before"), HasSubstr("and the bank"),
                                                HasSubstr("shorter than three natural periods"))));
        }
    }
}

TEST(Laid, WhatIsPrintedReadsAsItIs) {
    for (std::size_t number = 0; number < 20160; number += 977) {
        std::string text = sea;
        for (const std::string& part : chosen(number)) text += part;
        const Campaign campaign = read(text);
        const std::string resolved = resolved_text(campaign);
        const Campaign again = read(resolved);
        EXPECT_THAT(again.cases.front().laid, IsEmpty());
        EXPECT_EQ(fingerprint(again), fingerprint(campaign));
        EXPECT_EQ(write_campaign(again), write_campaign(campaign));
    }
}

/// All of `text` from the line with this key on, to its end.
std::string line_of(const std::string& text, const std::string& key) {
    const std::size_t begin = text.find("\n" + key + " = ");
    return begin == std::string::npos ? "" : text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
}

const std::string open_turret =
    sea + turret_ship + floes[2] + fields[0] + moorings[3] + "field.concentration_percent = 80\n";

TEST(Laid, ResolvedTextSaysWhy) {
    const std::string text = resolved_text(read(open_turret));
    EXPECT_EQ(line_of(text, "sheet_width_m"),
              "sheet_width_m = 57.0  # derived: the diagonal of the largest floe, 56.57 m");
    EXPECT_EQ(line_of(text, "start_m"),
              "start_m = -110.0  # derived: the bow, 83 m ahead of the axis, is half a floe of 40 m before the ice");
    EXPECT_EQ(line_of(text, "time_step_s"), "time_step_s = 0.1");
    EXPECT_EQ(line_of(write_campaign(read(open_turret)), "sheet_width_m"), "sheet_width_m = 57.0");
}

TEST(Laid, ReasonsOfACaseStandInIt) {
    const std::string text =
        resolved_text(read(open_turret + "[[case]]\nname = 'slow'\nstructure.speed_m_s = 0.2\n[[case]]\nname = 'fast'\n"
                                         "analysis.window_s = 600\n"));
    const std::size_t slow = text.find("name = \"slow\"");
    const std::size_t fast = text.find("name = \"fast\"");
    ASSERT_LT(slow, fast);
    EXPECT_THAT(line_of(text.substr(slow, fast - slow), "analysis.window_s"), HasSubstr("  # derived: "));
    EXPECT_EQ(line_of(text.substr(fast), "analysis.window_s"), "analysis.window_s = 600.0");
}

TEST(Laid, OverridesAreStated) {
    const Campaign campaign = read(open_turret, {"field.half_width_m=200"});
    EXPECT_EQ(campaign.cases.front().scenario.field.half_width, 200);
    EXPECT_THAT(line_of(resolved_text(campaign), "half_width_m"), "half_width_m = 200.0");
}

TEST(Laid, OwnArrangementsHaveFieldsOfTheirOwn) {
    const std::string cases = "[[case]]\nname = 'one'\n[[case]]\nname = 'other'\nhull.beam_m = 100\n";
    const auto half_widths = [&](const std::string& common) {
        const Campaign campaign = read(open_turret + "campaign.common_arrangements = " + common + "\n" + cases);
        return std::pair(campaign.cases[0].scenario.field.half_width, campaign.cases[1].scenario.field.half_width);
    };
    const auto [one, other] = half_widths("true");
    EXPECT_EQ(one, other);
    const auto [first, second] = half_widths("false");
    EXPECT_LT(first, second);
}

TEST(Laid, AStudyOfALaidCaseStatesItsField) {
    const Campaign campaign = read(open_turret);
    const Campaign varied = read(variations_text(campaign, campaign.cases.front()));
    EXPECT_EQ(case_fingerprint(varied, 0), case_fingerprint(campaign, 0));
}

TEST(Hull, ThatNobodyStatesIsTold) {
    EXPECT_EQ(hull_remark(read("ice.elastic_modulus_MPa = 60\n")),
              "No hull is stated: the paper's inverted cone, 1.228 m wide at the waterline, is towed; hull.shape or "
              "structure.profile_m names another.");
    const std::string of_paper =
        "general.solver = 'lanes'\njoint.model = 'cfm'\njoint.cfm = 0.03\nwater.heave_damping_from = 'share'\n"
        "water.added_mass_from = 'share'\n";
    for (const std::string& text :
         {of_paper, of_paper + "contact.preset = 'paper'\n",
          std::string("structure.profile_m = [[-0.443, 0.445], [0.0, 0.614], [0.122, 0.736]]\n")})
        EXPECT_EQ(hull_remark(read(text)), "") << text;
    EXPECT_EQ(hull_remark(read(open_turret)), "");
}

}  // namespace laid_test
}  // namespace floes
