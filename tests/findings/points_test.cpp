// The points of a design: what people call them, their loads, and pictures of them.

#include "findings/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "campaign/read.hpp"
#include "findings/answer.hpp"
#include "findings/catalogue.hpp"
#include "findings/conditions.hpp"
#include "findings/design_load.hpp"
#include "findings/example.hpp"
#include "findings/overview.hpp"
#include "findings/page_one.hpp"
#include "scenario/scenario.hpp"

namespace floes {
namespace points_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const char* const grid = R"([campaign]
arrangements = 3
[design]
method = "grid"
[[design.axis]]
key = "ice.thickness_m"
values = [0.02, 0.03, 0.04]
[[design.axis]]
key = "structure.speed_m_s"
values = [0.02, 0.07]
)";

/// Loads of 10 N, 4 N more for each 0.01 m and 2 N more at the higher speed; and 1 N to and fro.
Evidence evidence_with(const std::string& text) {
    const Campaign campaign = read_campaign({text, "a.toml", {}}, nullptr);
    CampaignTable table;
    table.title = "a";
    for (const Case& one : campaign.cases) {
        CaseRow row;
        row.name = one.name;
        row.shape = one.scenario.structure.shape;
        table.cases.push_back(row);
    }
    for (int arrangement = 0; arrangement < campaign.arrangements; ++arrangement)
        for (std::size_t k = 0; k < campaign.cases.size(); ++k) {
            const Scenario& scenario = campaign.cases[k].scenario;
            const double load = 10 + 400 * (scenario.floe.thickness - 0.02) + 40 * (scenario.structure.speed - 0.02);
            table.members.push_back(example::done(static_cast<int>(k), arrangement, load + arrangement - 1, 0.1, 1));
        }
    return evidence_of(campaign, table);
}

TEST(KeyWords, SayUnits) {
    EXPECT_EQ(key_words("ice.thickness_m").heading(), "thickness, m");
    EXPECT_EQ(key_words("structure.speed_m_s").with("0.1"), "speed 0.1 m/s");
    EXPECT_EQ(key_words("ice.bending_strength_kPa").heading(), "bending strength, kPa");
    EXPECT_EQ(key_words("field.concentration_percent").unit, "%");
    EXPECT_EQ(key_words("moorings.surge_kN_m").heading(), "surge, kN/m");
    EXPECT_EQ(key_words("moorings.turret_friction_kN_m").heading(), "turret friction, kN m");
    EXPECT_EQ(key_words("moorings.yaw_kN_m_rad").unit, "kN m/rad");
    EXPECT_EQ(key_words("moorings.quadratic_pitch_kN_m_s2").unit, "kN m s²");
    EXPECT_EQ(key_words("field.confining_N_m").heading(), "confining, N/m");
    EXPECT_EQ(key_words("general.tolerance_mm_s").heading(), "tolerance, mm/s");
    EXPECT_EQ(key_words("contact.ice_ice_friction").heading(), "ice-ice friction");
    EXPECT_EQ(key_words("cfm").heading(), "Σ");
}

TEST(Points, AreCalledByTheirKeys) {
    Evidence evidence = evidence_with(grid);
    EXPECT_EQ(evidence.summary.label_of(0), "thickness 0.02 m, speed 0.02 m/s");
    EXPECT_EQ(evidence.summary.name_of(0), "0.02_0.02");
    const Evidence based = evidence_with(std::string(grid) + "[[case]]\nname = \"A\"\n");
    EXPECT_EQ(based.summary.label_of(5), "A: thickness 0.04 m, speed 0.07 m/s");
}

TEST(Points, HaveTheirLoadsBesideTheirPlaces) {
    Evidence evidence = evidence_with(grid);
    const Section told = points_section(evidence);
    const Table table = shown_table(told.results.at(1), evidence.units);
    ASSERT_EQ(table.size(), 7u);
    EXPECT_EQ(table[0][1].value, "thickness, m");
    EXPECT_EQ(table[6][0].value, "0.04_0.07");
    EXPECT_EQ(table[6][4].value, "20.00");
    EXPECT_EQ(table[6][4].range, "[17.52, 22.48]");  // 19, 20, 21 N: t(2) / √3
}

