#include "shapes/elements.hpp"

#include <gtest/gtest.h>

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

TEST(Elements, OfARectangleAreSquares) {
    const CutFloe floe = cut_into_elements(Outline{{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}}, 0.2);
    ASSERT_EQ(floe.elements.size(), 6u);
    for (const CutElement& one : floe.elements) {
        EXPECT_NEAR(one.area, 0.04, 1e-15);
        EXPECT_NEAR(one.xx, std::pow(0.2, 4) / 12, 1e-15);
        EXPECT_EQ(one.corners.size(), 4u);
    }
    ASSERT_EQ(floe.joints.size(), 7u);
    for (const CutJoint& one : floe.joints) {
        EXPECT_NEAR(one.length, 0.2, 1e-14);
        EXPECT_NEAR(one.span, 0.2, 1e-14);
    }
    EXPECT_NEAR(floe.elements[0].centre.x, -0.2, 1e-15);
    EXPECT_NEAR(floe.elements[0].centre.z, -0.1, 1e-15);
}

TEST(Elements, KeepAreaCentreAndSecondMoments) {
    for (int number = 0; number < 60; ++number) {
        const Outline outline = polygon(number);
        const Measures whole = measures_of(outline);
        Measures sum;
        for (const CutElement& one : cut_into_elements(outline, 0.2).elements) {
            const double c = one.axis.x * one.axis.x;
            const double s = one.axis.z * one.axis.z;
            sum.area += one.area;
            sum.centroid = sum.centroid + one.area * one.centre;
            sum.xx += c * one.xx + s * one.zz + one.area * one.centre.x * one.centre.x;
            sum.zz += s * one.xx + c * one.zz + one.area * one.centre.z * one.centre.z;
        }
        EXPECT_NEAR(sum.area, whole.area, 1e-9);
        EXPECT_NEAR(sum.centroid.x, 0, 1e-9);
        EXPECT_NEAR(sum.centroid.z, 0, 1e-9);
        EXPECT_NEAR(sum.xx, whole.xx, 1e-9);
        EXPECT_NEAR(sum.zz, whole.zz, 1e-9);
    }
}

TEST(Elements, AreConvexLargeEnoughAndConnected) {
    for (int number = 0; number < 60; ++number) {
        const CutFloe floe = cut_into_elements(polygon(number), 0.2);
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
            EXPECT_GT(floe.elements[i].area, 0.1 * 0.04);
        }
    }
}

/// Every edge of an element lies on the rim or is shared with a neighbour, to its length.
TEST(Elements, EdgesAreRimOrJoint) {
    for (int number = 0; number < 60; ++number) {
        const CutFloe floe = cut_into_elements(polygon(number), 0.2);
        std::vector<double> held(floe.elements.size());
        for (const CutJoint& one : floe.joints) {
            held[static_cast<std::size_t>(one.a)] += one.length;
            held[static_cast<std::size_t>(one.b)] += one.length;
        }
        for (std::size_t i = 0; i < floe.elements.size(); ++i) {
            const CutElement& one = floe.elements[i];
            double inner = 0;
            for (std::size_t k = 0; k < one.corners.size(); ++k)
                if ((one.rim >> k & 1U) == 0) inner += edge_length(one.corners, k);
            EXPECT_NEAR(inner, held[i], 1e-5) << "polygon " << number << ", element " << i;
        }
    }
}

}  // namespace elements_test
}  // namespace floes
