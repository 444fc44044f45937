// The separating-axis test against another algorithm: two polygons overlap if a corner of one lies inside the other or
// two of their sides cross. (Their common area is no alternative: rounding dominates it where they nearly touch.)

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "arrangement/crowd.hpp"
#include "core/random.hpp"
#include "core/vector.hpp"

namespace floes {
namespace overlap_test {

using Polygon = std::vector<Vec2>;

Polygon corners(const Rectangle& shape, double x, double z, double yaw) {
    // Corners go round so that the inside is on the left of every side in the (x, z) plane.
    const Vec2 along(std::cos(yaw), -std::sin(yaw));
    const Vec2 across(std::sin(yaw), std::cos(yaw));
    Polygon polygon;
    for (const auto& [a, b] : {std::array{1, 1}, std::array{-1, 1}, std::array{-1, -1}, std::array{1, -1}}) {
        polygon.push_back(Vec2(x, z) + a * shape.half_length * along + b * shape.half_breadth * across);
    }
    return polygon;
}

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Positive: c lies to the left of the line from a to b.
double side(const Vec2& a, const Vec2& b, const Vec2& c) {
    return cross(b - a, c - a);
}

bool contains(const Polygon& polygon, const Vec2& point) {
    for (std::size_t i = 0; i < 4; ++i) {
        if (side(polygon[i], polygon[(i + 1) % 4], point) <= 0) return false;
    }
    return true;
}

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool share_a_point(const Polygon& first, const Polygon& second) {
    for (std::size_t i = 0; i < 4; ++i) {
        if (contains(first, second[i]) || contains(second, first[i])) return true;
        for (std::size_t j = 0; j < 4; ++j) {
            if (cross_each_other(first[i], first[(i + 1) % 4], second[j], second[(j + 1) % 4])) return true;
        }
    }
    return false;
}

struct Pair {
    Rectangle shape;
    double yaw_first;
    double yaw_second;
    double dx;
    double dz;

    Rectangle other;

    bool overlaps() const { return overlap({shape, turn_of(yaw_first)}, {other, turn_of(yaw_second)}, dx, dz); }
    bool overlaps_by_corners_and_sides(double margin) const {
        return share_a_point(corners(shape.grown(margin), 0, 0, yaw_first),
                             corners(other.grown(margin), dx, dz, yaw_second));
    }
};

Pair random_pair(RandomStream& random) {
    Pair pair{{random.uniform(0.1, 1), random.uniform(0.1, 1)}, random.uniform(-4, 4), random.uniform(-4, 4), 0, 0,
              {random.uniform(0.1, 1), random.uniform(0.1, 1)}};
    if (random.below(3) == 0) pair.other = pair.shape;
    if (random.below(4) == 0) pair.yaw_second = pair.yaw_first + random.below(4) * std::numbers::pi / 2;  // parallel
    const double direction = random.uniform(0, 2 * std::numbers::pi);
    const double distance = random.uniform(0, 1.05) * (pair.shape.half_diagonal() + pair.other.half_diagonal());
    pair.dx = distance * std::cos(direction);
    pair.dz = distance * std::sin(direction);
    return pair;
}

// Brings the second rectangle along its direction to where it just touches the first, by bisection.
void bring_to_touch(Pair& pair) {
    const double length = std::hypot(pair.dx, pair.dz);
    if (length < 1e-6) return;
    const Vec2 direction(pair.dx / length, pair.dz / length);
    double low = 0, high = 2.1 * pair.shape.half_diagonal();
    for (int i = 0; i < 45; ++i) {
        const double middle = 0.5 * (low + high);
        pair.dx = middle * direction.x();
        pair.dz = middle * direction.y();
        (pair.overlaps_by_corners_and_sides(0) ? low : high) = middle;
    }
}

// Where the two algorithms disagree, the truth must lie within rounding: a hair's breadth more or less decides it.
struct Tally {
    int overlapping = 0, undecided = 0, disagreeing = 0;

    void add(const Pair& pair) {
        constexpr double hair = 1e-9;
        const bool grown = pair.overlaps_by_corners_and_sides(hair);
        const bool near_touching = grown != pair.overlaps_by_corners_and_sides(-hair);
        disagreeing += !near_touching && pair.overlaps() != grown;
        undecided += near_touching;
        overlapping += pair.overlaps();
    }
};

TEST(Overlap, AgreesWithCornersAndSidesOnAMillionRandomPairs) {
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    Tally tally;
    for (int i = 0; i < 1'000'000; ++i) tally.add(random_pair(random));
    EXPECT_EQ(tally.disagreeing, 0);
    EXPECT_LT(tally.undecided, 10);
    EXPECT_GT(tally.overlapping, 300'000);
    EXPECT_LT(tally.overlapping, 800'000);
}

TEST(Overlap, AgreesWithCornersAndSidesOnAHundredThousandPairsThatNearlyTouch) {
    RandomStream random(2, 0, StreamId::monte_carlo, 0);
    Tally tally;
    for (int i = 0; i < 100'000; ++i) {
        Pair pair = random_pair(random);
        bring_to_touch(pair);
        const double scale = 1 + random.uniform(-1e-6, 1e-6);
        pair.dx *= scale;
        pair.dz *= scale;
        tally.add(pair);
    }
    EXPECT_EQ(tally.disagreeing, 0);
    EXPECT_LT(tally.undecided, 5'000);
    EXPECT_GT(tally.overlapping, 40'000);
    EXPECT_LT(tally.overlapping, 60'000);
}

TEST(Overlap, TouchingIsNotOverlapping) {
    const Rectangle shape{1, 0.5};
    EXPECT_FALSE(overlap({shape, {}}, {shape, {}}, 2, 0));
    EXPECT_FALSE(overlap({shape, {}}, {shape, {}}, 0, 1));
    EXPECT_TRUE(overlap({shape, {}}, {shape, {}}, std::nextafter(2, 0), 0));
    EXPECT_TRUE(overlap({shape, {}}, {shape, {}}, 0, std::nextafter(1, 0)));
}

TEST(Turn, IsCosineAndSine) {
    RandomStream random(3, 0, StreamId::monte_carlo, 0);
    for (int i = 0; i < 100'000; ++i) {
        const double yaw = random.uniform(-6.5, 6.5);
        const Turn turn = turn_of(yaw);
        ASSERT_NEAR(turn.cos, std::cos(yaw), 3e-16) << yaw;
        ASSERT_NEAR(turn.sin, std::sin(yaw), 3e-16) << yaw;
    }
    EXPECT_EQ(turn_of(0).cos, 1);
    EXPECT_EQ(turn_of(0).sin, 0);
    for (const double yaw : {1e5, -1e5, 12345.6789}) {
        EXPECT_NEAR(turn_of(yaw).cos, std::cos(yaw), 1e-15);
        EXPECT_NEAR(turn_of(yaw).sin, std::sin(yaw), 1e-15);
    }
}

}  // namespace overlap_test
}  // namespace floes
