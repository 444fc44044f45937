// A rectangle cut into squares: places, edges and joints.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "shapes/elements.hpp"

namespace floes {
namespace squares_test {

void expect_at(const Corner& found, const Corner& expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-15);
    EXPECT_NEAR(found.z, expected.z, 1e-15);
}

TEST(Squares, LieAboutTheMiddle) {
    const CutFloe floe = cut_into_squares(3, 2, 0.2);
    EXPECT_TRUE(floe.squares);
    expect_at(floe.elements[0].centre, {-0.2, -0.1});
    expect_at(floe.elements[5].centre, {0.2, 0.1});
    for (const CutElement& one : floe.elements) {
        const Measures measures = measures_of(one.corners);
        EXPECT_NEAR(measures.area, one.area, 1e-15);
        EXPECT_NEAR(measures.xx, one.xx, 1e-15);
        EXPECT_NEAR(measures.zz, one.zz, 1e-15);
        expect_at(measures.centroid, {0, 0});
    }
}

TEST(Squares, KnowTheRim) {
    const CutFloe floe = cut_into_squares(3, 2, 0.2);
    EXPECT_EQ(floe.elements[0].rim, unsigned{edge_minus_x | edge_minus_z});
    EXPECT_EQ(floe.elements[1].rim, unsigned{edge_minus_z});
    EXPECT_EQ(floe.elements[5].rim, unsigned{edge_plus_x | edge_plus_z});
    EXPECT_EQ(cut_into_squares(1, 1, 0.2).elements[0].rim, unsigned{every_edge});
}

TEST(Squares, AreJoinedAtEveryCommonEdgeOnceFromTheMiddleOutwards) {
    const CutFloe floe = cut_into_squares(5, 4, 0.2);
    std::set<std::pair<int, int>> pairs;
    double last = 0;
    for (const CutJoint& joint : floe.joints) {
        const CutElement& a = floe.elements[static_cast<std::size_t>(joint.a)];
        const CutElement& b = floe.elements[static_cast<std::size_t>(joint.b)];
        expect_at(b.centre - a.centre, 0.2 * joint.normal);
        expect_at(joint.pivot, 0.5 * (a.centre + b.centre));
        EXPECT_TRUE(pairs.emplace(joint.a, joint.b).second);
        for (std::size_t k = 0; k < 4; ++k) {
            if ((joint.edge_a >> k & 1U) != 0) expect_at(outward(a.corners, k), joint.normal);
            if ((joint.edge_b >> k & 1U) != 0) expect_at(outward(b.corners, k), -1 * joint.normal);
        }
        const double ring = std::max(std::abs(joint.pivot.x), std::abs(joint.pivot.z));
        EXPECT_GE(ring, last - 1e-12);
        last = ring;
    }
    EXPECT_EQ(pairs.size(), 4u * 4u + 5u * 3u);
}

TEST(TurnedTo, LooksAlongItsAxis) {
    EXPECT_TRUE((turned_to({1, 0}) * Vec3::UnitX()).isApprox(Vec3::UnitX()));
    EXPECT_TRUE((turned_to({0, 1}) * Vec3::UnitX()).isApprox(Vec3::UnitZ()));
    EXPECT_TRUE((turned_to({0, 1}) * Vec3::UnitY()).isApprox(Vec3::UnitY()));
    EXPECT_TRUE((turned_to({-0.6, 0.8}) * Vec3::UnitX()).isApprox(Vec3(-0.6, 0, 0.8)));
}

}  // namespace squares_test
}  // namespace floes
