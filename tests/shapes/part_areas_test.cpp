// Areas of parts against closed forms.

#include "shapes/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/barge.hpp"

namespace floes {
namespace part_areas_test {

constexpr double infinite = std::numeric_limits<double>::infinity();

void add_box(std::vector<std::vector<double>>& rows, int piece, int part, const Vec3& low, const Vec3& high) {
    for (const double x : {low.x(), high.x()})
        for (const double y : {low.y(), high.y()})
            for (const double z : {low.z(), high.z()})
                rows.push_back({static_cast<double>(piece), static_cast<double>(part), x, y, z});
}

/// Of boxes given by their corners, part k of box k.
Shape boxes(const std::vector<std::pair<Vec3, Vec3>>& corners) {
    Shape shape;
    shape.set_kind(HullKind::file);
    std::vector<std::vector<double>> rows;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        add_box(rows, static_cast<int>(k), static_cast<int>(k), corners[k].first, corners[k].second);
        shape.part_list() += (k == 0 ? "" : ",") + std::string(1, static_cast<char>('a' + k));
    }
    shape.set_pieces(rows);
    return shape;
}

// A side of 2 m by 1.5 m, a wall at 45° that is longer by √2, and no bottom within the heights.
TEST(PartAreas, OfABargeAreItsFaces) {
    const Shape barge = test::barge();
    const std::vector<double> strip = part_areas(barge, -0.9, 0.1);
    ASSERT_EQ(strip.size(), 5U);  // bow, stern, port, starboard, bottom and deck
    EXPECT_NEAR(strip[0], 20 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(strip[1], strip[0], 1e-6);
    EXPECT_NEAR(strip[2], 60 - 0.9 * 0.9 + 0.1 * 0.1, 1e-6);  // 60 m + 2 y at the height y
    EXPECT_NEAR(strip[3], strip[2], 1e-6);
    EXPECT_EQ(strip[4], 0);
    const std::vector<double> all = part_areas(barge, -infinite, infinite);
    EXPECT_NEAR(all[0], 20 * 7 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(all[2], 7 * (52 + 66) / 2.0, 1e-6);
    EXPECT_NEAR(all[4], 20 * 52 + 20 * 66, 1e-5);
}

TEST(PartAreas, OfLegsAreTheirWallsAndEnds) {
    HullSizes sizes;
    sizes.diameter = 4;
    sizes.spacing = 10;
    sizes.draught = 3;
    sizes.freeboard = 2;
    const Shape legs(HullKind::four_legs, sizes);
    for (const double area : part_areas(legs, -1, 0.5)) EXPECT_NEAR(area, std::numbers::pi * 4 * 1.5, 1e-9);
    for (const double area : part_areas(legs, -5, 0))
        EXPECT_NEAR(area, std::numbers::pi * 4 * 3 + std::numbers::pi * 4, 1e-9);
    EXPECT_EQ(part_areas(legs, 3, 4), std::vector<double>(4, 0.0));
}

// Two boxes side by side: the face at which they meet is of neither, whole where one is as large, else in part.
TEST(PartAreas, LeaveOutWhatLiesAgainstAnotherPiece) {
    const Shape halves = boxes({{{-1, -1, -1}, {0, 1, 1}}, {{0, -1, -1}, {1, 1, 1}}});
    for (const double area : part_areas(halves, -infinite, infinite)) EXPECT_NEAR(area, 8 + 4, 1e-9);
    const Shape step = boxes({{{-1, -1, -1}, {0, 1, 1}}, {{0, -1, -1}, {1, 0.5, 1}}});
    const std::vector<double> areas = part_areas(step, -infinite, infinite);
    EXPECT_NEAR(areas[0], 8 + 4 + 2 * 0.5, 1e-9);
    EXPECT_NEAR(areas[1], 2 * 2 + 2 * 1.5 + 2 * 1.5, 1e-9);
    EXPECT_NEAR(part_areas(step, -0.5, 0.75)[0], 1.25 * 2 + 2 * 1.25 + 2 * 0.25, 1e-9);
}

// A corner of one in the other: together they have the surface of the union, 2 x 24 less what of a cube of 1 m is
// inside.
TEST(PartAreas, LeaveOutWhatLiesInsideAnotherPiece) {
    const Shape both = boxes({{{-1, -1, -1}, {1, 1, 1}}, {{0, 0, 0}, {2, 2, 2}}});
    const std::vector<double> areas = part_areas(both, -infinite, infinite);
    EXPECT_NEAR(areas[0], 24 - 3, 1e-9);
    EXPECT_NEAR(areas[1], 24 - 3, 1e-9);
}

// Where both have the same surface it is that of the first, once.
TEST(PartAreas, CountASurfaceOnce) {
    const Shape both = boxes({{{-1, -1, -1}, {1, 1, 1}}, {{0, -1, -1}, {2, 1, 1}}});
    const std::vector<double> areas = part_areas(both, -infinite, infinite);
    EXPECT_NEAR(areas[0], 4 + 4 * 4, 1e-9);
    EXPECT_NEAR(areas[1], 4 + 4 * 2, 1e-9);
}

// Wedges of a ring have the wall of the polygon: 25 faces, whatever meets behind it.
TEST(PartAreas, OfWedgesAreTheirOuterFaces) {
    constexpr int sides = 25;
    Shape ring;
    ring.set_kind(HullKind::file);
    ring.part_list() = "fore,aft";
    std::vector<std::vector<double>> rows;
    for (int side = 0; side < sides; ++side) {
        const double part = side % 2;
        for (const double y : {-1.0, 0.5}) {
            rows.push_back({static_cast<double>(side), part, 0, y, 0});
            for (const int end : {side, side + 1}) {
                const double angle = 2 * std::numbers::pi * end / sides;
                rows.push_back({static_cast<double>(side), part, 3 * std::cos(angle), y, 3 * std::sin(angle)});
            }
        }
    }
    ring.set_pieces(rows);
    const std::vector<double> areas = part_areas(ring, -0.9, 0.1);
    const double face = 2 * 3 * std::sin(std::numbers::pi / sides);
    EXPECT_NEAR(areas[0], 13 * face, 1e-5);
    EXPECT_NEAR(areas[1], 12 * face, 1e-5);
}

TEST(PartAreas, OfABodyOfRevolutionAreNone) {
    EXPECT_TRUE(part_areas(Shape(), -1, 1).empty());
}

}  // namespace part_areas_test
}  // namespace floes
