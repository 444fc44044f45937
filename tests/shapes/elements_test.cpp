#include "shapes/elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/vector.hpp"
#include "shapes/drawn.hpp"

namespace floes {
namespace elements_test {

Outline polygon(int number) {
    RandomStream random(1, static_cast<std::uint32_t>(number), StreamId::polygons, 0);
    const Outline drawn = polygon_about(1.2, 0.8, 3 + number % 9, 0.9, random);
    return in_axes(drawn, {0, 0}, long_axis(measures_of(drawn)));
}

/// Outlines with bays: an L, a C, a star, and polygons of which every third corner is pushed in; about their centroids.
Outline with_bays(int number) {
    Outline ring;
    if (number == 0) ring = {{0, 0}, {1.2, 0}, {1.2, 0.4}, {0.5, 0.4}, {0.5, 1.1}, {0, 1.1}};
    if (number == 1)
        ring = {{0, 0}, {1.3, 0}, {1.3, 0.35}, {0.4, 0.35}, {0.4, 0.75}, {1.3, 0.75}, {1.3, 1.1}, {0, 1.1}};
    for (int k = 0; number == 2 && k < 12; ++k) {
        const double radius = k % 2 == 0 ? 0.8 : 0.45;
        ring.push_back({radius * std::cos(k * std::numbers::pi / 6), radius * std::sin(k * std::numbers::pi / 6)});
    }
    if (number > 2) {
        RandomStream random(1, static_cast<std::uint32_t>(number), StreamId::polygons, 1);
        ring = polygon_about(1.4, 1.0, 6 + number % 7, 0.6, random);
        for (std::size_t k = 0; k < ring.size(); k += 3) ring[k] = 0.5 * ring[k];
    }
    return in_axes(ring, measures_of(ring).centroid, {1, 0});
}

/// Convex ones, then ones with bays.
constexpr int polygons = 60;
Outline any_outline(int number) {
    return number < polygons ? polygon(number) : with_bays(number - polygons);
}
constexpr int all_outlines = 2 * polygons;

/// Of the corners of elements in the floe, without the outline's own, degrees.
double sharpest_corner(Corners outline, const CutFloe& floe) {
    double sharpest = 180;
    for (const CutElement& one : floe.elements)
        for (std::size_t k = 0; k < one.corners.size(); ++k) {
            const Corner at = one.centre + from_axes(one.corners, {}, one.axis)[k];
            const auto is_own = [&](const Corner& corner) { return dot(corner - at, corner - at) < 1e-12; };
            if (std::ranges::any_of(outline, is_own)) continue;
            const std::size_t before = k > 0 ? k - 1 : one.corners.size() - 1;
            const double turn = std::acos(dot(outward(one.corners, before), outward(one.corners, k)));
            sharpest = std::min(sharpest, 180 - turn * 180 / std::numbers::pi);
        }
    return sharpest;
}

/// As many as squares would be, of much the same area, and none is a triangle.
TEST(Elements, AreAlikeAndHaveNoSharpCorners) {
    for (const Outline& outline : {corners_of(0.3, 0.3), corners_of(0.5, 0.3), polygon(3), polygon(8)})
        for (std::uint32_t pattern = 0; pattern < 16; ++pattern) {
            const CutFloe floe = cut_into_cells(outline, 0.2, pattern);
            EXPECT_EQ(static_cast<long>(floe.elements.size()), std::lround(area_of(outline) / 0.04));
            EXPECT_GT(sharpest_corner(outline, floe), 60) << pattern;
            for (const CutElement& one : floe.elements) {
                EXPECT_GT(one.area, 0.55 * 0.04);
                EXPECT_LT(one.area, 1.6 * 0.04);
            }
        }
}

/// The share of stiffness along a direction, ∑ ℓ s n ⊗ n, is the same along all of them.
TEST(Elements, HaveNoDirection) {
    Measures sum;
    double by_four = 0;
    for (std::uint32_t pattern = 0; pattern < 32; ++pattern)
        for (const CutJoint& one : cut_into_cells(corners_of(0.3, 0.3), 0.2, pattern).joints) {
            const double weight = one.length * one.span;
            const double along = 2 * one.normal.x * one.normal.x - 1;  // cos 2φ
            sum.area += weight;
            sum.xx += weight * along;
            sum.xz += weight * 2 * one.normal.x * one.normal.z;
            by_four += weight * (2 * along * along - 1);
        }
    EXPECT_NEAR(sum.xx / sum.area, 0, 0.05);
    EXPECT_NEAR(sum.xz / sum.area, 0, 0.05);
    EXPECT_NEAR(by_four / sum.area, 0.2, 0.2) << "a grid along the sides has 1, one at 45 degrees -1";
}

TEST(Elements, AreAPureFunctionOfOutlineAndPattern) {
    const CutFloe one = cut_into_cells(polygon(4), 0.2, 7);
    const CutFloe other = cut_into_cells(polygon(4), 0.2, 7);
    const CutFloe third = cut_into_cells(polygon(4), 0.2, 8);
    ASSERT_EQ(one.elements.size(), third.elements.size());
    for (std::size_t i = 0; i < one.elements.size(); ++i) {
        EXPECT_EQ(one.elements[i].corners, other.elements[i].corners);
        EXPECT_NE(one.elements[i].corners, third.elements[i].corners);
    }
}

TEST(Elements, KeepAreaCentreAndSecondMoments) {
    for (int number = 0; number < all_outlines; ++number) {
        const Outline outline = any_outline(number);
        const Measures whole = measures_of(outline);
        Measures sum;
        for (const CutElement& one : cut_into_cells(outline, 0.2).elements) {
            const double c = one.axis.x * one.axis.x;
            const double s = one.axis.z * one.axis.z;
            sum.area += one.area;
            sum.centroid = sum.centroid + one.area * one.centre;
            sum.xx += c * one.xx + s * one.zz + one.area * one.centre.x * one.centre.x;
            sum.zz += s * one.xx + c * one.zz + one.area * one.centre.z * one.centre.z;
        }
        EXPECT_NEAR(sum.area, whole.area, 1e-8);
        EXPECT_NEAR(sum.centroid.x, 0, 1e-8);
        EXPECT_NEAR(sum.centroid.z, 0, 1e-8);
        EXPECT_NEAR(sum.xx, whole.xx, 1e-8);
        EXPECT_NEAR(sum.zz, whole.zz, 1e-8);
    }
}

TEST(Elements, AreConvexLargeEnoughAndConnected) {
    for (int number = 0; number < all_outlines; ++number) {
        const CutFloe floe = cut_into_cells(any_outline(number), 0.2);
        Components pieces(floe.elements.size());
        for (const CutJoint& one : floe.joints) {
            pieces.connect(static_cast<std::size_t>(one.a), static_cast<std::size_t>(one.b));
            EXPECT_GT(one.span, 0.02);
            EXPECT_NE(one.edge_a, 0u);
            EXPECT_NE(one.edge_b, 0u);
        }
        for (std::size_t i = 0; i < floe.elements.size(); ++i) {
            EXPECT_EQ(pieces.first(i), 0u);
            EXPECT_EQ(fault_of(floe.elements[i].corners), std::nullopt);
            EXPECT_GT(floe.elements[i].area, (number < polygons ? 0.4 : 0.03) * 0.04) << number;
        }
    }
}

/// Every edge of an element lies on the rim or is shared with a neighbour, to its length, unless it is very short.
TEST(Elements, EdgesAreRimOrJoint) {
    constexpr double shortest = 0.05 * 0.2;
    for (int number = 0; number < all_outlines; ++number) {
        const Outline outline = any_outline(number);
        const CutFloe floe = cut_into_cells(outline, 0.2);
        std::vector<double> held(floe.elements.size());
        double free = 0;
        for (std::size_t k = 0; k < outline.size(); ++k) free += edge_length(outline, k);
        double all = free;
        for (const CutJoint& one : floe.joints) {
            held[static_cast<std::size_t>(one.a)] += one.length;
            held[static_cast<std::size_t>(one.b)] += one.length;
            all += 2 * one.length;
        }
        double sum = 0;
        for (std::size_t i = 0; i < floe.elements.size(); ++i) {
            const CutElement& one = floe.elements[i];
            double inner = 0;
            for (std::size_t k = 0; k < one.corners.size(); ++k) {
                sum += edge_length(one.corners, k);
                if ((one.rim >> k & 1U) == 0) inner += edge_length(one.corners, k);
            }
            if (number >= polygons) continue;  // an edge in line with one of a bay may be both
            EXPECT_NEAR(inner, held[i], shortest * static_cast<double>(one.corners.size())) << number << ", " << i;
        }
        EXPECT_NEAR(sum, all, 0.02 * all) << "polygon " << number;
    }
}

/// The lines of all bays of a cell are many; it must not try them all.
TEST(Elements, OfACombInOneCellAreFoundAtOnce) {
    constexpr int teeth = 27;
    Outline ring{{0, 0}, {0.24, 0}};
    for (int k = teeth; k >= 0; --k) ring.push_back({0.24 * k / teeth, k % 2 == 0 ? 0.15 : 0.24});
    const Outline comb = in_axes(ring, measures_of(ring).centroid, {1, 0});
    double sum = 0;
    for (const CutElement& one : cut_into_cells(comb, 0.2).elements) sum += one.area;
    EXPECT_NEAR(sum, area_of(comb), 1e-9);
}

TEST(ConvexParts, MakeUpTheOutline) {
    for (int number = 0; number < polygons; ++number) {
        const Outline outline = with_bays(number);
        double sum = 0;
        for (const Outline& part : convex_parts(outline)) {
            EXPECT_EQ(fault_of(part), std::nullopt);
            sum += area_of(part);
        }
        EXPECT_NEAR(sum, area_of(outline), 1e-9) << number;
    }
    EXPECT_EQ(convex_parts(with_bays(0)).size(), 2u);
    EXPECT_EQ(convex_parts(with_bays(1)).size(), 3u);
    EXPECT_EQ(convex_parts(polygon(5)).size(), 1u);
}

TEST(ConvexParts, TellHowFarAFloeInABayIsFromIt) {
    const Outline c = with_bays(1);  // its bay is 0.4 m wide
    const Corner shift =
        Corner{0, 0} -
        measures_of(Outline{{0, 0}, {1.3, 0}, {1.3, 0.35}, {0.4, 0.35}, {0.4, 0.75}, {1.3, 0.75}, {1.3, 1.1}, {0, 1.1}})
            .centroid;
    Outline guest;
    for (const Corner& one : corners_of(0.2, 0.1)) guest.push_back(one + Corner{0.9, 0.55} + shift);
    EXPECT_NEAR(distance_between_outlines(c, guest), 0.1, 1e-12);
    for (Corner& one : guest) one.z += 0.15;
    EXPECT_LE(distance_between_outlines(c, guest), 0);
}

TEST(FewerCorners, OfARoughOutlineKeepItsAreaAndDoNotCross) {
    Outline rough;
    for (int k = 0; k < 300; ++k) {
        const double angle = 2 * std::numbers::pi * k / 300;
        const double radius = 1 + 0.3 * std::sin(3 * angle) + 0.02 * std::sin(40 * angle);
        rough.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const Outline fewer = with_fewer_corners(rough, most_bayed_corners);
    EXPECT_EQ(fewer.size(), most_bayed_corners);
    EXPECT_EQ(ring_fault_of(fewer), std::nullopt);
    EXPECT_NEAR(area_of(fewer), area_of(rough), 1e-9);
    EXPECT_FALSE(is_convex(fewer));
}

}  // namespace elements_test
}  // namespace floes
