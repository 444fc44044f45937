// Loads on cells, along rims at any angle, inside a sheet and at a corner, beside Westergaard's formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "cut_lattice.hpp"
#include "support/plate_forms.hpp"

namespace floes::test {
namespace prism_rim_test {

constexpr double load = 10;
const double contact = felt_radius(std::sqrt(load / (std::numbers::pi * crushing)), thickness);

Corner direction(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

/// Largest stress by 1 N at a point of a sheet, over `expected`, at the joints of the element there.
double stress_over(double expected, CutLattice& sheet, const Corner& point) {
    const int element = sheet.element_at(point);
    sheet.press(element, point);
    std::vector<std::size_t> numbers;
    const PressedElement pressed = sheet.prism(element, crushing, numbers);
    const Corner from = point - sheet.cut().elements[static_cast<std::size_t>(element)].centre;
    double most = 0;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::optional<LocalStress> added = contact_stress(pressed, {from.x, from.z, load}, k);
        if (!added) continue;
        JointLoad at = sheet.load(numbers[k]);
        at.sagging = {added->along / load, added->across / load, added->shear / load};
        const double length = sheet.cut().joints[numbers[k]].length;
        most = std::max(most, fibre_tension(at, {length, thickness, poisson, strength, strength}).stress);
    }
    return most / expected;
}

CutLattice lattice_of(const CutFloe& cut) {
    return {{modulus, poisson, thickness, 0}, cut, plate.foundation()};
}

struct Spread {
    double mean = 0, deviation = 0;
};
Spread spread_of(const std::vector<double>& values) {
    double sum = 0;
    double square = 0;
    for (const double one : values) {
        sum += one;
        square += one * one;
    }
    const double count = static_cast<double>(values.size());
    return {sum / count, std::sqrt(square / count - sum * sum / count / count)};
}

/// Half a plate whose rim is at this angle to x.
Outline half_plate(double degrees) {
    const double half = 3 * plate.characteristic_length(modulus);
    return from_axes(Outline{{-half, 0}, {half, 0}, {half, half}, {-half, half}}, {}, direction(degrees));
}

/// A rim at this angle.
class Rims : public testing::TestWithParam<double> {};

TEST_P(Rims, HaveTheStressOfWestergaardWithAnyElements) {
    const Corner along = direction(GetParam());
    const Corner inwards{-along.z, along.x};
    const double at_edge = edge_load_stress(plate, modulus, 1, contact);
    const double inside = interior_load_stress(plate, modulus, 1, contact);
    const double deep = 1.5 * plate.characteristic_length(modulus);
    for (const double element : {0.3, 0.2, 0.15, 0.1}) {
        std::vector<double> on_rim;
        std::vector<double> within;
        for (std::uint32_t pattern = 0; pattern < 5; ++pattern) {
            CutLattice lattice = lattice_of(cut_into_cells(half_plate(GetParam()), element, pattern));
            for (int i = 0; i < 20; ++i) {
                on_rim.push_back(stress_over(at_edge, lattice, (0.03 * i - 0.3) * along + 1e-6 * inwards));
                const double depth = deep + 0.2 * std::sin(1.7 * i);
                within.push_back(stress_over(inside, lattice, (0.04 * i - 0.4) * along + depth * inwards));
            }
        }
        EXPECT_NEAR(spread_of(on_rim).mean, 1, 0.05) << element;
        EXPECT_LT(spread_of(on_rim).deviation, 0.08) << element;
        EXPECT_NEAR(spread_of(within).mean, 1, 0.05) << element;
        EXPECT_LT(spread_of(within).deviation, 0.08) << element;
    }
}

INSTANTIATE_TEST_SUITE_P(Ice, Rims, testing::Values(0.0, 10.0, 22.5, 36.0, 45.0, 80.0));

/// At a corner that turns by 60 degrees the stress is a share of an edge's that does not know the elements.
TEST(Corners, OfAHexagonHaveTheSameStressWithAnyElements) {
    const double expected = edge_load_stress(plate, modulus, 1, contact);
    std::vector<double> found;
    for (const double element : {0.2, 0.1, 0.05}) {
        double sum = 0;
        for (const double degrees : {3.0, 17.0, 34.0, 52.0, 71.0}) {
            const Corner along = direction(degrees);
            const Outline sheet =
                from_axes(Outline{{0, 0}, {1.2, 0}, {1.2, 1.2}, {-0.6, 1.2}, {-0.6, 0.6 * std::sqrt(3.0)}}, {}, along);
            for (std::uint32_t pattern = 0; pattern < 4; ++pattern) {
                CutLattice lattice = lattice_of(cut_into_cells(sheet, element, pattern));
                sum += stress_over(expected, lattice, 0.002 * along + 1e-5 * Corner{-along.z, along.x}) / 20;
            }
        }
        found.push_back(sum);
    }
    EXPECT_NEAR(found[0] / found[1], 1, 0.12);
    EXPECT_NEAR(found[2] / found[1], 1, 0.12);
    EXPECT_LT(found[1], 0.85) << "less than on a straight rim";
}

/// What a crack sets free over what its joint holds, ½ K θ²: it turns as many times further when the joint is gone. In
/// the mean over the joints of a sheet, which point in every direction.
TEST(Cells, TurnFurtherByTheLengthOfTheirJointsOverTheSpan) {
    const CutFloe whole = cut_into_cells(half_plate(0), 0.15);
    CutLattice lattice = lattice_of(whole);
    std::vector<double> over;
    for (int i = 0; i < 12; ++i) {
        const Corner point{0.05 * i - 0.3, 1e-6};
        const int loaded = lattice.element_at(point);
        lattice.press(loaded, point);
        std::size_t joint = whole.joints.size();
        double most = 0;
        for (std::size_t k = 0; k < whole.joints.size(); ++k)
            if (whole.joints[k].a == loaded || whole.joints[k].b == loaded)
                if (const double bending = lattice.reaction(k).bending / whole.joints[k].length; bending > most)
                    most = bending, joint = k;
        const CutJoint& cracks = whole.joints[joint];
        CutFloe cut = whole;
        cut.joints.erase(cut.joints.begin() + static_cast<std::ptrdiff_t>(joint));
        CutLattice cracked = lattice_of(cut);
        cracked.press(loaded, point);
        const double further = cracked.turned(cracks.a, cracks.b) / lattice.turned(cracks.a, cracks.b);
        over.push_back(further / (1 + 2 * cracks.length / cracks.span));
    }
    EXPECT_NEAR(spread_of(over).mean, 1, 0.12);
}

}  // namespace prism_rim_test
}  // namespace floes::test