TEST(Points, AreDrawnOverEachAxisAndOverTwo) {
    Evidence evidence = evidence_with(grid);
    const std::vector<Figure> figures = point_figures(evidence);
    ASSERT_EQ(figures.size(), 3u);
    EXPECT_EQ(figures[0].x.label, "thickness, m");
    EXPECT_THAT(figures[0].legend, ElementsAre(std::pair("c0", "speed 0.02 m/s"), std::pair("c1", "speed 0.07 m/s")));
    EXPECT_EQ(figures[1].legend.size(), 3u);
    // The thickness moves the load most. Six fields, each with its load.
    const Figure& map = figures[2];
    EXPECT_EQ(map.x.label, "thickness, m");
    EXPECT_EQ(std::ranges::count_if(map.marks,
                                    [](const Figure::Mark& one) { return std::holds_alternative<Figure::Cell>(one); }),
              6);
    EXPECT_EQ(std::get<Figure::Words>(map.marks.back()).words, "20");
    EXPECT_THAT(map.heat_scale, HasSubstr("20 N"));
}

TEST(Points, OfAnAxisOfWordsHaveARowForEach) {
    Evidence evidence = evidence_with(
        "[campaign]\narrangements = 3\n[design]\nmethod = \"grid\"\n[[design.axis]]\nkey = \"field.far_end\"\n"
        "values = [\"open\", \"ice_sheet\"]\n");
    const std::vector<Figure> figures = point_figures(evidence);
    ASSERT_EQ(figures.size(), 1u);
    EXPECT_THAT(figures[0].y.names, ElementsAre("ice_sheet", "open"));
}

TEST(Points, WithoutAResultAreNotDrawn) {
    Evidence evidence = evidence_with(grid);
    for (MemberRow& row : evidence.table.members)
        row = example::without_result(row.case_index, row.arrangement, RowStatus::missing);
    EXPECT_THAT(point_figures(evidence_of(evidence.campaign, evidence.table)), IsEmpty());
}

// The headline, the table and the page give one number for one range.
TEST(Points, ChangeByTheSameFromOneEndToTheOther) {
    Evidence evidence = evidence_with(grid);
    const std::string overview = text(std::vector{overview_section(evidence)}, 100);
    const char* const change = "Thickness from 0.02 to 0.04 m changes the mean load by +8 N";
    EXPECT_THAT(overview, HasSubstr(change));
    EXPECT_THAT(overview, Not(HasSubstr("mean - ")));
    EXPECT_THAT(find_answer(evidence).changes.at(0), HasSubstr(change));
    EXPECT_THAT(find_page_one(evidence).sentence,
                HasSubstr("Thickness 0.04 m, speed 0.07 m/s: mean load 20 N (17.5 to 22.5)"));
    EXPECT_THAT(find_answer(evidence).basis.at(0),
                HasSubstr("Varies over the 6 points of the design: thickness 0.02 to 0.04 m, speed 0.02 to 0.07 m/s."));
}

TEST(Answer, SaysWhatVariesBetweenCases) {
    Evidence evidence = evidence_with(
        "[campaign]\narrangements = 3\n[[case]]\nname = \"thin\"\nice.thickness_m = 0.02\n[[case]]\nname = \"thick\"\n"
        "ice.thickness_m = 0.04\nstructure.profile_m = [[-0.4, 0.6], [0.1, 0.6]]\n");
    EXPECT_THAT(find_answer(evidence).basis.at(0), HasSubstr("Varies: thickness 0.02 m (thin), 0.04 m (thick)."));
    EXPECT_NEAR(find_page_one(evidence).table.results.at(0).number(1, "mean_load_difference"), 8, 1e-9);
}

