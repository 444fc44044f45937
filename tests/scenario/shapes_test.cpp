// Floes that are polygons: what is drawn, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scenario/floes.hpp"
#include "scenario/keys.hpp"
#include "scenario/validate.hpp"
#include "shapes/elements.hpp"

namespace floes {
namespace shapes_test {

using testing::HasSubstr;

Scenario polygon_scenario(ShapeKind kind) {
    Scenario scenario;
    scenario.shapes.kind = kind;
    return scenario;
}

std::string refusal_of(const Scenario& scenario) {
    const std::vector<Contradiction> found = find_contradictions(scenario);
    return found.empty() ? "" : found.front().sentence;
}

TEST(Shapes, PolygonsHaveTheAreasOfTheirRectangles) {
    Scenario scenario = polygon_scenario(ShapeKind::polygon);
    scenario.field.floes = 30;
    scenario.sizes = {.law = SizeLaw::list, .list = {{0.4, 0.4, 0.5}, {1.2, 0.6, 0.5}}};
    const FloeSet floes = floes_of(scenario, {1, 0});
    ASSERT_EQ(floes.size(), 30u);
    int small = 0;
    for (std::size_t i = 0; i < floes.size(); ++i) {
        const FloeShape& shape = floes.shape(i);
        small += std::abs(shape.area() - 0.16) < 1e-6 ? 1 : 0;
        EXPECT_TRUE(std::abs(shape.area() - 0.16) < 1e-6 || std::abs(shape.area() - 0.72) < 1e-6);
        EXPECT_NEAR(measures_of(shape.outline).centroid.x, 0, 1e-6);
        EXPECT_NEAR(size_of(shape.outline).x, shape.length, 1e-12);
        EXPECT_EQ(shape.elements(), static_cast<double>(cut_into_cells(shape.outline, shape.element).elements.size()));
    }
    EXPECT_EQ(small, 15);
}

TEST(Shapes, VoronoiCellsCoverTheirFieldAsAsked) {
    const Scenario scenario = polygon_scenario(ShapeKind::voronoi);
    EXPECT_EQ(refusal_of(scenario), "");
    const FloeSet floes = floes_of(scenario, {1, 4});
    EXPECT_NEAR(covered_area(floes), scenario.field.floes * 0.36, 1e-4);
    EXPECT_NEAR(scenario.field_length(), Scenario{}.field_length(), 1e-12);
    for (const Floe& floe : floes.floes) EXPECT_LE(std::abs(floe.pose.z), scenario.field.half_width);
}

TEST(Shapes, CrackByStressOrByMoment) {
    for (const JointFailure failure : {JointFailure::stress, JointFailure::moment}) {
        Scenario scenario = polygon_scenario(ShapeKind::voronoi);
        scenario.joint.failure = failure;
        EXPECT_EQ(refusal_of(scenario), "");
    }
}

TEST(Shapes, AreRefusedWhereSquaresAreNeeded) {
    Scenario scenario = polygon_scenario(ShapeKind::voronoi);
    scenario.joint.model = JointModel::cfm;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("take joint.model = \"beam\""));
    scenario = polygon_scenario(ShapeKind::voronoi);
    scenario.sizes.law = SizeLaw::lognormal;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("the diagram decides the areas"));
    scenario = polygon_scenario(ShapeKind::polygon);
    scenario.arrangement.method = ArrangementMethod::lattice;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("take arrangement.method = \"scattered\" or \"monte_carlo\""));
    scenario = polygon_scenario(ShapeKind::voronoi);
    scenario.field.concentration = 0.999;
    EXPECT_THAT(refusal_of(scenario), HasSubstr("arrangement.clearance_m"));
}

TEST(Shapes, AreMovedByMonteCarloToo) {
    for (const ShapeKind kind : {ShapeKind::polygon, ShapeKind::voronoi}) {
        Scenario scenario = polygon_scenario(kind);
        scenario.arrangement.ordering_sweeps = 10;
        EXPECT_EQ(refusal_of(scenario), "");
        scenario = polygon_scenario(kind);
        scenario.arrangement.method = ArrangementMethod::monte_carlo;
        EXPECT_EQ(refusal_of(scenario), "");
    }
}

TEST(Shapes, LieInAFieldWithoutEndToo) {
    for (const ShapeKind kind : {ShapeKind::polygon, ShapeKind::voronoi}) {
        Scenario scenario = polygon_scenario(kind);
        scenario.field.far_end = FarEnd::never;
        EXPECT_EQ(refusal_of(scenario), "");
    }
}

TEST(Shapes, LeaveTheDigestOfOthersAlone) {
    Scenario scenario;
    const std::string before = canonical_text(scenario);
    EXPECT_EQ(before.find("shapes"), std::string::npos);
    scenario.shapes.corners = 9;  // without effect
    EXPECT_EQ(canonical_text(scenario), before);
    scenario.shapes.kind = ShapeKind::polygon;
    EXPECT_NE(canonical_text(scenario), before);
}

}  // namespace shapes_test
}  // namespace floes
