// Loads on grids of rectangles, along rims that cross the grid and at a corner, beside Westergaard's formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cut_lattice.hpp"
#include "theory/plate.hpp"

namespace floes::test {
namespace prism_rim_test {

constexpr double load = 10;
const double contact = felt_radius(std::sqrt(load / (std::numbers::pi * crushing)), thickness);

Corner direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

/// Largest stress by 1 N at a point of a sheet, over `expected`, at the joints of the element there along these axes.
double stress_over(double expected, CutLattice& sheet, const Corner& point,
                   const std::vector<std::size_t>& axes = {0, 1}) {
    const int element = sheet.element_at(point);
    sheet.press(element, point);
    std::vector<std::size_t> numbers;
    const PressedElement pressed = sheet.prism(element, crushing, numbers);
    const Corner from = point - sheet.cut().elements[static_cast<std::size_t>(element)].centre;
    const ContactStress added = contact_stress(pressed, {from.x, from.z, load});
    double most = 0;
    for (const std::size_t axis : axes) {
        if (added.joint[axis] == ContactStress::none) continue;
        JointLoad at = sheet.load(numbers[added.joint[axis]]);
        at.sagging = {added.stress[axis] / load, added.stress[1 - axis] / load,
                      (axis == 0 ? added.shear : -added.shear) / load};
        const double length = sheet.cut().joints[numbers[added.joint[axis]]].length;
        most = std::max(most, fibre_stress(at, {length, thickness, poisson, strength, strength}));
    }
    return most / expected;
}

CutLattice lattice_of(const CutFloe& cut) {
    return {{modulus, poisson, thickness, 0}, cut, plate.foundation()};
}

/// A sheet of long x broad rectangles with the middle of its near rim, or of all, on the middle of an element.
CutLattice sheet_of(double along, double across, int columns, int rows, bool at_rim) {
    const double low = at_rim ? 0 : -0.5 * rows;
    CutFloe cut = cut_into_elements(
        Outline{{-0.5 * columns, low}, {0.5 * columns, low}, {0.5 * columns, low + rows}, {-0.5 * columns, low + rows}},
        1);
    const auto drawn = [&](const Corner& at) { return Corner{along * at.x, across * at.z}; };
    for (CutElement& one : cut.elements) {
        one.axis = {1, 0};  // of a square any
        one.corners = {
            {-along / 2, -across / 2}, {along / 2, -across / 2}, {along / 2, across / 2}, {-along / 2, across / 2}};
        one.centre = drawn(one.centre);
        one.area = along * across;
        one.xx = one.area * along * along / 12;
        one.zz = one.area * across * across / 12;
    }
    for (CutJoint& joint : cut.joints) {
        const bool along_x = joint.normal.x != 0;
        joint.pivot = drawn(joint.pivot);
        joint.span = along_x ? along : across;
        joint.length = along_x ? across : along;
    }
    return lattice_of(cut);
}

/// Rectangles of this span over length, of the area of a square of 0.1 m.
class Rectangles : public testing::TestWithParam<double> {};

TEST_P(Rectangles, HaveTheStressOfWestergaard) {
    const double along = 0.1 * std::sqrt(GetParam());
    const double across = 0.1 / std::sqrt(GetParam());
    const double reach = 4 * plate.characteristic_length(modulus);
    const auto columns = static_cast<int>(2 * std::ceil(reach / along) + 1);
    const auto rows = static_cast<int>(2 * std::ceil(reach / across) + 1);
    CutLattice rim = sheet_of(along, across, columns, rows / 2, true);
    CutLattice middle = sheet_of(along, across, columns, rows, false);
    const double at_edge = edge_load_stress(plate, modulus, 1, contact);
    const double inside = interior_load_stress(plate, modulus, 1, contact);
    const double within = GetParam() < 0.6 || GetParam() > 1.6 ? 0.09 : 0.06;
    for (const double x : {1e-6, 0.25, 0.49}) {
        EXPECT_NEAR(stress_over(at_edge, rim, {x * along, 1e-6}, {0}), 1, within) << x;
        EXPECT_NEAR(stress_over(inside, middle, {x * along, 1e-6}, {0}), 1, within) << x;
    }
}

/// What a crack at the rim sets free over what its joint holds: it turns as many times further when the joint is gone.
TEST_P(Rectangles, TurnFurtherByTheLengthOfTheirJointsOverTheSpan) {
    const double along = 0.1 * std::sqrt(GetParam());
    const double across = 0.1 / std::sqrt(GetParam());
    const double reach = 4 * plate.characteristic_length(modulus);
    CutLattice whole = sheet_of(along, across, static_cast<int>(2 * std::ceil(reach / along) + 1),
                                static_cast<int>(std::ceil(reach / across)), true);
    const Corner middle{0, 1e-6};
    const int loaded = whole.element_at(middle);
    whole.press(loaded, middle);
    CutFloe cut = whole.cut();
    const auto joint =
        std::ranges::find_if(cut.joints, [&](const CutJoint& one) { return one.a == loaded && one.b == loaded + 1; });
    ASSERT_NE(joint, cut.joints.end());
    cut.joints.erase(joint);
    CutLattice cracked = lattice_of(cut);
    cracked.press(loaded, middle);
    const double further = cracked.turned(loaded, loaded + 1) / whole.turned(loaded, loaded + 1);
    EXPECT_NEAR(further / (1 + 2 / GetParam()), 1, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Ice, Rectangles, testing::Values(0.5, 0.7, 1.0, 1.4, 2.0));

/// Loads along a rim at this angle to the grid, whose elements it clips in every way.
class Rims : public testing::TestWithParam<double> {};

TEST_P(Rims, HaveTheStressOfWestergaardOnAverage) {
    const Corner along = direction(GetParam());
    const double half = 4 * plate.characteristic_length(modulus);
    const Outline sheet = from_axes(Outline{{-half, 0}, {half, 0}, {half, half}, {-half, half}}, {}, along);
    const double expected = edge_load_stress(plate, modulus, 1, contact);
    for (const double element : {0.2, 0.15, 0.1}) {
        CutLattice lattice = lattice_of(cut_into_elements(sheet, element));
        double sum = 0;
        double square = 0;
        constexpr int places = 60;
        for (int i = 0; i < places; ++i) {
            const double ratio =
                stress_over(expected, lattice, (0.01 * i - 0.3) * along + 1e-6 * Corner{-along.z, along.x});
            sum += ratio;
            square += ratio * ratio;
        }
        EXPECT_NEAR(sum / places, 1, 0.1) << element;
        EXPECT_LT(std::sqrt(square / places - sum * sum / places / places), 0.12) << element;
    }
}

INSTANTIATE_TEST_SUITE_P(Ice, Rims, testing::Values(0.0, 10.0, 20.0, 30.0, 36.0, 45.0));

/// At a corner that turns by 60 degrees the stress is a share of an edge's that does not know the grid.
TEST(Corners, OfAHexagonHaveTheSameStressWithAnyElements) {
    const double expected = edge_load_stress(plate, modulus, 1, contact);
    std::vector<double> found;
    for (const double element : {0.2, 0.1, 0.05}) {
        double sum = 0;
        for (const double degrees : {3.0, 17.0, 34.0, 52.0, 71.0}) {
            const Corner along = direction(degrees);
            const Outline sheet = from_axes(Outline{{0, 0}, {2, 0}, {2, 2}, {-1, 2}, {-1, std::sqrt(3.0)}}, {}, along);
            CutLattice lattice = lattice_of(cut_into_elements(sheet, element));
            sum += stress_over(expected, lattice, 0.002 * along + 1e-5 * Corner{-along.z, along.x}) / 5;
        }
        found.push_back(sum);
    }
    EXPECT_NEAR(found[0] / found[1], 1, 0.12);
    EXPECT_NEAR(found[2] / found[1], 1, 0.12);
    EXPECT_LT(found[1], 0.8) << "less than on a straight rim";
}

}  // namespace prism_rim_test
}  // namespace floes::test
