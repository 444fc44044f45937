#include "water/floating_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace floes {
namespace floating_plate_test {

constexpr WaterBody fresh{.density = 1000, .gravity = 9.81, .in_plane = 0.1};
constexpr double draught = 0.93 * 0.033;

std::vector<Vec2> grid(int along, int broad, double side) {
    std::vector<Vec2> centres;
    for (int k = 0; k < broad; ++k) {
        for (int i = 0; i < along; ++i) centres.emplace_back(side * i + 7, side * k - 3);
    }
    return centres;
}

/// Added inertia of the whole, moving as one body about its middle.
struct Whole {
    double heave = 0, x = 0, z = 0, xx = 0, zz = 0, xz = 0, damping = 0;
};

Whole whole(const std::vector<Vec2>& centres, double side) {
    const std::vector<ElementWater> shares = water_of_piece(centres, side, draught, fresh);
    Vec2 middle = Vec2::Zero();
    for (const Vec2& centre : centres) middle += centre / static_cast<double>(centres.size());
    Whole sum;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const CarriedWater& one = shares[i].carried;
        const Vec2 r = centres[i] - middle;
        sum.heave += one.normal;
        sum.x += one.x + one.normal * r.x();
        sum.z += one.z + one.normal * r.y();
        sum.xx += one.xx + 2 * r.x() * one.x + one.normal * r.x() * r.x();
        sum.zz += one.zz + 2 * r.y() * one.z + one.normal * r.y() * r.y();
        sum.xz += one.xz + r.x() * one.z + r.y() * one.x + one.normal * r.x() * r.y();
        sum.damping += shares[i].damping;
    }
    return sum;
}

// Low and high frequency bound what a plate carries: a disc of the square's area below a rigid lid has
// (8/3) ρ a³ = 0.479 ρ L³ (Lamb, art. 102: a disc in unbounded water, both sides), a square at infinite frequency half
// of 0.579 (π/4) ρ L³ (DNV-RP-C205, table D-2), 0.227.
TEST(FloatingPlate, CarriesBetweenItsLimitsOfLowAndHighFrequency) {
    for (const double deep : {0.0, 0.05, 0.1, 0.3, 0.5}) {
        const double heave = plate_water(1, deep).added_mass;
        EXPECT_GT(heave, 0.579 * std::numbers::pi / 4 / 2);
        EXPECT_LT(heave, 0.4797);
    }
    EXPECT_LT(plate_water(1, 0).added_mass, plate_water(1, 0.1).added_mass);  // slower, so more
    EXPECT_LT(plate_water(1, 0.1).added_mass, plate_water(3, 0.1).added_mass);
}

// A heaving body makes waves at the cost of its damping (Haskind). At a long wave the plate is a point source, which
// the damping of short floes must approach: B = ρ ω K A²/2 for K L -> 0. Here at K L of some 3 it is smaller, and
// a fifth to a third of critical.
TEST(FloatingPlate, RadiatesAFifthToAThirdOfCriticalDamping) {
    for (const double deep : {0.0, 0.05, 0.1, 0.2}) {
        const PlateWater plate = plate_water(1, deep);
        const double mass = deep + plate.added_mass;  // over ρ b³
        const double ratio = plate.damping * plate.added_mass / (2 * std::sqrt(mass));
        EXPECT_GT(ratio, 0.15);
        EXPECT_LT(ratio, 0.33);
    }
}

TEST(FloatingPlate, HoldsTheEndsOfItsTable) {
    EXPECT_EQ(plate_water(50, 0.1).added_mass, plate_water(8, 0.1).added_mass);
    EXPECT_EQ(plate_water(1, 3).damping, plate_water(1, 0.5).damping);
    EXPECT_NEAR(plate_water(std::sqrt(6.0), 0.09).added_mass,
                0.25 * (plate_water(2, 0.06).added_mass + plate_water(2, 0.12).added_mass +
                        plate_water(3, 0.06).added_mass + plate_water(3, 0.12).added_mass),
                1e-12);
}

