// Pressure over the area of the parts of a hull.

#include "findings/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "campaign/read.hpp"
#include "findings/example.hpp"
#include "theory/level_ice.hpp"

namespace floes {
namespace pressure_area_test {

using testing::HasSubstr;

constexpr std::string_view barge =
    "[campaign]\narrangements = 4\n"
    "[ice]\nthickness_m = 1.0\ndensity_kg_m3 = 900.0\n[water]\ndensity_kg_m3 = 1000.0\n"
    "[floe]\nlength_m = 20.0\nbreadth_m = 20.0\nelement_m = 5.0\n"
    "[field]\nfloes = 96\nbegin_m = 160.0\nhalf_width_m = 70.0\n[structure]\nstart_m = 110.0\nspeed_m_s = 0.5\n"
    "[hull]\nshape = \"barge\"\nlength_m = 60.0\nbeam_m = 20.0\ndraught_m = 4.0\nfreeboard_m = 3.0\nstem_deg = 45.0\n"
    "[analysis]\naveraging_s = [1.0, 5.0]\n";

/// Four members, whose bow feels 28, 29, 31 and 32 kN times `forces` over 1 s, half of that over 5 s, and whose other
/// parts feel a tenth of it.
Evidence evidence(double length_scale = 1, double forces = 1) {
    Campaign campaign = read_campaign({std::string(barge), "a.toml", {}}, nullptr);
    Scenario& scenario = campaign.cases.front().scenario;
    scenario.floe.thickness *= length_scale;
    HullSizes sizes = scenario.structure.shape.sizes();
    for (double HullSizes::*size : {&HullSizes::length, &HullSizes::beam, &HullSizes::draught, &HullSizes::freeboard})
        scenario.structure.shape.set_size(size, length_scale * sizes.*size);
    CampaignTable table;
    CaseRow row;
    row.name = campaign.cases.front().name;
    row.shape = scenario.structure.shape;
    table.cases.push_back(row);
    int number = 0;
    for (const double force : {28e3 * forces, 29e3 * forces, 31e3 * forces, 32e3 * forces}) {
        MemberRow member = example::done(0, number++, 20, 0.1, 1);
        if (forces > 0) {
            member.parts.resize(5);
            for (PartLoad& part : member.parts) part.normal_maximum = {0.1 * force, 0.05 * force};
            member.parts.front().normal_maximum = {force, 0.5 * force};
        }
        table.members.push_back(member);
    }
    return evidence_of(std::move(campaign), std::move(table));
}

// Ice of 1 m lies against 20 m of a bow at 45°: 20 √2 m²; sides are longer below the water than above by 2 y.
TEST(PressureArea, IsTheNormalForceOverWhatTheIceLiesAgainst) {
    const Results rows = find_pressures(evidence());
    ASSERT_EQ(rows.rows.size(), 10u);
    const double bow = 20 * std::sqrt(2.0);
    EXPECT_EQ(rows.name(0, "part"), "bow");
    EXPECT_NEAR(rows.number(0, "reached"), bow, 1e-6);
    EXPECT_NEAR(rows.number(0, "surface"), 7 * bow, 1e-6);
    EXPECT_EQ(rows.number(0, "averaging"), 1);
    EXPECT_EQ(rows.number(1, "averaging"), 5);
    EXPECT_NEAR(rows.number(0, "pressure"), 30e3 / bow, 1e-3);
    EXPECT_NEAR(rows.number(1, "pressure"), 15e3 / bow, 1e-3);
    EXPECT_NEAR(rows.number(4, "reached"), 60 - 0.9 * 0.9 + 0.1 * 0.1, 1e-6);
    // t(0.975, 3) = 3.182 times SD / √4 of 28, 29, 31 and 32 kN
    const auto& pressure = std::get<Estimate>(rows.at(0, "pressure").get());
    EXPECT_NEAR(pressure.high - pressure.value, 3.18245 * std::sqrt(10e6 / 3) / 2 / bow, 0.1);
    EXPECT_EQ(rows.number(0, "iso_19906"), 1.48e6);  // Pa, above 10 m²
    EXPECT_EQ(rows.name(8, "part"), "bottom and deck");
    EXPECT_TRUE(std::isnan(rows.number(8, "pressure"))) << "no ice that floats lies against it";
    EXPECT_TRUE(std::isnan(rows.number(8, "iso_19906")));
}

// By Froude: the same barge and ice at 1 : 20 with 1/20³ of the forces has 1/20 of the pressures, and no line.
TEST(PressureArea, OfATankIsComparedAtFullScaleOnly) {
    Evidence made = evidence(1 / 20.0, 1 / 8000.0);
    const Results tank = find_pressures(made);
    EXPECT_TRUE(std::isnan(tank.number(0, "iso_19906")));
    EXPECT_NEAR(tank.number(0, "pressure"), 30e3 / (20 * std::sqrt(2.0)) / 20, 1e-3);
    EXPECT_THAT(text(std::vector{pressure_section(made)}, 100), HasSubstr("--scale L"));
    EXPECT_EQ(shown_table(pressure_section(made).results.front(), {}).front().size(), 5u);
    made.scale = 20;
    const Results full = find_pressures(made);
    const Results direct = find_pressures(evidence());
    EXPECT_EQ(full.number(0, "iso_19906"), 1.48e6);
    EXPECT_NEAR(full.number(0, "reached"), direct.number(0, "reached"), 1e-5);
    EXPECT_NEAR(full.number(0, "pressure"), direct.number(0, "pressure"), 1e-3);
    EXPECT_NEAR(full.number(1, "averaging"), std::sqrt(20.0) * 5, 1e-12);
    EXPECT_EQ(shown_table(pressure_section(made).results.front(), {}).front().size(), 6u);
}

TEST(PressureArea, IsATableAndAFigure) {
    const Section section = pressure_section(evidence());
    EXPECT_EQ(shown_table(section.results.front(), {}).size(), 11u);  // a heading, and five parts over two times
    const std::string shown = text(std::vector{section}, 160);
    EXPECT_THAT(shown, testing::ContainsRegex("bow +198 +28.3 +1 +1061 \\[958, 1163\\] +1480000"));
    EXPECT_THAT(shown, testing::ContainsRegex("bottom and deck +2360 +0 +1 +– +–"));
    EXPECT_THAT(csv(std::vector{section}), HasSubstr("bottom and deck,2360,0,1,,,,,4"));
    ASSERT_EQ(section.figures.size(), 1u);
    const Figure& figure = section.figures.front();
    EXPECT_TRUE(figure.x.logarithmic && figure.y.logarithmic);
    const auto dots = std::ranges::count_if(
        figure.marks, [](const Figure::Mark& mark) { return std::holds_alternative<Figure::Dot>(mark); });
    EXPECT_EQ(dots, 8);  // four parts, two times
    EXPECT_LE(figure.y.low, 1.4e3 / std::sqrt(2.0) / 20);
    EXPECT_GE(figure.y.high, 1.48e6);
}

TEST(PressureArea, OfMembersWithoutNormalForcesIsMissing) {
    const Evidence made = evidence(1, 0);
    EXPECT_TRUE(find_pressures(made).empty());
    EXPECT_THAT(pressure_section(made).missing, HasSubstr("without normal forces"));
}

}  // namespace pressure_area_test
}  // namespace floes
