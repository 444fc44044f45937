#include "shapes/convex_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"

namespace floes {
namespace polyhedron_test {

std::vector<Vec3> grid_of_a_box(double x, double y, double z, int steps) {
    std::vector<Vec3> points;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            for (int k = 0; k <= steps; ++k) points.emplace_back(x * i / steps, y * j / steps, z * k / steps);
    return points;
}

TEST(ConvexHull, OfAGridIsTheBoxWithSixWholeFaces) {
    const Polyhedron box = convex_hull(grid_of_a_box(3, 2, 1, 5));
    EXPECT_EQ(box.corners.size(), 8U);
    EXPECT_EQ(box.faces.size(), 6U);
    for (const std::vector<int>& face : box.faces) EXPECT_EQ(face.size(), 4U);
    EXPECT_NEAR(box.volume(), 6, 1e-12);
    EXPECT_NEAR((box.centroid() - Vec3(1.5, 1, 0.5)).norm(), 0, 1e-12);
}

// Rounded as STL rounds: a face is still one face.
TEST(ConvexHull, KeepsFacesWholeInSinglePrecision) {
    std::vector<Vec3> points = grid_of_a_box(100, 20, 8, 4);
    const double c = std::cos(0.3);
    const double s = std::sin(0.3);
    for (Vec3& point : points) {
        point = Vec3(c * point.x() - s * point.y(), s * point.x() + c * point.y(), point.z());
        for (double& value : point) value = static_cast<double>(static_cast<float>(value));
    }
    const Polyhedron box = convex_hull(points);
    EXPECT_EQ(box.faces.size(), 6U);
    EXPECT_NEAR(box.volume(), 16000, 0.05);
}

TEST(ConvexHull, HoldsRandomPointsOfABall) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::vector<Vec3> points;
    for (int k = 0; k < 400; ++k) points.push_back(Vec3(normal(random), normal(random), normal(random)).normalized());
    const Polyhedron ball = convex_hull(points);
    EXPECT_EQ(ball.corners.size(), 400U);
    for (const Vec3& point : points)
        for (const Plane& plane : ball.planes) EXPECT_LT(plane.height(point), 1e-6);
    EXPECT_NEAR(ball.volume(), 4.0 / 3 * std::acos(-1.0), 0.15);
}

TEST(ConvexHull, OfAPlaneIsEmpty) {
    EXPECT_TRUE(convex_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.3, 0}}).empty());
    EXPECT_TRUE(convex_hull(std::vector<Vec3>{}).empty());
}

TEST(Polyhedron, InsideLiesAsDeepAlongEachNormal) {
    const Polyhedron box = convex_hull(grid_of_a_box(3, 2, 1, 1));
    EXPECT_NEAR(box.inside(0.1).volume(), 2.8 * 1.8 * 0.8, 1e-12);
    EXPECT_TRUE(box.inside(0.6).empty());
    // A regular octahedron, where four faces meet at each corner: its inscribed sphere shrinks by the depth.
    const Polyhedron octahedron =
        convex_hull(std::vector<Vec3>{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    const double radius = 1 / std::sqrt(3.0);
    const double left = (radius - 0.1) / radius;
    EXPECT_NEAR(octahedron.inside(0.1).volume(), 4.0 / 3 * left * left * left, 1e-12);
}

TEST(Polyhedron, CutAndSectionAreThoseOfAPyramid) {
    const Polyhedron pyramid =
        convex_hull(std::vector<Vec3>{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 2, 0}});
    EXPECT_NEAR(pyramid.volume(), 8.0 / 3, 1e-12);
    EXPECT_NEAR(area_of(pyramid.section(1)), 1, 1e-12);
    EXPECT_NEAR(pyramid.cut({Vec3::UnitY(), 1}).volume(), 8.0 / 3 * 7 / 8, 1e-12);
    EXPECT_TRUE(pyramid.section(3).empty());
    EXPECT_TRUE(pyramid.cut({Vec3::UnitY(), -1}).empty());
}

TEST(Intersection, RefusesWhatHasNoEnd) {
    const std::vector<Plane> tube{{Vec3::UnitX(), 1}, {-Vec3::UnitX(), 1}, {Vec3::UnitY(), 1}, {-Vec3::UnitY(), 1}};
    EXPECT_THROW(static_cast<void>(intersection(tube, Vec3::Zero())), InputError);
    EXPECT_TRUE(intersection(tube, Vec3(2, 0, 0)).empty());
}

}  // namespace polyhedron_test
}  // namespace floes
