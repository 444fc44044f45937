// Built-in hulls against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/units.hpp"
#include "shapes/hydrostatics.hpp"
#include "shapes/shape.hpp"

namespace floes {
namespace hull_test {

constexpr double pi = std::numbers::pi;

double cot(double degrees) {
    return 1 / std::tan(degrees * unit::degree);
}

/// ∫ (a + b y)(c + d y) dy from -draught to 0.
double integral(double a, double b, double c, double d, double draught) {
    return a * c * draught - (a * d + b * c) * draught * draught / 2 + b * d * draught * draught * draught / 3;
}

HullSizes ship_sizes() {
    return {.length = 100,
            .beam = 20,
            .draught = 6,
            .freeboard = 4,
            .stem = 60 * unit::degree,
            .flare = 75 * unit::degree,
            .entrance = 30 * unit::degree};
}

TEST(BuiltInHull, ABargeIsAsItsFormula) {
    const HullSizes s = ship_sizes();
    const Shape barge(HullKind::barge, s);
    ASSERT_FALSE(barge.fault());
    EXPECT_NEAR(hydrostatics(barge).waterplane, 100 * 20, 1e-6);
    EXPECT_NEAR(hydrostatics(barge).volume, integral(100, 2 * cot(60), 20, 2 * cot(75), 6), 1e-4);
    EXPECT_NEAR(barge.volume() - hydrostatics(barge).volume, integral(100, -2 * cot(60), 20, -2 * cot(75), 4), 1e-4);
    EXPECT_NEAR(barge.draught(), 6, 1e-9);
    EXPECT_NEAR(barge.top(), 4, 1e-9);
    EXPECT_NEAR(barge.waterline_radius(), 10, 1e-9);
    EXPECT_NEAR(barge.waterline_ahead(), 50, 1e-9);
    EXPECT_EQ(barge.solids().size(), 1U) << "it is convex";
}

// At the height y the half breadth is b = B/2 + y cot β and the tip lies at L/2 + y cot φ; a wedge takes b²/tan α of
// the rectangle away.
TEST(BuiltInHull, AWedgeIsAsItsFormula) {
    const HullSizes s = ship_sizes();
    const Shape ship(HullKind::wedge_bow, s);
    ASSERT_FALSE(ship.fault());
    const double wedge = integral(10, cot(75), 10, cot(75), 6) * cot(30);
    EXPECT_NEAR(hydrostatics(ship).waterplane, 100 * 20 - 10 * 10 * cot(30), 1e-6);
    EXPECT_NEAR(hydrostatics(ship).volume, integral(100, cot(60), 20, 2 * cot(75), 6) - wedge, 1e-4);
    const Shape drillship(HullKind::drillship, s);
    EXPECT_NEAR(hydrostatics(drillship).waterplane, 100 * 20 - 2 * 10 * 10 * cot(30), 1e-6);
    EXPECT_NEAR(hydrostatics(drillship).volume, integral(100, 2 * cot(60), 20, 2 * cot(75), 6) - 2 * wedge, 1e-4);
}

TEST(BuiltInHull, LegsAndCylindersAreRound) {
    const HullSizes s{.diameter = 8, .spacing = 30, .draught = 12, .freeboard = 5};
    const Shape legs(HullKind::four_legs, s);
    ASSERT_FALSE(legs.fault());
    EXPECT_NEAR(hydrostatics(legs).volume, 4 * 16 * pi * 12, 1e-8);
    EXPECT_NEAR(hydrostatics(legs).waterplane, 4 * 16 * pi, 1e-9);
    EXPECT_NEAR(legs.volume(), 4 * 16 * pi * 17, 1e-9);
    EXPECT_NEAR(legs.waterline_radius(), 19, 1e-9);
    EXPECT_NEAR(legs.largest_radius(), std::hypot(15, 15) + 4, 1e-2);
    EXPECT_EQ(legs.parts(), (std::vector<std::string>{"fore port", "fore starboard", "aft port", "aft starboard"}));
    EXPECT_EQ(legs.waterline_ellipses().size(), 4U);
    const Shape cylinder(HullKind::cylinder, s);
    EXPECT_EQ(cylinder.waterline_radius(), 4);
    EXPECT_EQ(cylinder.profile(), (std::vector<std::vector<double>>{{-12, 4}, {5, 4}}));
}

TEST(BuiltInHull, ConesNarrowAndFlare) {
    const HullSizes s{.diameter = 40, .draught = 6, .freeboard = 3, .wall = 45 * unit::degree};
    const Shape down(HullKind::cone_down, s);
    const Shape up(HullKind::cone_up, s);
    EXPECT_NEAR(down.wall_angle_above_water(), 45 * unit::degree, 1e-9);
    EXPECT_NEAR(up.wall_angle_above_water(), 135 * unit::degree, 1e-9);
    EXPECT_NEAR(hydrostatics(down).volume, pi / 3 * 6 * (14 * 14 + 14 * 20 + 20 * 20), 1e-6);
    EXPECT_NEAR(hydrostatics(up).volume, pi / 3 * 6 * (26 * 26 + 26 * 20 + 20 * 20), 1e-6);
    EXPECT_TRUE(down.is_of_revolution());
}

TEST(BuiltInHull, KnowsThePartsOfItsFaces) {
    const Shape barge(HullKind::barge, ship_sizes());
    const std::vector<std::string> parts = barge.parts();
    const ConvexSolid solid = barge.solids().front();
    const auto part_at = [&](const Vec3& point) { return parts.at(static_cast<std::size_t>(solid.part_at(point))); };
    EXPECT_EQ(part_at({50, 0, 3}), "bow");
    EXPECT_EQ(part_at({-50, 0, 3}), "stern");
    EXPECT_EQ(part_at({20, 0, -10}), "port");
    EXPECT_EQ(part_at({20, 0, 10}), "starboard");
    EXPECT_EQ(part_at({20, -6, 1}), "bottom and deck");
    const Shape ship(HullKind::drillship, ship_sizes());
    EXPECT_EQ(ship.parts().at(static_cast<std::size_t>(ship.solids().front().part_at({45, 0, 2.5}))), "bow");
    EXPECT_EQ(ship.parts().at(static_cast<std::size_t>(ship.solids().front().part_at({-45, 0, -2.5}))), "stern");
}

TEST(BuiltInHull, RefusesSizesThatAreNoHull) {
    HullSizes s = ship_sizes();
    s.beam = 0;
    EXPECT_EQ(Shape(HullKind::barge, s).fault(), "needs hull.beam_m; give it above 0");
    s = ship_sizes();
    s.draught = 40;  // sides of 75° meet 37.3 m below the water
    EXPECT_TRUE(Shape(HullKind::barge, s).fault()->starts_with("closes at a depth of 37.3"));
    s = ship_sizes();
    s.entrance = 5 * unit::degree;
    EXPECT_TRUE(Shape(HullKind::wedge_bow, s).fault()->starts_with("is shorter than its wedge"));
    EXPECT_TRUE(Shape(HullKind::four_legs, {.diameter = 8, .spacing = 7, .draught = 1, .freeboard = 1})
                    .fault()
                    ->starts_with("has legs that touch"));
    EXPECT_TRUE(Shape(HullKind::cone_down, {.diameter = 8, .draught = 9, .freeboard = 1, .wall = 45 * unit::degree})
                    .fault()
                    ->starts_with("comes to a point"));
    EXPECT_TRUE(Shape(HullKind::file, {}).fault()->starts_with("needs hull.file"));
}

/// Two boxes that overlap by half of each, as the pieces of a file.
Shape two_boxes() {
    std::vector<std::vector<double>> rows;
    for (int piece = 0; piece < 2; ++piece)
        for (const double x : {0.0, 2.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0})
                    rows.push_back({static_cast<double>(piece), static_cast<double>(piece), x + piece, y, z});
    Shape shape(HullKind::file, {});
    shape.set_pieces(rows);
    shape.part_list() = "fore, aft";
    return shape;
}

TEST(PiecesOfAFile, CountTheirVolumeOnce) {
    const Shape shape = two_boxes();
    ASSERT_FALSE(shape.fault()) << *shape.fault();
    EXPECT_NEAR(shape.volume(), 12, 1e-9);
    EXPECT_EQ(shape.parts(), (std::vector<std::string>{"fore", "aft"}));
    const std::vector<WaterlineEllipse> ellipses = shape.waterline_ellipses();
    ASSERT_EQ(ellipses.size(), 1U) << "they meet";
    EXPECT_EQ(ellipses.front(), (WaterlineEllipse{1.5, 0, 1.5, 1}));
}

TEST(PiecesOfAFile, RowsReadBackEqual) {
    const Shape shape = two_boxes();
    Shape again(HullKind::file, {});
    again.set_pieces(shape.piece_rows());
    again.part_list() = "fore, aft";
    EXPECT_EQ(again, shape);
}

TEST(PiecesOfAFile, FacesMayBeOfAnotherPart) {
    Shape shape = two_boxes();
    shape.set_faces({{0, 1, 1}});
    ASSERT_FALSE(shape.fault());
    EXPECT_EQ(shape.solids().front().face_parts, (std::vector<int>{0, 1, 0, 0, 0, 0}));
    shape.set_faces({{0, 6, 1}});
    EXPECT_TRUE(shape.fault().has_value());
}

}  // namespace hull_test
}  // namespace floes
