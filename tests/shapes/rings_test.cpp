// Rings that were traced: what is none, and with fewer corners.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shapes/polygon.hpp"

namespace floes {
namespace rings_test {

using testing::HasSubstr;
using testing::Optional;

Outline regular(int corners, double radius) {
    Outline polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        polygon.push_back({3 + radius * std::cos(angle), radius * std::sin(angle) - 7});
    }
    return polygon;
}

TEST(Rings, MayBendInwardsInEitherDirection) {
    const Outline ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    EXPECT_EQ(ring_fault_of(ell), std::nullopt);
    EXPECT_EQ(ring_fault_of(Outline(ell.rbegin(), ell.rend())), std::nullopt);
}

TEST(Rings, AreRefusedWhereTheyMeetThemselves) {
    const Outline bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    EXPECT_THAT(ring_fault_of(bow), Optional(HasSubstr("its edges from corners 1 and 3 meet")));
    const Outline bow_by_corner{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}};
    EXPECT_THAT(ring_fault_of(bow_by_corner), Optional(HasSubstr("crosses or touches itself")));
    const Outline spike{{0, 0}, {4, 0}, {3, 0}, {3, 2}, {0, 2}};
    EXPECT_THAT(ring_fault_of(spike), Optional(HasSubstr("crosses or touches itself")));
    const Outline corner_on_edge{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}};
    EXPECT_THAT(ring_fault_of(corner_on_edge), Optional(HasSubstr("crosses or touches itself")));
}

TEST(Rings, AreRefusedWithoutAnArea) {
    EXPECT_THAT(ring_fault_of(Outline{{0, 0}, {1, 1}}), Optional(HasSubstr("it has 2 different corners")));
    EXPECT_EQ(ring_fault_of(Outline{{0, 0}, {1, 1}, {2, 2}}), "it has no area");
}

TEST(Rings, WithFewerCornersKeepTheirAreaAndMiddle) {
    for (const int corners : {17, 64, 500}) {
        const Outline many = regular(corners, 0.5);
        const Outline few = with_fewer_corners(many, 16);
        ASSERT_EQ(few.size(), 16u);
        EXPECT_NEAR(area_of(few), 0.5 * corners * 0.25 * std::sin(2 * std::numbers::pi / corners), 1e-12);
        EXPECT_EQ(fault_of(few), std::nullopt);
        EXPECT_NEAR(measures_of(few).centroid.x, 3, 0.01);
        EXPECT_NEAR(measures_of(few).centroid.z, -7, 0.01);
    }
    // Of 64 corners every fourth is left: a regular 16-gon of the same area has this radius.
    const double radius =
        0.5 * std::sqrt(64 * std::sin(2 * std::numbers::pi / 64) / (16 * std::sin(2 * std::numbers::pi / 16)));
    for (const Corner& one : with_fewer_corners(regular(64, 0.5), 16))
        EXPECT_NEAR(std::hypot(one.x - 3, one.z + 7), radius, 0.06 * radius);
}

TEST(Rings, WithFewCornersStay) {
    const Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_EQ(with_fewer_corners(square, 4), square);
    const Outline house{{0, 0}, {1, 0}, {1, 1}, {0.5, 1.001}, {0, 1}};
    const Outline without_roof = with_fewer_corners(house, 4);
    ASSERT_EQ(without_roof.size(), 4u);
    EXPECT_NEAR(size_of(without_roof).x, std::sqrt(1.0005), 1e-12);
}

}  // namespace rings_test
}  // namespace floes
