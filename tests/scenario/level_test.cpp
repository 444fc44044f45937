// Level ice: one sheet in place of floes, what it cannot be combined with, and ice that varies within it.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "scenario/floes.hpp"
#include "scenario/validate.hpp"
#include "scenario/varied_ice.hpp"

namespace floes {
namespace level_test {

Scenario level() {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::level;
    scenario.field.floes = 1;
    scenario.field.concentration = 1;
    scenario.field.half_width = 2.0;
    scenario.field.begin = 3;
    scenario.floe.length = 6;
    scenario.floe.breadth = 3.8;
    scenario.structure.start = 2.2;
    scenario.analysis.steady_start = 10;
    scenario.analysis.window = 18;
    return scenario;
}

std::string fault_of(const std::function<void(Scenario&)>& change) {
    Scenario scenario = level();
    change(scenario);
    std::string all;
    for (const Contradiction& one : find_contradictions(scenario)) all += one.sentence + "\n";
    return all;
}

TEST(LevelIce, IsOneSheetFromTheNearEdgeToTheFarEnd) {
    const Scenario scenario = level();
    EXPECT_EQ(fault_of([](Scenario&) {}), "");
    EXPECT_EQ(scenario.field_length(), 6);
    EXPECT_EQ(scenario.field_end(), 9);
    const FloeSet sheet = floes_of(scenario, {1, 4});
    ASSERT_EQ(sheet.size(), 1u);
    EXPECT_EQ(sheet.floes[0].pose.x, 6);
    EXPECT_EQ(sheet.floes[0].pose.z, 0);
    EXPECT_NE(sheet.shape(0).pattern, floes_of(scenario, {1, 5}).shape(0).pattern)
        << "each arrangement has its own cut";
}

// Strength and modulus follow from the brine wherever the ice's own are asked for.
TEST(LevelIce, OfBrineHasItsLengths) {
    Scenario salty = level();
    salty.brine = {.salinity = 5e-3, .temperature = -5};
    Scenario stated = level();
    stated.ice = floes_of(salty).material(0).ice;
    EXPECT_EQ(salty.characteristic_length(), stated.characteristic_length());
    EXPECT_EQ(salty.stress_steps(), stated.stress_steps());
    EXPECT_GT(salty.characteristic_length(), 2 * level().characteristic_length());
}

TEST(LevelIce, WithoutEndIsAsLongAsWhatIsComputed) {
    Scenario scenario = level();
    scenario.field.far_end = FarEnd::never;
    scenario.floe.length = 0.001;  // nobody asks for it
    EXPECT_TRUE(find_contradictions(scenario).empty());
    const double length = scenario.characteristic_length();
    const double radius = scenario.structure.shape.largest_radius();
    EXPECT_NEAR(length, 0.376, 0.001);
    EXPECT_DOUBLE_EQ(scenario.window_ahead(), radius + 8 * length);
    EXPECT_DOUBLE_EQ(scenario.window_behind(), radius + 4 * length);
    EXPECT_DOUBLE_EQ(floes_of(scenario).shape(0).length, scenario.window_ahead() + scenario.window_behind());
}

TEST(LevelIce, RefusesWhatItCannotBe) {
    const auto says = [](const std::function<void(Scenario&)>& change, const std::string& words) {
        EXPECT_NE(fault_of(change).find(words), std::string::npos) << fault_of(change);
    };
    says([](Scenario& s) { s.field.floes = 2; }, "level ice is one sheet");
    const auto endless = [&](const std::function<void(Scenario&)>& change, const std::string& words) {
        says([&](Scenario& s) { s.field.far_end = FarEnd::never, change(s); }, words);
    };
    endless([](Scenario& s) { s.field.level_held = LevelHeld::nowhere; }, "the sheet goes on ahead");
    endless([](Scenario& s) { s.field.level_held = LevelHeld::far_end_and_sides; }, "would never leave");
    endless([](Scenario& s) { s.elements.form = ElementForm::squares; }, "whose cells go on without a seam");
    endless([](Scenario& s) { s.field.ahead = 0.8; }, "two elements");
    says([](Scenario& s) { s.field.concentration = 0.75; }, "level ice has no leads");
    says([](Scenario& s) { s.shapes.kind = ShapeKind::polygon; }, "the sheet is a rectangle");
    says([](Scenario& s) { s.floe.breadth = 4.0; }, "at either side of the field");
    says([](Scenario& s) { s.field.level_held = LevelHeld::far_end_and_sides; }, "is not the width of the field");
    says([](Scenario& s) { s.field.far_end = FarEnd::open; }, "there is nothing to freeze to");
    says([](Scenario& s) { s.field.confining = 10; }, "give way hold nothing");
    says([](Scenario& s) { s.contact.internal_edges = true; }, "paper.internal_edges = true does not go together with");
    says([](Scenario& s) { s.general.solver = SolverKind::lanes; }, "solved exactly");
    says([](Scenario& s) { s.water.current = 0.1; }, "starts with the current");
    says(
        [](Scenario& s) {
            s.arrangement.method = ArrangementMethod::scattered;
            s.spread.length = 1;
        },
        "is of level ice");
    says([](Scenario& s) { s.spread.length = 1; }, "and none does");
    EXPECT_EQ(fault_of([](Scenario& s) {
                  s.field.level_held = LevelHeld::far_end_and_sides;
                  s.floe.breadth = 4.0;
              }),
              "");
}

Scenario varied() {
    Scenario scenario = level();
    scenario.spread.length = 0.5;
    for (Spread* one : {&scenario.spread.thickness, &scenario.spread.strength, &scenario.spread.elastic_modulus})
        *one = {LawKind::lognormal, 0.2, {0.1, 5}};
    return scenario;
}

Material material(const Scenario& scenario, std::uint32_t arrangement) {
    return floes_of(scenario, {1, arrangement}).material(0);
}

/// Over draws, of pairs of values.
struct Moments {
    double one = 0, square = 0, both = 0;

