#include "shapes/convex_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
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

// Wheels whose rims are rounded by short edges, in any direction, away from the origin and in single precision, as
// public files have them: planes of neighbouring triangles differ by little more than rounding.
TEST(ConvexHull, HoldsFilletedWheelsInSinglePrecision) {
    constexpr int sides = 60;
    constexpr int steps = 12;  // of the fillet
    for (unsigned seed = 0; seed < 12; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> any(0, 1);
        const double fillet = std::pow(10.0, -1 - 2.5 * any(random));  // of a radius of 1
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
        const Vec3 place(10 * any(random), 10 * any(random), 10 * any(random));
        std::vector<Vec3> points;
        double volume = 0;
        double former_radius = 0;
        double former_height = 0;
        for (const double side : {-1.0, 1.0})
            for (int step = 0; step <= steps; ++step) {
                const double angle = std::numbers::pi / 2 * (side < 0 ? step : steps - step) / steps;
                const double radius = 1 - fillet + fillet * std::sin(angle);
                const double height = side * (0.2 - fillet + fillet * std::cos(angle));
                for (int k = 0; k < sides; ++k) {
                    const double round = 2 * std::numbers::pi * k / sides;
                    Vec3 point = turn * Vec3(radius * std::cos(round), radius * std::sin(round), height) + place;
                    for (double& value : point) value = static_cast<double>(static_cast<float>(value));
                    points.push_back(point);
                }
                if (former_radius > 0)  // a slice between two regular polygons
                    volume += sides / 2.0 * std::sin(2 * std::numbers::pi / sides) * (height - former_height) / 3 *
                              (radius * radius + radius * former_radius + former_radius * former_radius);
                former_radius = radius;
                former_height = height;
            }
        const Polyhedron wheel = convex_hull(points);
        EXPECT_NEAR(wheel.volume() / volume, 1, 1e-4) << seed;
        for (const Vec3& point : points)
            for (const Plane& plane : wheel.planes) ASSERT_LT(plane.height(point), 1e-4) << seed;
    }
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
