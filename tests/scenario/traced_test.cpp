// Floes with outlines of a file: which floe has which, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/elements.hpp"

namespace floes {
namespace traced_test {

using testing::HasSubstr;

Outline rectangle(double x, double z, double length, double breadth) {
    return {{x, z}, {x + length, z}, {x + length, z + breadth}, {x, z + breadth}};
}

/// Three rectangles, of 0.36, 0.64 and 1 m².
Scenario traced_scenario() {
    Scenario scenario;
    scenario.joint.failure = JointFailure::moment;
    scenario.shapes.kind = ShapeKind::file;
    scenario.shapes.traced.outlines = {rectangle(3, 1, 1, 1), rectangle(0, -2, 0.6, 0.6), rectangle(1, -1, 0.8, 0.8)};
    return scenario;
}

std::string refusal_of(const Scenario& scenario) {
    const std::vector<Contradiction> found = find_contradictions(scenario);
    return found.empty() ? "" : found.front().sentence;
}

std::vector<double> areas_of(const FloeSet& floes) {
    std::vector<double> areas;
    for (std::size_t i = 0; i < floes.size(); ++i) areas.push_back(floes.shape(i).area());
    return areas;
}

TEST(Traced, EveryArrangementHasTheSameFloesInAnotherOrder) {
    Scenario scenario = traced_scenario();
    EXPECT_EQ(refusal_of(scenario), "");
    scenario.field.floes = 32;  // 11 of the smallest and the largest, 10 of the other
    std::vector<double> one = areas_of(floes_of(scenario, {1, 0}));
    std::vector<double> other = areas_of(floes_of(scenario, {1, 1}));
    EXPECT_NE(one, other);
    std::ranges::sort(one);
    std::ranges::sort(other);
    EXPECT_EQ(one, other);
    for (const auto& [area, count] : {std::pair(0.36, 11), {0.64, 10}, {1.0, 11}})
        EXPECT_EQ(std::ranges::count_if(one, [&](double each) { return std::abs(each - area) < 1e-9; }), count);
    const double covered = 11 * 0.36 + 10 * 0.64 + 11;
    EXPECT_NEAR(scenario.field_length(), covered / (scenario.field.concentration * 2 * scenario.field.half_width),
                1e-9);
}

TEST(Traced, FewerFloesThanOutlinesAreSpreadOverTheirAreas) {
    Scenario scenario = traced_scenario();
    scenario.field.floes = 1;
    EXPECT_NEAR(traced_shapes(scenario).at(0).area(), 0.64, 1e-9);
}

TEST(Traced, ScaleAppliesToLengths) {
    Scenario scenario = traced_scenario();
    const double once = covered_area(floes_of(scenario));
    scenario.shapes.traced.scale = 1.5;
    EXPECT_NEAR(covered_area(floes_of(scenario)), 2.25 * once, 1e-9 * once);
}

TEST(Traced, LieWhereTheyWereTraced) {
    Scenario scenario = traced_scenario();
    scenario.arrangement.method = ArrangementMethod::traced;
    scenario.field.floes = 3;
    scenario.field.concentration = 0.05;
    scenario.analysis.steady_start = 60;
    scenario.analysis.window = 3;
    EXPECT_EQ(refusal_of(scenario), "");
    const double near = scenario.field.begin + scenario.arrangement.clearance;
    for (const std::uint32_t number : {0u, 5u}) {
        const FloeSet floes = floes_of(scenario, {1, number});
        EXPECT_NEAR(floes.floes[0].pose.x, near + 3.5, 1e-12);
        EXPECT_NEAR(floes.floes[0].pose.z, 1.5, 1e-12);
        EXPECT_NEAR(floes.floes[2].pose.z, -0.6, 1e-12);
        EXPECT_NEAR(floes.shape(1).area(), 0.36, 1e-12);
    }
}

TEST(Traced, OutlinesMayRunInEitherDirection) {
    Scenario scenario = traced_scenario();
    const std::vector<FloeShape> shapes = traced_shapes(scenario);
    for (Outline& one : scenario.shapes.traced.outlines) std::ranges::reverse(one);
    EXPECT_EQ(refusal_of(scenario), "");
    const std::vector<FloeShape> reversed = traced_shapes(scenario);
    for (std::size_t i = 0; i < shapes.size(); ++i) EXPECT_NEAR(reversed[i].area(), shapes[i].area(), 1e-12);
}

TEST(Traced, WhatFilledHolesAddIsMeasured) {
    Scenario scenario = traced_scenario();
    TracedOutlines& traced = scenario.shapes.traced;
    traced.areas = {0.98, 0.36, 0.5};
    traced.names = "A, B, C, with more";
    EXPECT_NEAR(traced_added(traced).at(2), 0.28, 1e-12);
    EXPECT_EQ(refusal_of(scenario),
              "outline 3 \"C\" has holes: filled it would cover 28 % more, above shapes.most_added_percent = 10; trace "
              "it as several floes, allow more, or leave it out");
    traced.most_added = 0.01;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("shapes.most_added_percent = 1 (and 1 more);"));
    traced.most_added = 0.29;
    EXPECT_EQ(refusal_of(scenario), "");
    traced.areas.pop_back();
    EXPECT_THAT(refusal_of(scenario), HasSubstr("2 areas for 3 outlines"));
}

TEST(Traced, AreRefusedWhereTheyAreNoFloes) {
    Scenario scenario = traced_scenario();
    scenario.shapes.traced.outlines[1] = rectangle(0, 0, 2, 0.03);
    EXPECT_EQ(
        refusal_of(scenario),
        "outline 2 is thinner than the ice: the widest circle in a convex part of it has a diameter of 0.03 m, less "
        "than ice.thickness_m = 0.033; leave such floes out of the file, or change shapes.scale or shapes.unit");
    Scenario named = scenario;
    named.shapes.traced.names = "A, <b> < c, C";
    EXPECT_THAT(refusal_of(named), testing::AllOf(testing::StartsWith("outline 2 \"<b> < c\" is thinner"),
                                                  HasSubstr("than ice.thickness_m = 0.033;")));
    scenario.shapes.traced.outlines[1] = rectangle(0, 0, 2, 0.1);
    EXPECT_EQ(refusal_of(scenario), "") << "narrower than an element";
    scenario.shapes.traced.outlines[1] = rectangle(0, 0, 0.1, 0.1);
    EXPECT_EQ(refusal_of(scenario), "") << "smaller than one";
    scenario.shapes.traced.outlines[1] = {{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}};
    EXPECT_EQ(refusal_of(scenario), "");
    scenario.shapes.traced.outlines[1] = {{0, 0}, {2, 0}, {-1, 0.5}, {2, 2}, {0, 2}};
    EXPECT_THAT(refusal_of(scenario), HasSubstr("outline 2 is no floe: it crosses or touches itself"));
    scenario.shapes.traced.outlines[1].clear();
    for (int k = 0; k < 17; ++k)
        scenario.shapes.traced.outlines[1].push_back({std::cos(2 * M_PI * k / 17), std::sin(2 * M_PI * k / 17)});
    EXPECT_THAT(refusal_of(scenario), HasSubstr("outline 2 has 17 corners, more than the 16 of a floe"));
    scenario = traced_scenario();
    scenario.shapes.traced.scale = 1e4;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("elements, more than the 1e+07"));
    scenario.shapes.traced.outlines.clear();
    EXPECT_EQ(refusal_of(scenario), "shapes.kind = \"file\" needs outlines; give shapes.file or shapes.outlines");
}

TEST(Traced, AreRefusedWithWhatDoesNotSuitThem) {
    Scenario scenario = traced_scenario();
    scenario.sizes.law = SizeLaw::lognormal;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("the outlines have their own sizes"));
    scenario = traced_scenario();
    scenario.arrangement.method = ArrangementMethod::traced;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("field.floes = 189 is not the number of outlines, 3,"));
    scenario.shapes.kind = ShapeKind::polygon;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("arrangement.method = \"traced\" needs shapes.kind = \"file\""));
}

}  // namespace traced_test
}  // namespace floes
