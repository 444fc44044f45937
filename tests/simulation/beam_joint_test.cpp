// Ice of beam joints against elastic beams and plates, whatever the size of the elements.

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "ice/joint_stress.hpp"
#include "scenario/keys.hpp"
#include "simulation/laboratory.hpp"
#include "theory/plate.hpp"

namespace floes {
namespace beam_joint_test {

TEST(BeamJoint, StiffnessFollowsFromThePlate) {
    const ElasticIce ice{.elastic_modulus = 6e9, .poisson_ratio = 0.3, .thickness = 0.5, .damping_ratio = 0.1};
    const double rigidity = 6e9 * 0.125 / (12 * 0.91);
    EXPECT_DOUBLE_EQ(ice.flexural_rigidity(), rigidity);
    const JointSpring joint = beam_joint(ice, 2, 2);
    EXPECT_DOUBLE_EQ(joint.force[0], 6e9 * 0.5);                                   // E T
    EXPECT_DOUBLE_EQ(joint.force[2], 6e9 * 0.5);                                   // E T
    EXPECT_DOUBLE_EQ(joint.moment[0], rigidity);                                   // D
    EXPECT_DOUBLE_EQ(joint.moment[1], 6e9 * 0.5 * 2 * 2 / 12);                     // E T L² / 12
    EXPECT_DOUBLE_EQ(joint.moment[2], rigidity);                                   // D
    const double shear = 1 / (4 / (12 * rigidity) + 6.0 / 5 / (6e9 / 2.6 * 0.5));  // bending and shear in series
    EXPECT_NEAR(joint.force[1] / shear, 1, 1e-12);
    EXPECT_EQ(joint.damping_ratio, 0.1);
    const JointSpring half = beam_joint(ice, 2, 1);  // half as long: twice as stiff against bending
    EXPECT_DOUBLE_EQ(half.moment[2], 2 * rigidity);
}

class StripOfIce : public testing::TestWithParam<double> {};

TEST_P(StripOfIce, BendsAndSwingsAsAnElasticOne) {
    for (const int elements : {3, 6, 12}) {
        const BeamStiffness shown = measure_beam_stiffness(with_beam_joints({}, GetParam()), elements);
        EXPECT_NEAR(shown.deflection / shown.elastic_deflection, 1, 0.005) << elements;
        EXPECT_NEAR(shown.frequency / shown.elastic_frequency, 1, 0.005) << elements;
    }
}

INSTANTIATE_TEST_SUITE_P(Moduli, StripOfIce, testing::Values(60e6, 1e9, 5e9));

TEST(StripOfIce, NeedsBeamJoints) {
    EXPECT_THROW(measure_beam_stiffness(paper_scenario(), 3), InputError);
    EXPECT_THROW(measure_beam_stiffness(with_beam_joints({}, 60e6), 0), InputError);
}

struct SheetOfIce {
    double element;
    double sheet;
};

class BeamSheet : public testing::TestWithParam<SheetOfIce> {};

// A load on one element acts at a node of the beams, so it is a point load to the plate.
TEST_P(BeamSheet, SinksAsAPlateOnWater) {
    Scenario scenario = with_beam_joints({}, 60e6);
    scenario.floe.thickness = 0.03;
    scenario.floe.element = GetParam().element;
    scenario.general.iterations = 10;
    const CurvePoint few = measure_curve_point(scenario, {.sheet = GetParam().sheet});
    const FloatingPlate plate{.thickness = 0.03};
    EXPECT_NEAR(few.slope / (8 * std::sqrt(plate.foundation() * plate.flexural_rigidity(60e6))), 1, 0.02);
    EXPECT_NEAR(few.elastic_modulus_point, 60e6, 0.03 * 60e6);
    scenario.general.iterations = 200;
    EXPECT_EQ(measure_curve_point(scenario, {.sheet = GetParam().sheet}).slope, few.slope);
}

INSTANTIATE_TEST_SUITE_P(Elements, BeamSheet,
                         testing::Values(SheetOfIce{0.3, 5.1}, SheetOfIce{0.2, 5.4}, SheetOfIce{0.1, 5.3}),
                         [](const auto& sheet) {
                             return std::to_string(std::lround(1000 * sheet.param.element)) + "mm";
                         });

TEST(BeamSheet, HasNoCfmToFind) {
    EXPECT_THROW(calibrate_cfm(with_beam_joints({}, 60e6), {}, 60e6), InputError);
}

}  // namespace beam_joint_test
}  // namespace floes
