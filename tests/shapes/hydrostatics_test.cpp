// What hulls displace: boxes and cylinders by closed form, the OC3 spar by published values.

#include "shapes/hydrostatics.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/units.hpp"

namespace floes {
namespace hydrostatics_test {

constexpr double pi = std::numbers::pi;

Shape box(double length, double beam, double draught, double freeboard) {
    return {HullKind::barge,
            {.length = length,
             .beam = beam,
             .draught = draught,
             .freeboard = freeboard,
             .stem = 90 * unit::degree,
             .flare = 90 * unit::degree}};
}

TEST(Hydrostatics, OfABoxAreThoseOfItsSides) {
    const Hydrostatics found = hydrostatics(box(40, 20, 5, 3));
    EXPECT_NEAR(found.volume, 40 * 20 * 5, 1e-8);
    EXPECT_LT((found.buoyancy - Vec3(0, -2.5, 0)).norm(), 1e-10);
    EXPECT_NEAR(found.waterplane, 800, 1e-9);
    EXPECT_LT(found.flotation.norm(), 1e-10);
    EXPECT_NEAR(found.metacentric_radius(), 20 * 20 / (12.0 * 5), 1e-9);
    EXPECT_NEAR(found.longitudinal_metacentric_radius(), 40 * 40 / (12.0 * 5), 1e-9);
}

// Upright sides: about the waterline's middle the volume stays, and B moves by BM tan φ aside and BM tan² φ / 2 up.
TEST(Hydrostatics, OfAHeeledAndATrimmedBoxAreThoseOfWallSidedShips) {
    const Shape barge = box(40, 20, 5, 3);
    const double heel = std::tan(12 * unit::degree);
    const Hydrostatics heeled =
        hydrostatics(barge, {Vec3(0, std::cos(std::atan(heel)), -std::sin(std::atan(heel))), 0});
    const double roll = 20 * 20 / (12.0 * 5);
    EXPECT_NEAR(heeled.volume, 4000, 1e-8);
    EXPECT_LT((heeled.buoyancy - Vec3(0, -2.5 + roll * heel * heel / 2, roll * heel)).norm(), 1e-9);
    EXPECT_NEAR(heeled.waterplane, 800 * std::hypot(1, heel), 1e-9);
    EXPECT_NEAR(heeled.about_length, 40 * std::pow(20 * std::hypot(1, heel), 3) / 12, 1e-6);

    const double trim = std::tan(4 * unit::degree);
    const Hydrostatics trimmed =
        hydrostatics(barge, {Vec3(-std::sin(std::atan(trim)), std::cos(std::atan(trim)), 0), 0});
    const double pitch = 40 * 40 / (12.0 * 5);
    EXPECT_NEAR(trimmed.volume, 4000, 1e-8);
    EXPECT_LT((trimmed.buoyancy - Vec3(pitch * trim, -2.5 + pitch * trim * trim / 2, 0)).norm(), 1e-9);
    EXPECT_NEAR(trimmed.about_breadth, 20 * std::pow(40 * std::hypot(1, trim), 3) / 12, 1e-6);
}

// Deeper by the whole freeboard and more; out of the water; a wedge's waterplane is behind its middle.
TEST(Hydrostatics, KnowHullsUnderAndAboveTheWater) {
    const Shape barge = box(40, 20, 5, 3);
    EXPECT_NEAR(hydrostatics(barge, {Vec3::UnitY(), 4}).volume, 40 * 20 * 8, 1e-8);
    EXPECT_EQ(hydrostatics(barge, {Vec3::UnitY(), 4}).waterplane, 0);
    EXPECT_EQ(hydrostatics(barge, {Vec3::UnitY(), -6}).volume, 0);
    const Shape ship(HullKind::wedge_bow, {.length = 100,
                                           .beam = 20,
                                           .draught = 6,
                                           .freeboard = 4,
                                           .stem = 90 * unit::degree,
                                           .flare = 90 * unit::degree,
                                           .entrance = 45 * unit::degree});
    const Hydrostatics found = hydrostatics(ship);
    EXPECT_NEAR(found.waterplane, 90 * 20 + 100, 1e-7);
    // A rectangle from -50 to 40 m and a triangle with its centroid at 40 + 10/3 m.
    EXPECT_NEAR(found.flotation.x(), (1800 * -5.0 + 100 * (40 + 10.0 / 3)) / 1900, 1e-8);
    EXPECT_NEAR(found.buoyancy.x(), found.flotation.x(), 1e-8);
}

// OC3 Hywind: a cylinder of 9.4 m, a cone from -12 to -4 m, a cylinder of 6.5 m. Its 8029.21 m³, centre of buoyancy and
// C33 are in the files of the code comparison (IEA Wind Task 23), ρ g = 1025 x 9.80665.
TEST(Hydrostatics, OfTheOC3SparAreThePublishedOnes) {
    const Shape spar(std::vector<ProfilePoint>{{-120, 4.7}, {-12, 4.7}, {-4, 3.25}, {10, 3.25}});
    const Hydrostatics found = hydrostatics(spar);
    EXPECT_NEAR(found.volume, 8029.21, 0.005);
    EXPECT_NEAR(found.buoyancy.y(), -62.066, 0.0005);
    EXPECT_NEAR(1025 * 9.80665 * found.waterplane, 333550, 10);
    // C44 without weight, ρ g (I_T + ∇ z_B).
    EXPECT_NEAR(1025 * 9.80665 * (found.about_length + found.volume * found.buoyancy.y()), -5.00832e9, 1e5);
}

// The polygons that stand for circles have their area, so only second moments know of them.
TEST(Hydrostatics, OfRoundWallsAreThoseOfCircles) {
    const Hydrostatics cylinder =
        hydrostatics({HullKind::cylinder, {.diameter = 0.7, .draught = 0.63, .freeboard = 0.1}});
    EXPECT_NEAR(cylinder.volume, pi * 0.35 * 0.35 * 0.63, 1e-12);
    EXPECT_NEAR(cylinder.about_length, pi / 4 * std::pow(0.35, 4), 1e-5 * cylinder.about_length);
    // C44/ρg of WAMIT's example, -0.0645, by the same panels 1 % coarser: closed form -0.06459.
    EXPECT_NEAR(cylinder.about_length + cylinder.volume * cylinder.buoyancy.y(), -0.06459, 1e-5);
    const Hydrostatics heeled = hydrostatics({HullKind::cylinder, {.diameter = 0.7, .draught = 0.63, .freeboard = 0.3}},
                                             {Vec3(0, std::cos(0.2), std::sin(0.2)), 0});
    EXPECT_NEAR(heeled.volume, cylinder.volume, 1e-12);
    EXPECT_NEAR(heeled.waterplane, cylinder.waterplane / std::cos(0.2), 1e-9);
}

}  // namespace hydrostatics_test
}  // namespace floes