// The period of the tank's floe in heave: 2π √((m + M) / ρ g A), and with the stiffness ρ g A L²/12 in pitch.
TEST(FloatingPlate, GivesTheTankFloeItsPeriods) {
    const Whole floe = whole(grid(3, 3, 0.2), 0.2);
    const double mass = 1000 * 0.36 * draught;
    EXPECT_NEAR(floe.heave / mass, 5.35, 0.1);
    EXPECT_NEAR(2 * std::numbers::pi * std::sqrt((mass + floe.heave) / (9810 * 0.36)), 0.88, 0.01);
    const double inertia = mass * 0.36 / 12;
    EXPECT_NEAR(2 * std::numbers::pi * std::sqrt((inertia + floe.xx) / (9810 * 0.36 * 0.36 / 12)), 0.73, 0.01);
}

class Elements : public testing::TestWithParam<int> {};

// Whatever the elements: heave, roll and pitch of the whole, and nothing that couples them.
TEST_P(Elements, ShareOutWhatTheWholeHas) {
    const int n = GetParam();
    for (const auto& [along, broad] : {std::pair(1, 1), std::pair(3, 1), std::pair(1, 2), std::pair(3, 2)}) {
        const double side = 0.2 / n;
        const Whole sum = whole(grid(n * along, n * broad, side), side);
        const double b = 0.2 * std::min(along, broad);
        const double l = 0.2 * std::max(along, broad);
        const PlateWater plate = plate_water(l / b, draught / b);
        EXPECT_NEAR(sum.heave, plate.added_mass * 1000 * b * b * l, 1e-12);
        EXPECT_NEAR(sum.damping, plate.damping * std::sqrt(9.81 / b) * sum.heave, 1e-10);
        const auto [short_side, long_side] = along <= broad ? std::pair(sum.xx, sum.zz) : std::pair(sum.zz, sum.xx);
        EXPECT_NEAR(short_side, plate.gyration_across * b * b * sum.heave, 1e-12);
        const double most_along = std::min(plate.gyration_along, 1.0 / 12);  // an even load has no more
        EXPECT_NEAR(long_side, most_along * l * l * sum.heave, 1e-12);
        for (const double none : {sum.x, sum.z, sum.xz}) EXPECT_NEAR(none, 0, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(FloatingPlate, Elements, testing::Values(1, 2, 5));

TEST(FloatingPlate, OfAPieceThatDoesNotFillItsOutlineCarriesAsItsArea) {
    std::vector<Vec2> corner = grid(2, 2, 0.2);
    corner.pop_back();
    const double b = std::sqrt(0.12);
    EXPECT_NEAR(whole(corner, 0.2).heave, plate_water(1, draught / b).added_mass * 1000 * b * b * b, 1e-12);
}

// Beside neighbours an element carries more than alone, and in the middle more than at the rim.
TEST(FloatingPlate, CarriesMostInItsMiddle) {
    const std::vector<ElementWater> floe = water_of_piece(grid(3, 3, 0.2), 0.2, draught, fresh);
    const std::vector<ElementWater> alone = water_of_piece(grid(1, 1, 0.2), 0.2, draught, fresh);
    EXPECT_GT(floe[4].carried.normal, 1.3 * floe[1].carried.normal);
    EXPECT_GT(floe[1].carried.normal, 1.3 * floe[0].carried.normal);
    EXPECT_GT(floe[4].carried.normal, alone[0].carried.normal);
    EXPECT_EQ(alone[0].carried.in_plane, 0.1 * 1000 * 0.04 * draught);
    EXPECT_GT(floe[0].carried.x, 0);  // the corner at low x and z: its water lies towards the middle
    EXPECT_GT(floe[0].carried.z, 0);
}

}  // namespace floating_plate_test
}  // namespace floes
