// The stress in the outer fibres at a joint, by hand.

#include "ice/joint_stress.hpp"

#include <gtest/gtest.h>

namespace floes {
namespace {

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

}  // namespace
}  // namespace floes