// Cases whose floes differ share no arrangement: their means are compared, and that is said. A key of a law that a case
// does not use is no difference of that case.
TEST(Answer, ComparesTheMeansOfCasesWithOtherFloes) {
    Evidence evidence = evidence_with(
        "[campaign]\narrangements = 4\n[[case]]\nname = \"alike\"\n[[case]]\nname = \"mixed\"\n"
        "ice.thickness_m = 0.04\nsizes.law = \"lognormal\"\nsizes.largest_m = 1.0\n");
    for (MemberRow& row : evidence.table.members) row.arrangement += 4 * row.case_index;
    evidence = evidence_of(evidence.campaign, evidence.table);
    const CampaignAnswer answer = find_answer(evidence);
    const Section page = find_page_one(evidence).table;
    const Estimate difference = std::get<Estimate>(page.results.at(0).at(1, "mean_load_difference").get());
    EXPECT_NEAR(difference.value, 400 * (0.04 - 0.033), 1e-9);
    // Of four values 1 N apart each, s = 1.291; Welch's t of 6 degrees of freedom.
    EXPECT_NEAR(difference.high - difference.value, 2.4469 * 1.2910 * std::sqrt(2.0 / 4), 1e-3);
    EXPECT_THAT(page.after, HasSubstr("begin from other floes"));
    const std::string overview = text(std::vector{overview_section(evidence)}, 200);
    EXPECT_THAT(overview, HasSubstr("differences are of means (Welch)"));
    EXPECT_THAT(answer.basis, testing::Contains(HasSubstr("Varies: sizes law one (alike), lognormal (mixed).")));
    EXPECT_THAT(answer.basis, Not(testing::Contains(HasSubstr("largest"))));
}

// Two cases share their arrangements, a third has other floes: it alone is compared without pairs, and is named.
TEST(Answer, NamesTheCasesThatHaveOtherFloes) {
    Evidence evidence = evidence_with(
        "[campaign]\narrangements = 4\n[[case]]\nname = \"alike\"\n[[case]]\nname = \"slow\"\nstructure.speed_m_s = "
        "0.02\n[[case]]\nname = \"mixed\"\nsizes.law = \"lognormal\"\nsizes.largest_m = 1.0\n");
    for (MemberRow& row : evidence.table.members) row.arrangement += row.case_index == 2 ? 4 : 0;
    evidence = evidence_of(evidence.campaign, evidence.table);
    const std::string overview = text(std::vector{overview_section(evidence)}, 200);
    EXPECT_THAT(overview, testing::ContainsRegex("mixed begins\\sfrom other floes: differences are of means .Welch."));
    EXPECT_THAT(find_page_one(evidence).table.after,
                HasSubstr("by pairs over the same arrangements; of cases that begin from other floes, of their means"));
}

// A doubt that matters stands beside the figure: the methods lie between 40 and 75 N, 70 % of 50 N apart, and 3 h are
// 108 times the 100 s that were run.
TEST(Answer, SaysDoubtsBesideTheFigure) {
    Evidence evidence = evidence_with("[campaign]\narrangements = 3\n");
    DesignLoad load;
    load.arrangements = 3;
    load.time_run = 100;
    for (const double value : {50.0, 40.0, 75.0}) {
        const LoadFigure figure{value, {value - 5, value + 5}};
        load.estimates.push_back({LargestBy::both_tails, figure, {figure}});
    }
    DesignLoads designs;
    CaseDesignLoad& of_case = designs.of_cases.emplace_back();
    of_case.load = load;
    evidence.kept.set(designs);
    const PageOne page = find_page_one(evidence);
    EXPECT_THAT(page.sentence, HasSubstr("in 3 h a load of 50 N (45 to 55) is exceeded with 10 %"));
    EXPECT_THAT(page.table.notes.at(0),
                HasSubstr("methods differ by 70 %, extrapolated to 1.1e+02 times the time run."));
    of_case.load.arrangements = 2;
    evidence.kept.set(designs);
    EXPECT_THAT(find_page_one(evidence).sentence, HasSubstr("a load of 50 N is exceeded"));
}

