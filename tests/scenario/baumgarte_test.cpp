// Closed forms of Eqs. (4)-(5) and of Bullet's joint rows.

#include "scenario/baumgarte.hpp"

#include <gtest/gtest.h>

#include "scenario/scenario.hpp"

namespace floes {
namespace baumgarte_test {

constexpr double time_step = 0.02;
constexpr double erp = 0.8;

TEST(Baumgarte, EquationsOfThePaperInvertEachOther) {
    const SpringDamper row{76.7e3, 383.0};
    const Stabilization numbers = paper_stabilization(row, time_step);
    EXPECT_DOUBLE_EQ(numbers.cfm, 1 / (time_step * row.stiffness + row.damping));
    EXPECT_DOUBLE_EQ(numbers.erp, time_step * row.stiffness / (time_step * row.stiffness + row.damping));
    const SpringDamper back = paper_spring(numbers, time_step);
    EXPECT_NEAR(back.stiffness, row.stiffness, 1e-9 * row.stiffness);
    EXPECT_NEAR(back.damping, row.damping, 1e-9 * row.damping);
}

TEST(Baumgarte, BulletsNumbersInvertEachOther) {
    const SpringDamper row = bullet_spring({0.016, erp}, time_step, 1.629);
    const Stabilization back = bullet_stabilization(row, time_step, 1.629);
    EXPECT_NEAR(back.cfm, 0.016, 1e-15);
    EXPECT_NEAR(back.erp, erp, 1e-12);
}

// Measured with Bullet 3.24: a body of 1 kg on a fixed joint, Σ = 0.016, Δt = 0.02 s, under a static load.
TEST(Baumgarte, BulletsStiffnessIsTheMeasuredOne) {
    EXPECT_NEAR(bullet_spring({0.016, erp}, time_step, 1.0).stiffness, 125000, 1e-6);
    EXPECT_NEAR(paper_spring({0.016, erp}, time_step).stiffness, 2500, 1e-9);  // what Eqs. (4)-(5) would make of it
}

TEST(Baumgarte, ScalesWithMassAndInverseSquareOfTheTimeStep) {
    const double stiffness = bullet_spring({0.016, erp}, time_step, 1.0).stiffness;
    EXPECT_NEAR(bullet_spring({0.016, erp}, time_step / 2, 1.0).stiffness, 4 * stiffness, 1e-6);
    EXPECT_NEAR(bullet_spring({0.016, erp}, time_step, 0.5).stiffness, 2 * stiffness, 1e-6);
}

TEST(Baumgarte, DampingTimeIsFiveMilliseconds) {
    const SpringDamper row = bullet_spring({0.016, erp}, time_step, 6.39);
    EXPECT_NEAR(row.damping / row.stiffness, time_step * (1 - erp) / erp, 1e-15);
}

TEST(JointRows, ReproduceTheTableOfTheDefaultElement) {
    const Scenario scenario;
    const JointRows rows = joint_rows(scenario.floe.element, scenario.floe.thickness, scenario.ice.density);
    EXPECT_NEAR(rows.axial, 1.629, 5e-4);
    EXPECT_NEAR(rows.vertical_shear, 6.39, 5e-3);
    EXPECT_NEAR(rows.in_plane_shear, 4.07, 5e-3);
    const auto stiffness = [](double inverse_mass) {
        return bullet_spring({0.016, erp}, time_step, inverse_mass).stiffness;
    };
    EXPECT_NEAR(stiffness(rows.axial), 76.7e3, 50);
    EXPECT_NEAR(stiffness(rows.vertical_shear), 19.6e3, 50);
    EXPECT_NEAR(stiffness(rows.in_plane_shear), 30.7e3, 50);
    EXPECT_NEAR(stiffness(rows.bending), 262.7, 0.05);
    EXPECT_NEAR(stiffness(rows.torsion), 262.7, 0.05);
    EXPECT_NEAR(stiffness(rows.in_plane_bending), 511, 0.6);
}

TEST(JointRows, FollowFromTheInertiaOfABox) {
    const double mass = 930.0 * 0.2 * 0.2 * 0.033;
    EXPECT_NEAR(mass, 1.2276, 1e-12);
    const JointRows rows = joint_rows(0.2, 0.033, 930.0);
    EXPECT_NEAR(2 / rows.bending, mass * (0.2 * 0.2 + 0.033 * 0.033) / 12, 1e-12);
    EXPECT_NEAR(2 / rows.in_plane_bending, mass * 2 * 0.2 * 0.2 / 12, 1e-12);
}

}  // namespace baumgarte_test
}  // namespace floes
