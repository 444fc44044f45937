// The stress in the outer fibres at a joint, by hand.

#include "ice/joint_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
    EXPECT_NEAR(fibre_stress({{.bending = bending_strength}}, section), 36.4e3, 1e-6);
    EXPECT_NEAR(fibre_stress({{.bending = -bending_strength}}, section), 36.4e3, 1e-6) << "hogging pulls the upper one";
    EXPECT_NEAR(fibre_stress({{.axial = -area * 10e3, .bending = bending_strength}}, section), 26.4e3, 1e-6);
    EXPECT_NEAR(fibre_stress({{.axial = area * 10e3}}, section), 10e3, 1e-6);
}

TEST(FibreStress, OfATwistIsAtFortyFiveDegrees) {
    // A plate's twisting moment is 1 - ν of the grid's; its principal stress is as large.
    EXPECT_NEAR(fibre_stress({{.torsion = bending_strength}}, section), 0.7 * 36.4e3, 1e-6);
}

TEST(FibreStress, BelongsToTheJointAlongWhichItPulls) {
    const JointLoad across{.reaction = {}, .across = bending_strength};
    EXPECT_NEAR(fibre_stress(across, section), 0.3 * 36.4e3, 1e-6) << "the joints beside it crack, not this one";
    const JointLoad both{.reaction = {.bending = bending_strength}, .across = bending_strength};
    EXPECT_NEAR(fibre_stress(both, section), 1.3 * 36.4e3, 1e-6) << "a bowl: D (1 + ν) κ";
}

TEST(FibreStress, OfACrackUnderFortyFiveDegreesIsThatAlongTheGrid) {
    // Cylindrical bending along the diagonal: curvature κ there, none across. The plate has D κ along the diagonal.
    const double moment = bending_strength;  // D κ L
    const JointLoad diagonal{.reaction = {.torsion = moment / 2, .bending = moment / 2}, .across = moment / 2};
    EXPECT_NEAR(fibre_stress(diagonal, section), 36.4e3, 1e-6);
}

TEST(FibreStress, TakesContactsWhereTheyAre) {
    JointLoad load{.reaction = {.bending = bending_strength}};
    load.sagging.along = 5e3;
    load.hogging.along = -20e3;  // elsewhere on the same elements
    EXPECT_NEAR(fibre_stress(load, section), 41.4e3, 1e-6)
        << "a contact that lifts does not relieve what another presses";
    load.reaction.bending = -bending_strength;
    EXPECT_NEAR(fibre_stress(load, section), 56.4e3, 1e-6);
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
