#include "shapes/polygon.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace polygon_test {

using testing::HasSubstr;

Outline regular(int corners, double radius, double turn = 0) {
    Outline outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = turn + 2 * std::numbers::pi * k / corners;
        outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return outline;
}

const Outline oblong{{1, 2}, {5, 2}, {5, 3}, {1, 3}};  // 4 x 1 about (3, 2.5)

TEST(Polygon, MeasuresARectangleByItsClosedForm) {
    const Measures of = measures_of(oblong);
    EXPECT_NEAR(of.area, 4, 1e-14);
    EXPECT_NEAR(of.centroid.x, 3, 1e-14);
    EXPECT_NEAR(of.centroid.z, 2.5, 1e-14);
    EXPECT_NEAR(of.xx, 4.0 * 4 * 4 / 12, 1e-13);
    EXPECT_NEAR(of.zz, 4.0 / 12, 1e-13);
    EXPECT_NEAR(of.xz, 0, 1e-13);
}

TEST(Polygon, MeasuresATriangleByItsClosedForm) {
    const Measures of = measures_of(Outline{{0, 0}, {3, 0}, {0, 2}});  // b h³/36, b² h²/72
    EXPECT_NEAR(of.area, 3, 1e-14);
    EXPECT_NEAR(of.xx, 2.0 * 27 / 36, 1e-13);
    EXPECT_NEAR(of.zz, 3.0 * 8 / 36, 1e-13);
    EXPECT_NEAR(of.xz, -9.0 * 4 / 72, 1e-13);
}

TEST(Polygon, HasNoProductOfInertiaInItsLongAxis) {
    const Outline turned = from_axes(oblong, {0.3, -2}, {0.6, -0.8});
    const Measures of = measures_of(turned);
    const Corner axis = long_axis(of);
    EXPECT_NEAR(axis.x, 0.6, 1e-12);
    EXPECT_NEAR(axis.z, -0.8, 1e-12);
    const Measures own = measures_of(in_axes(turned, of.centroid, axis));
    EXPECT_NEAR(own.xz, 0, 1e-12);
    EXPECT_NEAR(own.xx, 16.0 / 3, 1e-12);
}

TEST(Polygon, IsClippedByAHalfPlane) {
    EXPECT_NEAR(area_of(clipped(oblong, {{1, 0}, 2})), 1, 1e-14);
    EXPECT_TRUE(clipped(oblong, {{1, 0}, 0.5}).empty());
    EXPECT_EQ(clipped(oblong, {{1, 0}, 6}), oblong);
}

TEST(Polygon, IsErodedByAnOffsetAndGrownBack) {
    const Outline hexagon = regular(6, 1);
    const double inner = std::sqrt(0.75);
    const Outline less = eroded(hexagon, 0.2);
    EXPECT_NEAR(area_of(less) / area_of(hexagon), std::pow(1 - 0.2 / inner, 2), 1e-12);
    EXPECT_NEAR(area_of(grown(less, 0.2)), area_of(hexagon), 1e-12);
    EXPECT_TRUE(eroded(hexagon, 0.9).empty());
    EXPECT_NEAR(inner_radius(hexagon), inner, 3e-6);
}

TEST(Polygon, KnowsHowFarAnotherOneIs) {
    const Outline square = regular(4, std::sqrt(2.0), std::numbers::pi / 4);  // of side 2
    const auto at = [&](double x, double z) { return in_axes(square, {-x, -z}, {1, 0}); };
    EXPECT_NEAR(separation(square, at(3, 0.5)), 1, 1e-12);
    EXPECT_NEAR(separation(square, at(1.5, 0)), -0.5, 1e-12);
    EXPECT_NEAR(distance_between(square, at(5, 6)), 5, 1e-12);  // corner to corner
    EXPECT_NEAR(separation(square, at(5, 6)), 4, 1e-12);
    EXPECT_TRUE(contains(square, {0.9, -0.9}));
    EXPECT_FALSE(contains(square, {1.1, 0}));
}

TEST(Polygon, LosesWhatIsShorterThanItsPurpose) {
    Outline outline = oblong;
    outline.insert(outline.begin() + 1, {3, 2});         // on a straight edge
    outline.insert(outline.begin() + 3, {5, 2 + 1e-9});  // next to a corner
    EXPECT_EQ(tidied(outline, 1e-4).size(), 4u);
}

TEST(Polygon, SaysWhatIsWrongWithIt) {
    EXPECT_EQ(fault_of(oblong), std::nullopt);
    EXPECT_EQ(fault_of(Outline(oblong.rbegin(), oblong.rend())), std::nullopt);
    EXPECT_THAT(fault_of(Outline{{0, 0}, {1, 0}}).value(), HasSubstr("2 corners"));
    EXPECT_THAT(fault_of(Outline{{0, 0}, {1, 1}, {2, 2}}).value(), HasSubstr("no area"));
    EXPECT_THAT(fault_of(Outline{{0, 0}, {2, 0}, {0, 2}, {2, 2.5}}).value(), HasSubstr("crosses itself"));
    EXPECT_THAT(fault_of(Outline{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}).value(), HasSubstr("inwards at corner 3"));
    EXPECT_THAT(fault_of(Outline{{0, 0}, {1, NAN}, {2, 2}}).value(), HasSubstr("finite"));
}

TEST(Polygon, HullIsRoundAllPoints) {
    const Outline hull = convex_hull({{0, 0}, {2, 0}, {1, 0}, {0.5, 0.5}, {0, 2}, {2, 2}, {2, 2}});
    EXPECT_EQ(hull.size(), 4u);
    EXPECT_NEAR(area_of(hull), 4, 1e-14);
}

}  // namespace polygon_test
}  // namespace floes
