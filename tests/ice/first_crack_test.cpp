// When the ice below a contact cracks: the grid's moments with the stress that contacts add, beside Westergaard's
// formulas, for elements of any size.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cut_lattice.hpp"
#include "ice/failure.hpp"
#include "ice/stress_field.hpp"
#include "support/plate_forms.hpp"

namespace floes::test {
namespace first_crack_test {

/// Stress by 1 N at (x, z) on an element in the middle of the rim of a half plate, or of a wide sheet, at the joint on
/// its +x face. `load`: N, decides the size of the contact.
class Sheet {
  public:
    Sheet(double element, bool at_edge)
        : half_(static_cast<int>(std::ceil(4 * plate.characteristic_length(modulus) / element))),
          side_(element),
          lattice_({modulus, poisson, thickness, 0},
                   cut_into_squares(2 * half_ + 1, at_edge ? half_ + 1 : 2 * half_ + 1, element), plate.foundation()),
          loaded_(half_ + (at_edge ? 0 : half_ * (2 * half_ + 1))) {
        std::vector<std::size_t> numbers;
        pressed_ = lattice_.prism(loaded_, crushing, numbers);
        on_pressed_ = static_cast<std::size_t>(
            std::ranges::find(pressed_.joints, edge_plus_x + 0U, &ElementJoint::edge) - pressed_.joints.begin());
        joint_ = numbers.at(on_pressed_);
    }

    double stress(double x, double z, double load) {
        const Corner middle = lattice_.cut().elements[static_cast<std::size_t>(loaded_)].centre;
        lattice_.press(loaded_, middle + Corner{x, z});
        JointLoad at = lattice_.load(joint_);
        const LocalStress added = contact_stress(pressed_, {x + 1e-9, z, load}, on_pressed_).value();
        at.sagging = {added.along / load, added.across / load, added.shear / load};
        return fibre_tension(at, section()).stress;
    }

    /// Load of the first crack, N, with a fracture energy, J/m².
    double first_crack(double energy) {
        double low = 0.1;
        double high = 200;
        for (int i = 0; i < 60; ++i) {
            const double load = (low + high) / 2;
            const double with = stress(0, -side_ / 2, load) * load / strength;
            const double smooth = fibre_tension(lattice_.load(joint_), section()).stress * load / strength;
            const double over = cracking(with, smooth, lattice_.stiffness(joint_),
                                         lattice_.turned(loaded_, loaded_ + 1) * load, energy * side_ * thickness);
            (over > 1 ? high : low) = load;
        }
        return high;
    }

  private:
    IceSection section() const { return {side_, thickness, poisson, strength, strength}; }

    int half_;
    double side_;
    CutLattice lattice_;
    int loaded_;
    PressedElement pressed_;
    std::size_t joint_;       // on its +x face
    std::size_t on_pressed_;  // likewise, by its number among the element's
};

double contact_radius(double load) {
    return felt_radius(std::sqrt(load / (std::numbers::pi * crushing)), thickness);
}

class Elements : public testing::TestWithParam<double> {};

TEST_P(Elements, HaveTheStressOfAnEdgeLoadWhereverItActsOnTheirRim) {
    Sheet rim(GetParam(), true);
    const double load = 10;
    const double expected = edge_load_stress(plate, modulus, 1, contact_radius(load));
    for (const double x : {0.0, 0.25, 0.49}) {
        EXPECT_NEAR(rim.stress(x * GetParam(), -GetParam() / 2, load) / expected, 1, 0.06) << x;
    }
}

TEST_P(Elements, HaveTheStressOfALoadFarFromEdges) {
    Sheet middle(GetParam(), false);
    const double load = 10;
    const double expected = interior_load_stress(plate, modulus, 1, contact_radius(load));
    for (const double x : {0.0, 0.25, 0.49}) {
        EXPECT_NEAR(middle.stress(x * GetParam(), 0, load) / expected, 1, 0.03) << x;
        EXPECT_NEAR(middle.stress(x * GetParam(), x * GetParam(), load) / expected, 1, 0.09) << x;
    }
}

/// By strength alone: the load at which the formula has the strength. The smallest contact, 0.325 T, gives 9.9 N.
TEST_P(Elements, CrackAtTheSameLoadByStrength) {
    double expected = 10;
    for (int i = 0; i < 20; ++i) expected = strength / edge_load_stress(plate, modulus, 1, contact_radius(expected));
    EXPECT_NEAR(strength / edge_load_stress(plate, modulus, 1, 0.325 * thickness), 9.9, 0.05);
    EXPECT_NEAR(expected, 10.1, 0.1);
    EXPECT_NEAR(Sheet(GetParam(), true).first_crack(0) / expected, 1, 0.06);
}

/// With an energy to pay the crack waits, whatever the elements, for what the ice around gives. Tough ice cracks where
/// the grid itself reaches the strength.
TEST_P(Elements, CrackAtTheSameLoadByEnergy) {
    if (GetParam() == 0.1) return;  // which the others are compared with
    const double expected = Sheet(0.1, true).first_crack(0.5);
    EXPECT_NEAR(expected, 11.5, 0.1) << "the strength alone has 10.1 N";
    EXPECT_NEAR(Sheet(GetParam(), true).first_crack(0.5) / expected, 1, GetParam() > 0.2 ? 0.3 : 0.12);
}

INSTANTIATE_TEST_SUITE_P(Ice, Elements, testing::Values(0.3, 0.2, 0.15, 0.1, 0.05));

TEST(ContactStress, EndsAtACornerAndTurnsWithTheLoad) {
    PressedElement corner{corners_of(0.1, 0.1), 0.04, square_patch, poisson, crushing};
    for (const auto& [outward, edge] : {std::pair(Corner{-1, 0}, edge_minus_x), {Corner{0, 1}, edge_plus_z}})
        corner.joints.push_back({outward, 0.1 * outward, 0.2, 0.2, thickness, edge});
    const auto along = [&](const Press& press) { return contact_stress(corner, press, 0).value().along; };
    EXPECT_EQ(along({0.1, -0.1, 10}), 0) << "the moment of a quarter plate below its load is finite";
    const double beside = along({0.05, -0.1, 10});
    EXPECT_GT(beside, 0);
    EXPECT_EQ(contact_stress(corner, {0.05, -0.1, 10}, 0)->across, 0) << "nothing bends across a free edge";
    corner.joints.push_back({{1, 0}, {0.1, 0}, 0.2, 0.2, thickness, edge_plus_x});
    EXPECT_EQ(contact_stress(corner, {0.05, -0.1, 10}, 0), std::nullopt) << "the other one is nearer";
    EXPECT_GT(contact_stress(corner, {0.05, -0.1, 10}, 2)->along, beside) << "and the corner is gone";
    EXPECT_EQ(along({-0.05, -0.1, -10}), -along({-0.05, -0.1, 10}));
}

}  // namespace first_crack_test
}  // namespace floes::test
