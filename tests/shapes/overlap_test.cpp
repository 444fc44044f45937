// Pieces of one body that are continued into each other, against closed forms.

#include "shapes/overlap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace overlap_test {

constexpr int sides = 25;

ConvexSolid solid_of(const std::vector<Vec3>& corners, int part = 0) {
    return ConvexSolid(convex_hull(corners), part);
}

ConvexSolid box(const Vec3& low, const Vec3& high, int part = 0) {
    std::vector<Vec3> corners;
    for (const double x : {low.x(), high.x()})
        for (const double y : {low.y(), high.y()})
            for (const double z : {low.z(), high.z()}) corners.emplace_back(x, y, z);
    return solid_of(corners, part);
}

Vec3 on_ring(double radius, double height, int side) {
    const double angle = 2 * std::numbers::pi * side / sides;
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

ConvexSolid ring(double low, double low_radius, double high, double high_radius, int part = 0) {
    std::vector<Vec3> corners;
    for (int side = 0; side < sides; ++side) {
        corners.push_back(on_ring(low_radius, low, side));
        corners.push_back(on_ring(high_radius, high, side));
    }
    return solid_of(corners, part);
}

std::vector<ConvexSolid> wedges(double low, double low_radius, double high, double high_radius) {
    std::vector<ConvexSolid> all;
    for (int side = 0; side < sides; ++side)
        all.push_back(solid_of({{0, low, 0},
                                {0, high, 0},
                                on_ring(low_radius, low, side),
                                on_ring(low_radius, low, side + 1),
                                on_ring(high_radius, high, side),
                                on_ring(high_radius, high, side + 1)}));
    return all;
}

bool holds(const ConvexSolid& solid, const Vec3& point) {
    for (const Plane& plane : std::get<Polyhedron>(solid.form).planes)
        if (plane.height(point) > 1e-9) return false;
    return true;
}

/// A frustum of so many sides, whose polygon takes sides/2 sin(2π/sides) of the radius squared.
double volume(double rise, double a, double b) {
    return sides / 2.0 * std::sin(2 * std::numbers::pi / sides) * rise * (a * a + a * b + b * b) / 3;
}

// The wall of the lower one rises 0.5 for 1 and goes on so for 3/4 of the flare's height, that of the upper one goes on
// down for 3/4 of the lower height.
TEST(Overlap, StackedFrustaOfAFlareAreTheirConesContinued) {
    const std::vector<ConvexSolid> found = overlapping({ring(-0.4, 0.5, 0, 0.7), ring(0, 0.7, 0.2, 0.9)});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].volume(), volume(0.55, 0.5, 0.775), 1e-6);
    EXPECT_NEAR(found[1].volume(), volume(0.5, 0.4, 0.9), 1e-6);
    EXPECT_TRUE(holds(found[0], on_ring(0.7749, 0.1499, 3)));
    EXPECT_FALSE(holds(found[0], on_ring(0.776, 0.15, 3)));
}

TEST(Overlap, AFlareOfWedgesIsTheSame) {
    std::vector<ConvexSolid> pieces = wedges(-0.4, 0.5, 0, 0.7);
    for (const ConvexSolid& one : wedges(0, 0.7, 0.2, 0.9)) pieces.push_back(one);
    const std::vector<ConvexSolid> found = overlapping(pieces);
    ASSERT_EQ(found.size(), 2U) << "a wall that is there twice crushes ice twice";
    EXPECT_NEAR(found[0].volume(), volume(0.55, 0.5, 0.775), 1e-6);
    EXPECT_NEAR(found[1].volume(), volume(0.5, 0.4, 0.9), 1e-6);
}

TEST(Overlap, AStraightConeInTwoIsOne) {
    const std::vector<ConvexSolid> found = overlapping({ring(-0.4, 0.3, 0, 0.7), ring(0, 0.7, 0.2, 0.9)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].volume(), volume(0.6, 0.3, 0.9), 1e-6);
    EXPECT_EQ(std::get<Polyhedron>(found[0].form).faces.size(), sides + 2U);
}

TEST(Overlap, ABarrelInTwoIsOne) {
    const std::vector<ConvexSolid> found = overlapping({ring(-1, 0.5, 0, 1), ring(0, 1, 1, 0.5)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].volume(), 2 * volume(1, 0.5, 1), 1e-5);
}

