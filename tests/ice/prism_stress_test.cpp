// The stress below contacts on elements that are no squares, by closed form; first_crack_test.cpp has that on squares.

#include "ice/stress_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
    return {outward, side / 2 * outward, side, side, edge_bit};
}

/// The largest tension that the contact alone makes at any of the joints, Pa.
double largest(const ContactStress& added) {
    double most = 0;
    for (const std::size_t axis : {0U, 1U}) {
        if (added.joint[axis] == ContactStress::none) continue;
        JointLoad at;
        at.sagging = {added.stress[axis], added.stress[1 - axis], axis == 0 ? added.shear : -added.shear};
        most = std::max(most, fibre_stress(at, {side, thickness, poisson, strength, strength}));
    }
    return most;
}

/// What of a square lies beyond a line at this angle through its middle, joined towards -x and z.
PressedElement clipped_square(double degrees) {
    const Corner along = direction(degrees);
    const Outline whole{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
    PressedElement prism{clipped(whole, {{along.z, -along.x}, 0}), thickness, poisson, crushing};
    for (const Corner& normal : {Corner{-1, 0}, Corner{0, 1}})
        for (unsigned k = 0; k < prism.corners.size(); ++k)
            if (dot(outward(prism.corners, k), normal) > 1 - 1e-9) prism.joints.push_back(face(normal, 1U << k));
    return prism;
}

/// The stress along a rim is the same whatever the grid: its principal tension is that of the logarithm.
TEST(PrismStress, AlongAnObliqueRimIsTheLogarithmOfAnEdge) {
    for (const double degrees : {50.0, 60.0, 75.0}) {
        const PressedElement prism = clipped_square(degrees);
        ASSERT_EQ(prism.joints.size(), 2U);
        const Corner along = direction(degrees);
        const ContactStress added = contact_stress(prism, {0, 0, load});
        const double felt = felt_at_edge.share * side / (along.x + along.z);
        const double expected = edge * std::log10(felt / contact);
        EXPECT_NEAR(added.stress[1], expected * along.z * along.z, 1e-6 * expected) << degrees;
        EXPECT_NEAR(std::abs(added.shear), expected * along.x * along.z, 1e-6 * expected) << degrees;
        EXPECT_NEAR(largest(added), expected, 1e-6 * expected) << degrees;
    }
}

/// A hexagon's corner turns by 60 degrees: past it the logarithm goes on with √½ of its slope.
TEST(PrismStress, AtTheCornerOfAHexagonGoesOnByTheAngle) {
    const double half = side / 2;
    PressedElement prism{{}, thickness, poisson, crushing};
    for (int k = 0; k < 6; ++k) prism.corners.push_back(side * direction(60 * k - 120));
    prism.joints.push_back({{1, 0}, {1.5 * side, 0}, side, 2 * side, 0});  // no nearer than half a span
    const double top = side * std::sqrt(3.0) / 2;
    const double away = 0.02;
    const ContactStress added = contact_stress(prism, {half - away, top, load});
    const double size = std::sqrt(0.5 * (side * side + 4 * side * side));
    const double felt = felt_at_edge.share * size;
    ASSERT_GT(felt, away);
    const double beyond = std::sqrt(0.5) * std::log10(felt / away);
    EXPECT_NEAR(added.stress[0] / (edge * (std::log10(away / contact) + beyond)), 1, 1e-9);
    // At the corner itself all of it is past the corner, at a corner that is nearly straight nothing is lost.
    EXPECT_NEAR(contact_stress(prism, {half - 1e-12, top, load}).stress[0] /
                    (edge * std::sqrt(0.5) * std::log10(felt / contact)),
                1, 1e-6);
    prism.corners = {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.099}, {0.1, 0.1}, {-0.2, 0.1}};
    prism.joints = {{{1, 0}, {0.2, 0}, 0.2, 0.2, 1U << 1}};
    EXPECT_NEAR(contact_stress(prism, {0.1 - 1e-9, 0.1, load}).stress[0] /
                    (edge * std::log10(felt_at_edge.radius(0.2, 0, 0.2) / contact)),
                1, 1e-3);
}

TEST(PrismStress, IsNeverMoreThanItsBound) {
    std::mt19937_64 random(37);
    std::uniform_real_distribution<double> place(-0.1, 0.1);
    std::uniform_real_distribution<double> angle(0, 90);
    std::uniform_real_distribution<double> share(0.2, 1.5);
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
        PressedElement prism = clipped_square(angle(random));
        for (ElementJoint& joint : prism.joints) joint.length *= share(random), joint.span *= share(random);
        const double down = i % 2 == 0 ? 3.0 : -3.0;
        const double bound = most_contact_stress(prism) * 3.0;
        const ContactStress added = contact_stress(prism, {place(random), place(random), down});
        for (const double stress : added.stress) {
            EXPECT_LE(std::abs(stress) + std::abs(added.shear), bound);
            most = std::max(most, (std::abs(stress) + std::abs(added.shear)) / bound);
        }
    }
    EXPECT_GT(most, 0.5) << "a bound that is of use";
}

}  // namespace prism_stress_test
}  // namespace floes::test
