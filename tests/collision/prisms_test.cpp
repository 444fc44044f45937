// Prisms against prisms: as boxes where they are boxes, and by what a least overlap is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "collision/overlap.hpp"
#include "collision/random_boxes.hpp"

namespace floes {
namespace prisms_test {

using test::Dice;
using test::regular;

struct Placed {
    PrismShape shape;
    BodyMotion motion{};

    PrismPlace prism() const { return {&shape, motion.position, motion.rotation}; }
};

void put(Placed& one, Dice& dice, double tilt) {
    const btTransform pose =
        test::moved(test::moved(btTransform::getIdentity(), dice.vector(0.12), {0, dice.between(-3, 3), 0}), {0, 0, 0},
                    dice.vector(tilt));
    one.motion = test::motion_of(pose);
    one.motion.position[1] *= 0.2;
}

double deepest(const Overlap& overlap) {
    double depth = 0;
    for (int i = 0; i < overlap.count; ++i) depth = std::max(depth, overlap.points[static_cast<std::size_t>(i)].depth);
    return depth;
}

TEST(Prisms, OfFourCornersOverlapAsBoxes) {
    Dice dice(4);
    int touching = 0;
    int alike = 0;
    for (int i = 0; i < 4000; ++i) {
        Placed a{PrismShape(corners_of(0.1, 0.1), 0.0165)};
        Placed b{PrismShape(corners_of(0.1, 0.06), 0.02)};
        put(a, dice, 0.4);
        put(b, dice, 0.4);
        Overlap boxes;
        Overlap prisms;
        find_overlap(a.prism(), b.prism(), boxes);
        a.shape = PrismShape({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}, 0.0165);
        b.shape = PrismShape({{-0.1, -0.06}, {0.1, -0.06}, {0.1, 0.06}, {-0.1, 0.06}}, 0.02);
        ASSERT_FALSE(a.shape.is_box) << "its corners begin elsewhere: by the way of any prism";
        find_overlap(a.prism(), b.prism(), prisms);
        ASSERT_EQ(boxes.count > 0, prisms.count > 0);
        if (boxes.count == 0) continue;
        ++touching;
        // Edges have to be better than what was found before by a factor, so the order in which they come may show; and
        // Bullet makes boxes a little larger against edges.
        if (std::abs(deepest(boxes) - deepest(prisms)) > 2e-5) continue;
        ++alike;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(boxes.normal[k], prisms.normal[k], 1e-9);
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(alike, 0.99 * touching);
}

/// Shifted apart by the depth along the normal, prisms touch no more; by a little less they do.
TEST(Prisms, PartWhereTheirOverlapEnds) {
    Dice dice(5);
    int touching = 0;
    for (int i = 0; i < 3000; ++i) {
        Placed a{PrismShape(regular(6, 0.12), 0.0165)};
        Placed b{PrismShape(regular(3 + i % 5, 0.1), 0.02)};
        const double tilt = i % 2 == 0 ? 0 : 0.5;
        put(a, dice, tilt);
        put(b, dice, tilt);
        Overlap found;
        find_overlap(a.prism(), b.prism(), found);
        if (found.count == 0) continue;
        ++touching;
        const double depth = deepest(found);
        const auto shifted_by = [&](double way) {
            Placed moved = b;
            for (std::size_t k = 0; k < 3; ++k) moved.motion.position[k] += way * found.normal[k];
            Overlap left;
            find_overlap(a.prism(), moved.prism(), left);
            return deepest(left);
        };
        EXPECT_LT(shifted_by(depth * (1 + 1e-9)), 1e-6);
        EXPECT_GT(shifted_by(0.9 * depth), 0.05 * depth);
        Overlap swapped;
        find_overlap(b.prism(), a.prism(), swapped);
        EXPECT_NEAR(deepest(swapped) / depth, 1, 0.06);  // as above
    }
    EXPECT_GT(touching, 700);
}

/// How far they are apart along an axis of any length other than 0, by all corners.
double gap_by_corners(const PrismPlace& a, const PrismPlace& b, const Triple& axis) {
    const auto reach = [&](const PrismPlace& prism, double sign) {
        double most = -1e9;
        for (const Corner& one : prism.shape->corners)
            for (const double y : {-1.0, 1.0})
                most =
                    std::max(most, sign * dot(axis, to_world(prism, {one.x, y * prism.shape->half_thickness, one.z})));
        return most;
    };
    return std::max(-reach(a, 1) - reach(b, -1), -reach(a, -1) - reach(b, 1)) / std::sqrt(dot(axis, axis));
}

std::vector<Triple> edges_of(const PrismPlace& prism) {
    std::vector<Triple> edges{out_of(prism, {0, 1, 0})};
    for (const auto& [n, half_width, middle] : prism.shape->edges) edges.push_back(out_of(prism, {-n.z, 0, n.x}));
    return edges;
}

/// Axes that cannot win are passed over; here all are tried, in the same order.
TEST(Prisms, OverlapAlongTheBestOfAllAxes) {
    Dice dice(7);
    int touching = 0;
    int by_edges = 0;
    for (int i = 0; i < 6000; ++i) {
        Placed a{PrismShape(regular(3 + i % 6, 0.12), 0.0165)};
        Placed b{PrismShape(regular(3 + i % 7, 0.1), i % 3 == 0 ? 0.1 : 0.02)};
        const double tilt = std::pow(10.0, -i % 4);
        put(a, dice, tilt);
        put(b, dice, tilt);
        const int count = face_axes(a.shape) + face_axes(b.shape);
        double best = -1e9;
        for (int axis = 0; axis < count; ++axis) best = std::max(best, face_gap(a.prism(), b.prism(), axis));
        EXPECT_EQ(widest_face_gap(a.prism(), b.prism(), 0, count).gap, best);
        Overlap found;
        find_overlap(a.prism(), b.prism(), found);
        if (best > 0) {
            EXPECT_EQ(found.count, 0);
            continue;
        }
        bool edges = false;
        for (const Triple& one : edges_of(a.prism())) {
            for (const Triple& other : edges_of(b.prism())) {
                const Triple axis = cross(one, other);
                if (dot(axis, axis) < 1e-8) continue;
                const double gap = gap_by_corners(a.prism(), b.prism(), axis);
                if (!(1.05 * gap > best)) continue;
                best = gap;
                edges = true;
            }
        }
        EXPECT_EQ(found.count > 0, best <= 0) << i;
        if (found.count == 0) continue;
        ++touching;
        by_edges += edges ? 1 : 0;
        EXPECT_NEAR(-gap_by_corners(a.prism(), b.prism(), found.normal), -best, 1e-9) << i;
    }
    EXPECT_GT(touching, 2000);
    EXPECT_GT(by_edges, 300);
    EXPECT_GT(touching - by_edges, 300);
}

TEST(Prisms, LieOnEachOtherAtFourPoints) {
    Placed a{PrismShape(regular(6, 0.12), 0.0165)};
    Placed b = a;
    a.motion = b.motion = test::motion_of(btTransform::getIdentity());
    b.motion.position[1] = 0.032;
    Overlap found;
    find_overlap(a.prism(), b.prism(), found);
    EXPECT_EQ(found.count, 4);
    EXPECT_NEAR(found.normal[1], 1, 1e-12);
    for (int i = 0; i < found.count; ++i) {
        EXPECT_NEAR(found.points[static_cast<std::size_t>(i)].depth, 0.001, 1e-12);
        EXPECT_NEAR(found.points[static_cast<std::size_t>(i)].on_b[1], 0.032 - 0.0165, 1e-12);
    }
}

TEST(Prisms, FacesTellHowFarTheyAreApart) {
    Placed a{PrismShape(regular(6, 0.1), 0.0165)};
    Placed b = a;
    a.motion = b.motion = test::motion_of(btTransform::getIdentity());
    b.motion.position[0] = 0.3;
    double widest = -1;
    for (int axis = 0; axis < face_axes(a.shape) + face_axes(b.shape); ++axis)
        widest = std::max(widest, face_gap(a.prism(), b.prism(), axis));
    EXPECT_NEAR(widest, 0.3 - 2 * 0.1 * std::sqrt(0.75), 1e-12);
}

TEST(PrismSection, OfAFlushFaceIsTheFace) {
    const PrismShape hexagon(regular(6, 0.1), 0.02);  // an edge faces +x
    const PrismSection at = PrismSections(hexagon, {-1, 0, 0}).at(1e-4);
    EXPECT_NEAR(at.area, 0.04 * (0.1 + 2 * 1e-4 / std::sqrt(3.0)), 1e-6);
    EXPECT_NEAR(at.growth, 0.04 * 2 / std::sqrt(3.0), 1e-4);
}

TEST(PrismSection, OfAVerticalEdgeGrowsWithTheDepth) {
    const PrismShape hexagon(regular(6, 0.1), 0.02);  // a corner faces +z; sides leave it at 60 degrees
    const double d = 0.01;
    const PrismSection at = PrismSections(hexagon, {0, 0, -1}).at(d);
    EXPECT_NEAR(at.area, 0.04 * 2 * d * std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(at.growth, 0.04 * 2 * std::sqrt(3.0), 1e-4);
}

/// From the first corner to the middle it sweeps half the volume, whatever the direction; and grows as it says.
TEST(PrismSection, SweepsHalfTheVolume) {
    const PrismShape hexagon(regular(6, 0.1), 0.02);
    const double volume = area_of(hexagon.corners) * 0.04;
    Dice dice(6);
    for (int i = 0; i < 20; ++i) {
        const btVector3 n = dice.vector(1).normalized();
        const Triple normal{n.x(), n.y(), n.z()};
        const PrismSections sections(hexagon, normal);
        double low = 0;
        for (const Corner& one : hexagon.corners) low = std::min(low, n.x() * one.x + n.z() * one.z);
        const double middle = -low + 0.02 * std::abs(n.y());
        constexpr int parts = 4000;
        double swept = 0;
        for (int k = 0; k < parts; ++k) swept += sections.at((k + 0.5) * middle / parts).area * middle / parts;
        EXPECT_NEAR(swept, volume / 2, 1e-4 * volume);
        const double d = 0.37 * middle;
        const double slope = (sections.at(d + 1e-7).area - sections.at(d - 1e-7).area) / 2e-7;
        EXPECT_NEAR(sections.at(d).growth, slope, 1e-3 * std::abs(slope) + 1e-6);
    }
}

TEST(PrismSection, OfAJustTouchingEdgeIsNothingYet) {
    const PrismShape hexagon(regular(6, 0.1), 0.02);
    const PrismSection at = PrismSections(hexagon, {0.6, 0.64, 0.48}).crushed(0);
    EXPECT_LT(at.area, 1e-7);
    EXPECT_GT(at.growth, 0);
}

TEST(PrismSection, KnowsTheEdgeThatADirectionLeavesBy) {
    const PrismShape hexagon(regular(6, 0.1), 0.02);
    for (int k = 0; k < 6; ++k) {
        const Corner& out = hexagon.edges[static_cast<std::size_t>(k)].normal;
        EXPECT_EQ(edge_towards(hexagon, {out.x, 0.2, out.z}), k);
    }
    EXPECT_EQ(edge_towards(hexagon, {0.1, -1, 0.1}), -1);
}

}  // namespace prisms_test
}  // namespace floes