TEST(WhatWasRun, DrawsEveryHullAndNotEveryCase) {
    const std::string cases =
        "[[case]]\nname = \"a\"\n[[case]]\nname = \"b\"\nstructure.profile_m = [[-0.4, 0.6], [0.1, 0.6]]\n"
        "[[case]]\nname = \"c\"\nice.thickness_m = 0.02\n";
    Evidence evidence = evidence_with("[campaign]\narrangements = 3\n" + cases);
    const Section told = what_was_run(evidence);
    ASSERT_EQ(told.figures.size(), 3u);
    EXPECT_EQ(told.figures[0].x.label, "a, c: m");
    EXPECT_EQ(told.figures[1].x.label, "b: m");
    EXPECT_EQ(told.figures[2].x.label, "along the floe, m");  // all floes are of one size
    EXPECT_THAT(told.figures[1].caption, HasSubstr("the ice is 0.02 to 0.033 m thick"));
}

TEST(WhatWasRun, DrawsFloesThatDifferAsTheyAre) {
    Evidence sizes = evidence_with(
        "[campaign]\narrangements = 3\n[sizes]\nlaw = \"list\"\nlist_m = [[0.4, 0.4, 50.0], [1.2, 0.6, 50.0]]\n");
    const auto elements = [](const Figure& figure) {
        return std::ranges::count_if(
            figure.marks, [](const Figure::Mark& mark) { return std::holds_alternative<Figure::Area>(mark); });
    };
    const Section told = what_was_run(sizes);
    EXPECT_EQ(elements(told.figures.back()), 4 + 18);  // of 0.4 m and of 1.2 m x 0.6 m, once each
    EXPECT_THAT(told.figures.back().caption, HasSubstr("the smallest, the middle one by area and the largest"));

    Evidence cells = evidence_with(
        "[campaign]\narrangements = 3\n[shapes]\nkind = \"voronoi\"\n[contact]\npreset = "
        "\"physical\"\n[general]\nsolver = \"direct\"\n[joint]\nmodel = \"beam\"\nfailure = \"moment\"\n");
    const Section drawn = what_was_run(cells);
    EXPECT_GT(elements(drawn.figures.back()), 12);  // of three floes
}

TEST(Conditions, OfManyDifferentCasesAreRangesOrCountedNotListed) {
    std::string cases = "[campaign]\narrangements = 3\n";
    for (int k = 0; k < 5; ++k)
        cases += "[[case]]\nname = \"" + std::string(1, static_cast<char>('a' + k)) +
                 "\"\nice.compressive_strength_kPa = " + std::to_string(100 + k) + ".0\n";
    Evidence evidence = evidence_with(cases);
    Summary summary = evidence.summary;
    for (std::size_t k = 0; k < summary.cases.size(); ++k)
        summary.cases[k].about.contact =
            with_preset({.crushing_pressure = 1e5 + 1e3 * static_cast<double>(k)}, ContactPreset::physical);
    EXPECT_THAT(condition_lines(summary),
                testing::Contains(testing::MatchesRegex("Contacts: preset physical, .*at 100 to 104 kPa, by case\\.")));
    summary.cases[4].about.contact.friction = Friction::one_direction;
    EXPECT_THAT(condition_lines(summary),
                testing::Contains(testing::StartsWith("Contacts: 5 different ones, as preset physical")));
}

TEST(Convergence, OfTwoArrangementsIsNoFigure) {
    Evidence evidence = evidence_with("[campaign]\narrangements = 2\n");
    EXPECT_TRUE(convergence_section(evidence).figures.empty());
}

TEST(Convergence, FigureFollowsTheMeansNotTheWidestInterval) {
    Evidence evidence = evidence_with("[campaign]\narrangements = 6\n");
    for (MemberRow& row : evidence.table.members) row.load.mean = row.arrangement == 0 ? 100 : row.arrangement;
    evidence = evidence_of(evidence.campaign, evidence.table);
    const Section told = convergence_section(evidence);
    EXPECT_LT(told.figures[0].y.high, 120);  // of the first three the interval reaches to 178 N
    for (const Figure::Mark& mark : told.figures[0].marks)
        if (const auto* area = std::get_if<Figure::Area>(&mark)) {
            for (const auto& [n, load] : area->outline) EXPECT_LE(load, told.figures[0].y.high);
        }
}

}  // namespace points_test
}  // namespace floes
