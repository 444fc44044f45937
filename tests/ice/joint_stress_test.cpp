// The stress in the outer fibres at a joint, by hand.

#include "ice/joint_stress.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "ice/stress_field.hpp"

namespace floes {
namespace joint_stress_test {

constexpr IceSection section{0.2, 0.033, 0.3, 36.4e3, 30e3};
const double bending_strength = 0.2 * 0.033 * 0.033 / 6 * 36.4e3;  // N m
const double area = 0.2 * 0.033;

Thresholds no_others() {
    const double none = 1e9;
    return {none, none, none, none, none, none};
}

TEST(FibreStress, OfABeamIsThatOfItsMomentWithTheThrust) {
    EXPECT_NEAR(fibre_tension({{.bending = bending_strength}}, section).stress, 36.4e3, 1e-6);
    EXPECT_NEAR(fibre_tension({{.bending = -bending_strength}}, section).stress, 36.4e3, 1e-6)
        << "hogging pulls the upper one";
    EXPECT_NEAR(fibre_tension({{.axial = -area * 10e3, .bending = bending_strength}}, section).stress, 26.4e3, 1e-6);
    EXPECT_NEAR(fibre_tension({{.axial = area * 10e3}}, section).stress, 10e3, 1e-6);
}

TEST(FibreStress, OfATwistIsAtFortyFiveDegrees) {
    // A plate's twisting moment is 1 - ν of the grid's; its principal stress is as large.
    EXPECT_NEAR(fibre_tension({{.torsion = bending_strength}}, section).stress, 0.7 * 36.4e3, 1e-6);
}

TEST(FibreStress, BelongsToTheJointAlongWhichItPulls) {
    const JointLoad across{.reaction = {}, .across = bending_strength};
    EXPECT_NEAR(fibre_tension(across, section).stress, 0.3 * 36.4e3, 1e-6)
        << "the joints beside it crack, not this one";
    const JointLoad both{.reaction = {.bending = bending_strength}, .across = bending_strength};
    EXPECT_NEAR(fibre_tension(both, section).stress, 1.3 * 36.4e3, 1e-6) << "a bowl: D (1 + ν) κ";
}

TEST(FibreStress, OfACrackUnderFortyFiveDegreesIsThatAlongTheGrid) {
    // Cylindrical bending along the diagonal: curvature κ there, none across. The plate has D κ along the diagonal.
    const double moment = bending_strength;  // D κ L
    const JointLoad diagonal{.reaction = {.torsion = moment / 2, .bending = moment / 2}, .across = moment / 2};
    EXPECT_NEAR(fibre_tension(diagonal, section).stress, 36.4e3, 1e-6);
}

/// What any direction of the joint shows of one state: 30 kPa along x of bending, 4 along z, 6 of thrust along x and a
/// shear in the plane; the fibre's principal tension and its direction.
TEST(FibreStress, IsThatOfTheIceWhicheverWayTheJointPoints) {
    const double nu = section.poisson_ratio;
    const auto turned = [](double xx, double zz, double xz, double c, double s) {
        return std::array<double, 3>{xx * c * c + zz * s * s + 2 * xz * c * s, xx * s * s + zz * c * c - 2 * xz * c * s,
                                     (zz - xx) * c * s + xz * (c * c - s * s)};
    };
    const double to_moment = area * 0.033 / 6;
    double facing = 0;
    for (int degrees = -25; degrees <= 50; degrees += 5) {  // the tension is at 9
        const double angle = degrees * std::numbers::pi / 180;
        const auto [n, t, nt] = turned(30e3, 4e3, 0, std::cos(angle), std::sin(angle));
        const auto [pull, pulled_across, shear] = turned(-6e3, 2e3, 3e3, std::cos(angle), std::sin(angle));
        const double share = 1 / (1 - nu * nu);
        const JointLoad load{.reaction = {.axial = area * pull,
                                          .shear_in_plane = area * shear,
                                          .torsion = -to_moment * nt / (1 - nu),
                                          .bending = to_moment * share * (n - nu * t)},
                             .across = to_moment * share * (t - nu * n),
                             .pulled_across = area * pulled_across};
        const Tension found = fibre_tension(load, section);
        EXPECT_NEAR(found.stress, 15e3 + std::sqrt(9e3 * 9e3 + 3e3 * 3e3), 1e-6) << degrees;
        const double principal = 0.5 * std::atan2(3e3, 9e3);
        EXPECT_NEAR(found.facing, std::cos(principal - angle), 1e-9) << degrees;
        facing = std::max(facing, found.facing);
    }
    EXPECT_GT(facing, 0.999);
}

TEST(TensionInPlane, OfThrustAlongAnotherDirectionIsNone) {
    const JointLoad load{.reaction = {.axial = -area * 50e3, .shear_in_plane = area * 50e3},
                         .pulled_across = -area * 50e3};  // 100 kPa under 45 degrees
    EXPECT_NEAR(tension_in_plane(load, section).stress, 0, 1e-6);
    const JointLoad pulled{.reaction = {.axial = area * 15e3, .shear_in_plane = area * 15e3},
                           .pulled_across = area * 15e3};
    EXPECT_NEAR(tension_in_plane(pulled, section).stress, 30e3, 1e-6) << "not half of it";
    EXPECT_NEAR(tension_in_plane(pulled, section).facing, std::sqrt(0.5), 1e-9);
}

TEST(FibreStress, TakesContactsWhereTheyAre) {
    JointLoad load{.reaction = {.bending = bending_strength}};
    load.sagging.along = 5e3;
    load.hogging.along = -20e3;  // elsewhere on the same elements
    EXPECT_NEAR(fibre_tension(load, section).stress, 41.4e3, 1e-6)
        << "a contact that lifts does not relieve what another presses";
    load.reaction.bending = -bending_strength;
    EXPECT_NEAR(fibre_tension(load, section).stress, 56.4e3, 1e-6);
}

TEST(Utilisation, CountsWhatSplitsTheIceInItsPlane) {
    const Utilisation pulled = utilisation({{.axial = area * 33e3}}, section, no_others());
    EXPECT_EQ(pulled.mode, FailureMode::tension);
    EXPECT_NEAR(pulled.share, 1.1, 1e-9);
    const Utilisation bent = utilisation({{.in_plane_bending = 30e3 * 0.033 * 0.2 * 0.2 / 6}}, section, no_others());
    EXPECT_EQ(bent.mode, FailureMode::tension);
    EXPECT_NEAR(bent.share, 1, 1e-9);
    EXPECT_LT(utilisation({{.axial = -area * 33e3}}, section, no_others()).share, 1e-3) << "thrust does not split";
}

/// Loads up to some times the strength, among them many near it.
JointLoad any_load(std::mt19937_64& random, double by_contacts) {
    std::uniform_real_distribution<double> one(-1.2, 1.2);
    JointLoad load;
    load.reaction = {.axial = one(random) * area * 30e3,
                     .shear_vertical = one(random) * 30,
                     .shear_in_plane = one(random) * 30,
                     .torsion = one(random) * bending_strength,
                     .in_plane_bending = one(random) * 6,
                     .bending = one(random) * bending_strength};
    load.across = one(random) * bending_strength;
    load.pulled_across = one(random) * area * 30e3;
    load.sagging = {by_contacts * std::abs(one(random)) / 1.2, by_contacts * one(random) / 1.2};
    load.hogging = {-by_contacts * std::abs(one(random)) / 1.2, by_contacts * one(random) / 1.2};
    for (LocalStress* local : {&load.sagging, &load.hogging})  // an oblique rim's
        local->shear = (by_contacts - std::abs(local->along)) * one(random) / 1.2;
    return load;
}

TEST(MayFail, IsTrueWheneverTheUtilisationExceedsOne) {
    const Thresholds thresholds{1e9, 35, 300, 250, bending_strength, 6};
    std::mt19937_64 random(35);
    int failing = 0;
    int spared = 0;
    for (int i = 0; i < 20000; ++i) {
        const double by_contacts = i % 2 == 0 ? 0.0 : 10e3;
        JointLoad load = any_load(random, by_contacts);
        if (i % 3 == 0) {
            load.reaction.torsion /= 8;
            load.across /= 8;
        }
        const bool fails = utilisation(load, section, thresholds).share > 1;
        const bool may = may_fail(load.reaction, load.across, by_contacts, section, thresholds);
        EXPECT_TRUE(may || !fails) << i;
        failing += fails ? 1 : 0;
        spared += may ? 0 : 1;
    }
    EXPECT_GT(failing, 1000);
    EXPECT_GT(spared, 1000);
    const JointReaction lost{.axial = std::nan("")};
    EXPECT_TRUE(may_fail(lost, 0, 0, section, thresholds)) << "what is not a number is looked at";
}

}  // namespace joint_stress_test
}  // namespace floes
