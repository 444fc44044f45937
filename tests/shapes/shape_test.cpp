#include "shapes/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/units.hpp"
#include "shapes/path.hpp"

namespace floes {
namespace shape_test {

const Frustum& round(const std::vector<ConvexSolid>& solids, std::size_t k) {
    return std::get<Frustum>(solids.at(k).form);
}

// Table 2: maximum and waterline breadth, draught, depth. Above the waterline the wall through them stands at 45°.
TEST(Shape, DefaultIsTheStructureOfTable2) {
    const Shape shape;
    EXPECT_FALSE(shape.fault().has_value());
    EXPECT_NEAR(2 * shape.waterline_radius(), 1.228, 1e-12);
    EXPECT_NEAR(2 * shape.largest_radius(), 1.472, 1e-12);
    EXPECT_NEAR(shape.draught(), 0.443, 1e-12);
    EXPECT_NEAR(shape.top() - shape.bottom(), 0.565, 1e-12);
    EXPECT_NEAR(shape.wall_angle_above_water(), 45 * unit::degree, 1e-12);
}

TEST(Shape, RowsReadBackEqual) {
    const Shape bent({{-1.0 / 3, 0.1}, {0.0, 0.5}, {0.0, 0.6}, {0.2, 0.7}});
    const std::vector<std::vector<double>> rows{{-1.0 / 3, 0.1}, {0.0, 0.5}, {0.0, 0.6}, {0.2, 0.7}};
    EXPECT_EQ(bent.rows(), rows);
    EXPECT_EQ(Shape::of_rows(rows), bent);
    EXPECT_NE(Shape::of_rows(rows), Shape{});
    for (const std::vector<double>& row : rows) EXPECT_EQ(row.size(), Shape::columns.size());
}

TEST(Shape, WaterlineRadiusIsLinearBetweenPointsAndZeroOutside) {
    EXPECT_DOUBLE_EQ(Shape({{-1, 2}, {1, 4}}).waterline_radius(), 3);
    EXPECT_DOUBLE_EQ(Shape({{-0.5, 2}, {1.5, 4}}).waterline_radius(), 2.5);
    EXPECT_EQ(Shape({{0, 2}, {1, 4}}).waterline_radius(), 2);
    EXPECT_EQ(Shape({{-1, 0.2}, {-0.5, 0.3}}).waterline_radius(), 0);
    EXPECT_EQ(Shape({{0.5, 0.2}, {1, 0.3}}).waterline_radius(), 0);
}

TEST(Shape, WaterlineRadiusOfARingIsTheLarger) {
    EXPECT_EQ(Shape({{-1, 0.2}, {0, 0.3}, {0, 0.5}, {1, 0.6}}).waterline_radius(), 0.5);
    EXPECT_EQ(Shape({{-1, 0.2}, {0, 0.5}, {0, 0.3}, {1, 0.6}}).waterline_radius(), 0.5);
}

TEST(Shape, ANarrowWaistIsNotFilledIn) {
    const Shape waist({{-1, 1}, {-0.2, 0.3}, {0.5, 1}});
    const std::vector<ConvexSolid> expected{Frustum{-1, 1, -0.2, 0.3}, Frustum{-0.2, 0.3, 0.5, 1}};
    EXPECT_EQ(waist.solids(), expected);
    EXPECT_EQ(waist.largest_radius(), 1);
}

TEST(Shape, OverlappingPiecesOfAWaistReachThroughIt) {
    const std::vector<ConvexSolid> found = Shape({{-1, 1}, {-0.2, 0.3}, {0.5, 1.3}}).overlapping_solids();
    ASSERT_EQ(found.size(), 2);
    EXPECT_EQ(round(found, 0), (Frustum{-1, 1, -0.2, 0.3})) << "it would narrow to below 0";
    EXPECT_EQ(round(found, 1), (Frustum{-0.2, 0.3, 0.5, 1.3})) << "likewise";
    const std::vector<ConvexSolid> flare = Shape({{-0.4, 0.5}, {0, 0.6}, {0.1, 0.7}}).overlapping_solids();
    ASSERT_EQ(flare.size(), 2);
    EXPECT_DOUBLE_EQ(round(flare, 0).top_height, 0.1);
    EXPECT_DOUBLE_EQ(round(flare, 0).top_radius, 0.625);
    EXPECT_DOUBLE_EQ(round(flare, 1).bottom_height, -0.4);
    EXPECT_DOUBLE_EQ(round(flare, 1).bottom_radius, 0.2);
}

TEST(Shape, OverlappingPiecesStayInside) {
    const Shape barrel({{-1, 0.5}, {0, 1}, {1, 0.5}});  // an edge that sticks out is no waist
    EXPECT_EQ(barrel.overlapping_solids(), barrel.solids());
    const std::vector<ConvexSolid> stepped = Shape({{-1, 0.5}, {-0.3, 0.5}, {-0.3, 1}, {0.2, 1}}).overlapping_solids();
    const std::vector<ConvexSolid> expected{Frustum{-1, 0.5, 0.2, 0.5}, Frustum{-0.3, 1, 0.2, 1}};
    EXPECT_EQ(stepped, expected);
}

TEST(Shape, OverlappingPiecesEndWhereARingStepsInwards) {
    const Shape notched({{-6, 10}, {-3, 10}, {-3, 6}, {5, 14}});
    const std::vector<ConvexSolid> found = notched.overlapping_solids();
    ASSERT_EQ(found.size(), 2);
    EXPECT_EQ(round(found, 0), (Frustum{-6, 10, -3, 10})) << "a wall through the notch";
    EXPECT_EQ(round(found, 1).bottom_height, -6);
    const Shape upside_down({{-5, 14}, {3, 6}, {3, 10}, {6, 10}});
    EXPECT_EQ(round(upside_down.overlapping_solids(), 1), (Frustum{3, 10, 6, 10}));
}

TEST(Shape, AFlatRingIsNoPiece) {
    const std::vector<ConvexSolid> expected{Frustum{-1, 0.5, -0.3, 0.5}, Frustum{-0.3, 1, 0.2, 1}};
    EXPECT_EQ(Shape({{-1, 0.5}, {-0.3, 0.5}, {-0.3, 1}, {0.2, 1}}).solids(), expected);
}

TEST(Shape, ALineOnTheAxisIsNoPiece) {
    const std::vector<ConvexSolid> expected{Frustum{-0.5, 0, 0.5, 1}};
    EXPECT_EQ(Shape({{-1, 0}, {-0.5, 0}, {0.5, 1}}).solids(), expected);
}

TEST(Shape, WallAngleIsThatOfThePartThatRisesFromTheWater) {
    const Shape narrowing({{-1, 0.5}, {-0.3, 0.6}, {0.3, 0}, {1, 1}});
    EXPECT_NEAR(narrowing.wall_angle_above_water(), 135 * unit::degree, 1e-12);
    EXPECT_NEAR(Shape({{-1, 0.5}, {0, 0.6}, {1, 0.6}}).wall_angle_above_water(), 90 * unit::degree, 1e-12);
    EXPECT_THROW(static_cast<void>(Shape({{-1, 0.5}, {0, 0.6}}).wall_angle_above_water()), InputError);
}

TEST(Shape, SaysWhatItIs) {
    EXPECT_EQ(Shape({{-0.443, 0.171}, {0.122, 0.736}}).words().text(),
              "straight, 45.0° from the horizontal (radius 0.171 m at -0.443 m to 0.736 m at +0.122 m)");
    // 0.43 m at the bottom: 67° below the waterline, 45° above.
    EXPECT_EQ(
        Shape({{-0.443, 0.426}, {0.0, 0.614}, {0.122, 0.736}}).words().text(),
        "67.0° from the horizontal (radius 0.426 m at -0.443 m to 0.614 m at +0.000 m), then 45.0° from the horizontal "
        "(radius 0.614 m at +0.000 m to 0.736 m at +0.122 m)");
}

TEST(Shape, SectionIsSymmetricAndClosesAtTheKeel) {
    const std::vector<Vec2> expected{{1, -2}, {3, 4}, {-3, 4}, {-1, -2}};
    EXPECT_EQ(Shape({{-2, 1}, {4, 3}}).side_view().front(), expected);
}

TEST(Shape, RefusesWhatIsNoBody) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::vector<ProfilePoint>> faulty{{},
                                                        {{-1, 1}},
                                                        {{1, 1}, {-1, 1}},
                                                        {{-1, 1}, {1, -0.1}},
                                                        {{-1, nan}, {1, 1}},
                                                        {{nan, 1}, {1, 1}},
                                                        {{-1, 1}, {-0.1, 1}},
                                                        {{0, 1}, {1, 1}},
                                                        {{-1, 0}, {0, 0}, {1, 1}}};
    for (const std::vector<ProfilePoint>& profile : faulty) {
        const Shape shape(profile);
        EXPECT_TRUE(shape.fault().has_value()) << shape.words().text();
        EXPECT_THROW(static_cast<void>(shape.solids()), InputError) << shape.words().text();
    }
}

TEST(Frustum, ReachesFarthestOnItsRims) {
    const Frustum cone{-1, 0.5, 1, 2};
    EXPECT_EQ(cone.farthest({0, 1, 0}).y(), 1);
    EXPECT_EQ(cone.farthest({0, -1, 0}).y(), -1);
    EXPECT_TRUE(cone.farthest({3, 0, 4}).isApprox(Vec3(1.2, 1, 1.6)));
    EXPECT_TRUE(cone.farthest({1, -1, 0}).isApprox(Vec3(0.5, -1, 0))) << "steeper than the wall's normal";
}

// 45°: a wall that lies d inside along its normal lies d sqrt(2) inside along the radius.
TEST(Frustum, InsideLiesAsDeepAlongTheNormal) {
    const double d = 0.01;
    const Frustum core = Frustum{-1, 1, 1, 3}.inside(d);
    EXPECT_NEAR(core.bottom_radius, 1 - d * std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(core.top_radius, 3 - d * std::sqrt(2.0), 1e-15);
    EXPECT_EQ(core.bottom_height, -1);
    const Frustum tip = Frustum{-1, 0, 1, 2}.inside(d);
    EXPECT_EQ(tip.bottom_radius, 0);
    EXPECT_NEAR(tip.bottom_height, -1 + d * std::sqrt(2.0), 1e-15);
}

TEST(Tow, MovesAtConstantSpeedFromItsStart) {
    const Tow tow{2.0, 0.07};
    EXPECT_EQ(tow.x(0), 2.0);
    EXPECT_DOUBLE_EQ(tow.x(100), 9.0);
}

}  // namespace shape_test
}  // namespace floes
