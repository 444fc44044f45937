// Floes that are polygons, laid down: cells where they grew, others scattered.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "arrangement/crowd.hpp"
#include "scattered_scenario.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace polygons_test {

TEST(Polygons, LieUpToTheConcentrationThatIsAsked) {
    for (const auto& [kind, concentration] : {std::pair(ShapeKind::voronoi, 0.5),
                                              {ShapeKind::voronoi, 0.9},
                                              {ShapeKind::polygon, 0.6},
                                              {ShapeKind::polygon, 0.75}}) {
        const Scenario scenario = polygon_scenario(kind, concentration, 60);
        for (std::uint32_t number = 0; number < 3; ++number) {
            const Arrangement made = make_arrangement(scenario, 1, number);
            EXPECT_EQ(find_fault(scenario, made), std::nullopt);
            EXPECT_NEAR(covered_area(made) / (scenario.field_length() * 2 * scenario.field.half_width), concentration,
                        1e-6 * concentration);
            EXPECT_NEAR(made.coverage_ahead, concentration, 0.35 * concentration);
        }
    }
}

TEST(Polygons, ArePureFunctionsOfTheirNumber) {
    for (const ShapeKind kind : {ShapeKind::voronoi, ShapeKind::polygon}) {
        const Scenario scenario = polygon_scenario(kind, 0.6, 60);
        const Arrangement one = make_arrangement(scenario, 1, 2);
        const Arrangement again = make_arrangement(scenario, 1, 2);
        EXPECT_EQ(one.shapes, again.shapes);
        EXPECT_EQ(one.coverage_ahead, again.coverage_ahead);
        EXPECT_NE(one.shapes, make_arrangement(scenario, 1, 3).shapes);
        EXPECT_NE(one.shapes, make_arrangement(scenario, 2, 2).shapes);
    }
}

TEST(Polygons, FaultsAreFound) {
    const Scenario scenario = polygon_scenario(ShapeKind::voronoi, 0.7, 60);
    Arrangement made = make_arrangement(scenario, 1, 0);
    Arrangement moved = made;
    moved.floes[5].pose.x = moved.floes[9].pose.x;
    moved.floes[5].pose.z = moved.floes[9].pose.z;
    ASSERT_TRUE(find_fault(scenario, moved));
    EXPECT_THAT(find_fault(scenario, moved)->sentence, testing::HasSubstr("apart"));
    made.floes[3].pose.z = scenario.field.half_width;
    ASSERT_TRUE(find_fault(scenario, made));
    EXPECT_THAT(find_fault(scenario, made)->sentence, testing::HasSubstr("not inside the field"));
}

TEST(Polygons, TooDenseIsASentence) {
    const Scenario dense = polygon_scenario(ShapeKind::voronoi, 0.999, 60);
    EXPECT_THAT(refusal([&] { static_cast<void>(make_arrangement(dense, 1, 0)); }),
                testing::HasSubstr("arrangement.clearance_m"));
}

/// Two triangles that overlap part by a shift that the deeper normal says.
TEST(Crowd, PartsTwoThatOverlap) {
    const Outline triangle{{-0.2, -0.1}, {0.2, -0.1}, {0, 0.2}};
    const std::vector<Outline> two{triangle, triangle};
    Crowd crowd({-5, -5, 10, 10}, two, std::vector<PlanarPose>{{0, 0, 0}, {0.1, 0.05, 2}});
    EXPECT_GT(crowd.deepest(), 0.01);
    int sweeps = 0;
    while (crowd.sweep() > 0) ASSERT_LT(++sweeps, 100);
    EXPECT_EQ(crowd.deepest(), 0);
    crowd.put(0, {-4.9, 0, 0});
    EXPECT_NEAR(crowd.overlap_at(0, {-4.9, 0, 0}), 0.1, 1e-12);  // with the wall
}

}  // namespace polygons_test
}  // namespace floes
