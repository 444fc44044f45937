// The stress below contacts on elements that are no squares, by closed form; first_crack_test.cpp has that on squares.

#include "ice/stress_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "beam_sheet.hpp"
#include "ice/joint_stress.hpp"
#include "theory/plate.hpp"

namespace floes::test {
namespace prism_stress_test {

constexpr double side = 0.2;
constexpr double load = 10;
const double contact = felt_radius(std::sqrt(load / (std::numbers::pi * crushing)), thickness);
const double edge = edge_stress_per_decade(load, thickness, poisson);

Corner direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

/// A joint of a square on the face with this outward normal.
ElementJoint face(const Corner& outward, unsigned edge_bit) {
    return {outward, side / 2 * outward, side, side, thickness, edge_bit};
}

/// The largest tension that the contact alone makes at any of the joints, Pa.
double largest(const PressedElement& element, const Press& press) {
    double most = 0;
    for (std::size_t k = 0; k < element.joints.size(); ++k) {
        JointLoad at;
        at.sagging = contact_stress(element, press, k).value_or(LocalStress{});
        most = std::max(most, fibre_tension(at, {side, thickness, poisson, strength, strength}).stress);
    }
    return most;
}

PressedElement element_of(const Outline& corners) {
    return {.corners = corners, .area = side * side, .poisson_ratio = poisson, .crushing_pressure = crushing};
}

/// What of a square lies beyond a line at this angle through its middle, joined towards -x and z.
PressedElement clipped_square(double degrees) {
    const Corner along = direction(degrees);
    const Outline whole{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
    PressedElement prism = element_of(clipped(whole, {{along.z, -along.x}, 0}));
    prism.area = side * side / 4;  // so that what it feels ends before its corners
    for (const Corner& normal : {Corner{-1, 0}, Corner{0, 1}})
        for (unsigned k = 0; k < prism.corners.size(); ++k)
            if (dot(outward(prism.corners, k), normal) > 1 - 1e-9) prism.joints.push_back(face(normal, 1U << k));
    return prism;
}

/// The stress along a rim is the same whichever way joints point: its principal tension is that of the logarithm.
TEST(PrismStress, AlongAnObliqueRimIsTheLogarithmOfAnEdge) {
    for (const double degrees : {50.0, 60.0, 75.0}) {
        const PressedElement prism = clipped_square(degrees);
        ASSERT_EQ(prism.joints.size(), 2U);
        const Corner along = direction(degrees);
        const LocalStress added = contact_stress(prism, {0, 0, load}, 1).value();
        const double expected = edge * std::log10(cell_patch.at_edge.share * side / 2 / contact);
        EXPECT_NEAR(added.along, expected * along.z * along.z, 1e-6 * expected) << degrees;
        EXPECT_NEAR(added.across, expected * along.x * along.x, 1e-6 * expected) << degrees;
        EXPECT_NEAR(std::abs(added.shear), expected * along.x * along.z, 1e-6 * expected) << degrees;
        EXPECT_NEAR(largest(prism, {0, 0, load}), expected, 1e-6 * expected) << degrees;
    }
}

/// A hexagon's corner turns by 60 degrees: past it the logarithm goes on with √½ of its slope.
TEST(PrismStress, AtTheCornerOfAHexagonGoesOnByTheAngle) {
    const double half = side / 2;
    Outline hexagon;
    for (int k = 0; k < 6; ++k) hexagon.push_back(side * direction(60 * k - 120));
    PressedElement prism = element_of(hexagon);
    prism.joints.push_back({{1, 0}, {1.5 * side, 0}, side, 2 * side, thickness, 0});  // no nearer than half a span
    const double top = side * std::sqrt(3.0) / 2;
    const double away = 0.02;
    const double felt = cell_patch.at_edge.share * side;
    ASSERT_GT(felt, away);
    const double beyond = std::sqrt(0.5) * std::log10(felt / away);
    EXPECT_NEAR(contact_stress(prism, {half - away, top, load}, 0).value().along /
                    (edge * (std::log10(away / contact) + beyond)),
                1, 1e-9);
    // At the corner itself all of it is past the corner, at a corner that is nearly straight nothing is lost.
    EXPECT_NEAR(contact_stress(prism, {half - 1e-12, top, load}, 0).value().along /
                    (edge * std::sqrt(0.5) * std::log10(felt / contact)),
                1, 1e-6);
    prism.corners = {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.099}, {0.1, 0.1}, {-0.2, 0.1}};
    prism.joints = {{{1, 0}, {0.2, 0}, 0.2, 0.2, thickness, 1U << 1}};
    EXPECT_NEAR(contact_stress(prism, {0.1 - 1e-9, 0.1, load}, 0).value().along /
                    (edge * std::log10(cell_patch.at_edge.radius(0.2, 0, 0.2) / contact)),
                1, 1e-3);
}

/// Cells meet at corners that may be edges too short for a joint. Ice goes on beyond one of them until a joint beside
/// it breaks, which frees both.
TEST(PrismStress, AnEdgeTooShortForAJointIsNoRim) {
    const double cut = least_joint(side) / std::numbers::sqrt2 - 1e-6;
    PressedElement prism = element_of({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1 - cut}, {0.1 - cut, 0.1}, {-0.1, 0.1}});
    prism.least_joint = least_joint(side);
    for (const Corner& normal : {Corner{0, -1}, Corner{1, 0}, Corner{0, 1}, Corner{-1, 0}})
        for (unsigned k = 0; k < prism.corners.size(); ++k)
            if (dot(outward(prism.corners, k), normal) > 1 - 1e-9) prism.joints.push_back(face(normal, 1U << k));
    ASSERT_EQ(prism.joints.size(), 4U);
    const Press press{0.085, 0.08, load};
    const double interior = interior_stress_per_decade(load, thickness, poisson);
    const double felt = cell_patch.inside.radius(side, side / 2 - 0.015, side);
    const LocalStress inside = contact_stress(prism, press, 1).value();
    EXPECT_NEAR(inside.along, interior * std::log10(felt / contact), 1e-6 * inside.along);
    EXPECT_EQ(inside.shear, 0);
    PressedElement larger = prism;
    larger.corners[2].z -= 1e-5;
    EXPECT_NE(contact_stress(larger, press, 1).value().shear, 0) << "an edge that could have a joint and has none";
    prism.joints[2].live = false;
    EXPECT_NE(contact_stress(prism, press, 1).value().along, inside.along);
}

TEST(PrismStress, IsNeverMoreThanItsBound) {
    std::mt19937_64 random(37);
    std::uniform_real_distribution<double> place(-0.1, 0.1);
    std::uniform_real_distribution<double> angle(0, 90);
    std::uniform_real_distribution<double> share(0.2, 1.5);
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
        PressedElement prism = clipped_square(angle(random));
        for (ElementJoint& joint : prism.joints)
            joint.length *= share(random), joint.span *= share(random), joint.thickness *= share(random);
        const double down = i % 2 == 0 ? 3.0 : -3.0;
        const double bound = most_contact_stress(prism) * 3.0;
        const Press press{place(random), place(random), down};
        for (std::size_t k = 0; k < prism.joints.size(); ++k) {
            const LocalStress added = contact_stress(prism, press, k).value_or(LocalStress{});
            for (const double stress : {added.along, added.across}) {
                EXPECT_LE(std::abs(stress) + std::abs(added.shear), bound);
                most = std::max(most, (std::abs(stress) + std::abs(added.shear)) / bound);
            }
        }
    }
    EXPECT_GT(most, 0.5) << "a bound that is of use";
}

}  // namespace prism_stress_test
}  // namespace floes::test