TEST(Overlap, ABoxInTwoIsTheBoxWithThePartsOfBoth) {
    const std::vector<ConvexSolid> halves{box({0, 0, 0}, {1, 1, 1}, 0), box({1, 0, 0}, {3, 1, 1}, 1)};
    const std::vector<ConvexSolid> found = overlapping(halves);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].volume(), 3, 1e-9);
    EXPECT_EQ(part_at(found[0], halves, {0, 0.5, 0.5}), 0);
    EXPECT_EQ(part_at(found[0], halves, {3, 0.5, 0.5}), 1);
    EXPECT_EQ(part_at(found[0], halves, {0.5, 1.01, 0.5}), 0);
    EXPECT_EQ(part_at(found[0], halves, {1.5, 1.01, 0.5}), 1);
    EXPECT_EQ(part_at(found[0], halves, {1.001, 0.99, 0.5}), 1) << "the cut is nearer than the wall, but no surface";
}

// An L of an arm, 3 by 1, and a leg, 1 by 4. The arm goes on into the corner for 3/4 of its breadth; the leg, whose
// wall is longer than the arm is wide, stays.
TEST(Overlap, TheArmOfAnLGoesIntoTheCorner) {
    const std::vector<ConvexSolid> pieces{box({0, 0, 0}, {3, 1, 1}, 0), box({3, 0, 0}, {4, 1, 4}, 1)};
    const std::vector<ConvexSolid> found = overlapping(pieces);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].volume(), 3.75, 1e-6);
    EXPECT_NEAR(found[1].volume(), 4, 1e-9);
    EXPECT_TRUE(holds(found[0], {3.7, 0.5, 0.9}));
    for (const ConvexSolid& one : found) {
        EXPECT_FALSE(holds(one, {2.9, 0.5, 1.1})) << "outside the L";
        EXPECT_FALSE(holds(one, {4.01, 0.5, 0.5}));
    }
    EXPECT_EQ(part_at(found[0], pieces, {1, 0.5, 1}), 0);
    EXPECT_EQ(part_at(found[0], pieces, {3.5, 0.5, 0}), 1) << "the end of the leg";
    EXPECT_EQ(part_at(found[1], pieces, {3, 0.5, 2}), 1);
}

TEST(Overlap, FacesKeepTheirParts) {
    std::vector<ConvexSolid> pieces{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1}, 1)};
    const auto face = [&](std::size_t piece, const Vec3& normal) {
        const std::vector<Plane>& planes = std::get<Polyhedron>(pieces[piece].form).planes;
        std::size_t k = 0;
        while (planes[k].normal.dot(normal) < 0.9) ++k;
        return k;
    };
    for (ConvexSolid& one : pieces) one.face_parts.assign(6, one.part);
    pieces[0].face_parts[face(0, -Vec3::UnitX())] = 2;
    pieces[1].face_parts[face(1, Vec3::UnitX())] = 3;
    pieces[1].face_parts[face(1, Vec3::UnitY())] = 4;
    const std::vector<ConvexSolid> found = overlapping(pieces);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].part_at({-0.1, 0.5, 0.5}), 2);
    EXPECT_EQ(found[0].part_at({3.1, 0.5, 0.5}), 3);
    EXPECT_EQ(found[0].part_at({0.5, 1.1, 0.5}), 0);
    EXPECT_EQ(part_at(found[0], pieces, {2, 1.1, 0.5}), 4);
}

// Corners as STL rounds them, turned, so that planes of neighbours are not quite the same.
TEST(Overlap, StandsSinglePrecision) {
    std::vector<ConvexSolid> pieces;
    for (const ConvexSolid& one :
         {box({0, 0, 0}, {30, 8, 20}), box({30, 0, 0}, {100, 8, 20}), box({100, 0, 0}, {120, 8, 20})}) {
        std::vector<Vec3> corners;
        for (const Vec3& corner : std::get<Polyhedron>(one.form).corners) {
            Vec3 turned(0.8 * corner.x() - 0.6 * corner.z(), corner.y() + 0.1, 0.6 * corner.x() + 0.8 * corner.z());
            for (double& value : turned) value = static_cast<double>(static_cast<float>(value));
            corners.push_back(turned);
        }
        pieces.push_back(solid_of(corners));
    }
    const std::vector<ConvexSolid> found = overlapping(pieces);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].volume(), 120 * 8 * 20, 0.1);
}

TEST(Overlap, PiecesApartAndFrustaStay) {
    const std::vector<ConvexSolid> apart{box({0, 0, 0}, {1, 1, 1}), box({2, 0, 0}, {3, 1, 1})};
    EXPECT_EQ(overlapping(apart), apart);
    const std::vector<ConvexSolid> legs{Frustum{-1, 1, 1, 1}, {Frustum{-1, 1, 1, 1}, {5, 0, 0}}};
    EXPECT_EQ(overlapping(legs), legs);
}

}  // namespace overlap_test
}  // namespace floes
