// The area over which an edge crushes, read back as the impulse at which a single row yields: it must be the section of
// the box at that depth, for any direction of the normal. What the law does to bodies: tests/world/crushing_test.cpp.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/lane_system.hpp"

namespace floes::testing {
namespace crushing_test {

using Vector = Eigen::Vector3d;

const Vector half_extent(0.1, 0.0165, 0.15);
constexpr double pressure = 145.6e3;
constexpr double time_step = 1e-3;

std::array<double, 3> array_of(const Vector& v) {
    return {v.x(), v.y(), v.z()};
}

/// A box about the origin, so heavy that nothing stops it, against flat ground: normal impulses of points at these
/// depths below the surface.
std::vector<double> impulses(const Eigen::Matrix3d& turn, const Vector& normal, const std::vector<double>& depths,
                             const std::array<double, 3>& extent_of_ground = {}) {
    const SolverBody box{1e-9, {1e-9, 1e-9, 1e-9}, array_of(half_extent)};
    LaneSystem system(std::vector<SolverBody>{box, {0, {}, extent_of_ground}}, {}, 1);
    SolverState state;
    for (int i = 0; i < 9; ++i) state.rotation[static_cast<std::size_t>(i)] = turn(i / 3, i % 3);
    state.velocity = array_of(-normal);
    system.set_state(0, state);
    system.prepare(time_step);
    std::vector<SolverContact> contacts;
    for (const double depth : depths) {
        contacts.push_back({.a = 0, .b = 1, .normal = array_of(normal), .distance = -depth});
    }
    system.solve(contacts, {.normal = NormalLaw::crushing, .crushing_pressure = pressure}, {5});
    std::vector<double> found;
    for (const SolverContact& contact : contacts) found.push_back(contact.impulse);
    return found;
}

double area(const Eigen::Matrix3d& turn, const Vector& normal, double depth) {
    return impulses(turn, normal, {depth})[0] / (pressure * time_step);
}

/// The same by clipping a large square in the plane by the six faces.
double clipped(const Eigen::Matrix3d& turn, const Vector& normal, double depth) {
    const Vector n = turn.transpose() * normal;  // in the box's axes
    const double middle = half_extent.dot(n.cwiseAbs());
    const Vector u = n.unitOrthogonal();
    const Vector v = n.cross(u);
    const Vector centre = n * (std::min(depth, middle) - middle);
    std::vector<Vector> polygon{centre + u + v, centre - u + v, centre - u - v, centre + u - v};
    for (int face = 0; face < 6; ++face) {
        const double sign = face % 2 == 0 ? 1 : -1;
        const auto inside = [&](const Vector& p) { return half_extent[face / 2] - sign * p[face / 2]; };
        std::vector<Vector> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector& p = polygon[i];
            const Vector& q = polygon[(i + 1) % polygon.size()];
            if (inside(p) >= 0) kept.push_back(p);
            if (inside(p) * inside(q) < 0) kept.push_back(p + (q - p) * (inside(p) / (inside(p) - inside(q))));
        }
        polygon = kept;
    }
    Vector twice = Vector::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        twice += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    }
    return 0.5 * twice.norm();
}

TEST(CrushingArea, IsTheBoxsSectionForAnyNormal) {
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Vector(1, 2, -0.5).normalized()));
    for (int i = 0; i < 40; ++i) {
        const Vector normal = Vector(std::sin(1.7 * i), std::cos(2.3 * i), std::sin(3.1 * i + 1)).normalized();
        for (const double depth : {1e-4, 1e-3, 5e-3, 0.02, 0.05, 0.3}) {
            const double expected = clipped(turn, normal, depth);
            EXPECT_NEAR(area(turn, normal, depth), expected, 1e-6 * expected) << i << " " << depth;
        }
    }
}

TEST(CrushingArea, OfAFlushFaceIsTheFace) {
    for (const int axis : {0, 1, 2}) {
        const double face = 4 * half_extent.prod() / half_extent[axis];
        EXPECT_NEAR(area(Eigen::Matrix3d::Identity(), Vector::Unit(axis), 1e-5), face, 1e-9 * face);
    }
}

TEST(CrushingArea, OfAnEdgeGrowsWithDepth) {
    const Vector normal = Vector(0.6, 0, 0.8);
    for (const double depth : {1e-4, 1e-3}) {
        const double edge = depth / (0.6 * 0.8) * 2 * half_extent.y();
        EXPECT_NEAR(area(Eigen::Matrix3d::Identity(), normal, depth), edge, 2e-3 * edge) << depth;
    }
}

// The smaller of two sections: ground that is a box of its own, no wider than a quarter of the face.
TEST(CrushingArea, IsTheSmallerOfTheTwo) {
    const double face = 4 * half_extent.y() * half_extent.z();
    const std::array<double, 3> narrow{0.1, half_extent.y() / 2, half_extent.z() / 2};
    const double force = impulses(Eigen::Matrix3d::Identity(), Vector::UnitX(), {1e-3}, narrow)[0] / time_step;
    EXPECT_NEAR(force, pressure * face / 4, 1e-6 * force);
}

TEST(CrushingArea, IsSharedByThePointsThatTouch) {
    const double face = 4 * half_extent.y() * half_extent.z();
    const std::vector<double> found = impulses(Eigen::Matrix3d::Identity(), Vector::UnitX(), {1e-3, 2e-3, -1e-3, 1e-3});
    for (const std::size_t i : {0U, 1U, 3U}) EXPECT_NEAR(found[i], pressure * time_step * face / 3, 1e-6 * found[i]);
    EXPECT_EQ(found[2], 0) << "a gap";
}

}  // namespace crushing_test
}  // namespace floes::testing