    void add(double here, double there) {
        one += here;
        square += here * here;
        both += here * there;
    }
};

// Lognormal factors of variance s² = ln(1 + cov²) whose normal fields correlate by ρ correlate by (e^(ρ s²) - 1)/cov².
TEST(VariedIce, HasTheMomentsOfItsLawAndItsCorrelation) {
    constexpr int draws = 2000;
    constexpr std::array<double, 3> lengths{0.5, 1.0, 2.0};
    const Scenario scenario = varied();
    std::array<Moments, 3> sums;
    for (std::uint32_t i = 0; i < draws; ++i) {
        const VariedIce ice(material(scenario, i).variation);
        const double here = ice.at({0.3, -0.2}).strength;
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            const double way = lengths.at(k) * scenario.spread.length;
            sums.at(k).add(here, ice.at({0.3 + 0.6 * way, -0.2 + 0.8 * way}).strength);
        }
    }
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        const double mean = sums.at(k).one / draws;
        const double variance = sums.at(k).square / draws - mean * mean;
        const double normal = std::exp(-0.5 * lengths.at(k) * lengths.at(k));
        EXPECT_NEAR(mean, 1, 4 * 0.2 / std::sqrt(draws)) << "four standard errors";
        EXPECT_NEAR(std::sqrt(variance), 0.2, 0.016);
        EXPECT_NEAR((sums.at(k).both / draws - mean * mean) / variance, (std::pow(1.04, normal) - 1) / 0.04, 0.08);
    }
}

TEST(VariedIce, IsAFunctionOfItsDrawAndThePlace) {
    const Scenario scenario = varied();
    const SingleFloe sheet{{}, scenario.floe, material(scenario, 3)};
    PlacedIce one(sheet);
    PlacedIce other(sheet);
    static_cast<void>(other.at({0.1, 0.1}));
    EXPECT_EQ(one.at({1, 0.5}).material, other.at({1, 0.5}).material);
    EXPECT_EQ(one.at({1, 0.5}).shape, other.at({1, 0.5}).shape);
    EXPECT_NE(one.at({1, 0.5}).shape.thickness, scenario.floe.thickness);
    PlacedIce drawn_else({{}, scenario.floe, material(scenario, 4)});
    EXPECT_NE(one.at({1, 0.5}).shape.thickness, drawn_else.at({1, 0.5}).shape.thickness);
    // Of a correlation of 1 strength follows thickness, whose law is the same.
    Scenario bound = scenario;
    bound.spread.correlation = 1;
    const VariedIce ice(material(bound, 3).variation);
    for (const double x : {-2.0, 0.0, 1.5}) EXPECT_EQ(ice.at({x, 0}).strength, ice.at({x, 0}).thickness);
    // The floe as a whole has neither.
    EXPECT_EQ(material(scenario, 3).ice, scenario.ice);
}

}  // namespace level_test
}  // namespace floes
