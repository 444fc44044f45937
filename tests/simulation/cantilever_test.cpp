#include "simulation/laboratory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "core/error.hpp"
#include "support/refusal.hpp"
#include "support/sweeping_scenario.hpp"
#include "theory/plate.hpp"

namespace floes {
namespace cantilever_test {

class BeamAtCfm : public testing::TestWithParam<double> {
  protected:
    BeamAtCfm() { scenario_.joint.cfm = GetParam(); }

    Scenario scenario_ = sweeping_scenario();
};

TEST_P(BeamAtCfm, BreaksInBendingAtItsStrengthWhateverItsLength) {
    for (const int elements : {1, 2, 3}) {
        const BeamStrength shown = measure_beam_strength(scenario_, {.elements = elements});
        EXPECT_EQ(shown.mode, FailureMode::bending);
        EXPECT_EQ(shown.joint, 0);
        EXPECT_DOUBLE_EQ(shown.length, elements * 0.2);
        EXPECT_NEAR(shown.strength, 36.4e3, 0.01 * 36.4e3) << elements << " elements";
    }
}

TEST_P(BeamAtCfm, ShearsAtItsShearStrength) {
    const BeamStrength shown = measure_beam_strength(scenario_, {.load = BeamLoad::shear, .elements = 1});
    EXPECT_EQ(shown.mode, FailureMode::shear);
    EXPECT_NEAR(shown.strength, 72.8e3, 0.01 * 72.8e3);
}

TEST_P(BeamAtCfm, IsCrushedAtItsCompressiveStrength) {
    const BeamStrength shown = measure_beam_strength(scenario_, {.load = BeamLoad::compression, .elements = 1});
    EXPECT_EQ(shown.mode, FailureMode::compression);
    EXPECT_NEAR(shown.strength, 145.6e3, 0.01 * 145.6e3);
}

INSTANTIATE_TEST_SUITE_P(PapersValues, BeamAtCfm, testing::Values(1e-10, 0.016, 0.03));

TEST(Beam, AsPrintedShearNeedsAThirtiethOfTheLoad) {
    Scenario scenario = sweeping_scenario();
    const double load = measure_beam_strength(scenario, {.load = BeamLoad::shear, .elements = 1}).load;
    scenario.joint.threshold_form = ThresholdForm::as_printed;
    const BeamStrength printed = measure_beam_strength(scenario, {.load = BeamLoad::shear, .elements = 1});
    EXPECT_NEAR(printed.load / load, scenario.floe.thickness, 0.01 * scenario.floe.thickness);
    EXPECT_NEAR(printed.strength, 72.8e3, 0.01 * 72.8e3);
}

TEST(Beam, TwiceTheStrengthTakesTwiceTheLoad) {
    Scenario scenario = sweeping_scenario();
    scenario.ice.bending_strength *= 2;
    EXPECT_NEAR(measure_beam_strength(scenario, {.elements = 2}).strength, 72.8e3, 0.01 * 72.8e3);
}

TEST(Beam, AFloatingBeamReadsMoreThanItsStrengthAsOneOnAFoundationDoes) {
    // The numerical beam is softer than an elastic one of 60 MPa (its joints also shear), so it reads somewhat more.
    const Scenario scenario = sweeping_scenario();
    for (const int elements : {2, 3}) {
        const BeamStrength shown = measure_beam_strength(scenario, {.elements = elements, .floating = true});
        const double elastic = floating_cantilever_factor(60e6, elements * 0.2, scenario.floe.thickness, 9810);
        EXPECT_GT(shown.strength / shown.set, elastic);
        EXPECT_LT(shown.strength / shown.set, 1.2 * elastic);
    }
}

TEST(Beam, OfBeamJointsBreaksAtItsStrength) {
    for (const JointFailure by : {JointFailure::stress, JointFailure::moment}) {
        Scenario scenario;
        scenario.joint.failure = by;
        const BeamStrength bent = measure_beam_strength(scenario, {.elements = 2});
        EXPECT_EQ(bent.mode, FailureMode::bending);
        EXPECT_EQ(bent.joint, 0);
        EXPECT_NEAR(bent.strength, 36.4e3, 0.01 * 36.4e3);
        const BeamStrength sheared = measure_beam_strength(scenario, {.load = BeamLoad::shear, .elements = 1});
        EXPECT_EQ(sheared.mode, FailureMode::shear);
        EXPECT_NEAR(sheared.strength, 72.8e3, 0.01 * 72.8e3);
        const BeamStrength crushed = measure_beam_strength(scenario, {.load = BeamLoad::compression, .elements = 1});
        EXPECT_EQ(crushed.mode, FailureMode::compression);
        EXPECT_NEAR(crushed.strength, 145.6e3, 0.01 * 145.6e3);
    }
}

// As a strip of plate on an elastic foundation (Hetényi), 1/(1 - ν²) stiffer than a narrow beam: 1.118, 1.632, 1.071.
TEST(Beam, OfBeamJointsThatFloatsReadsAsTheElasticOneOfItsModulus) {
    for (const auto& [modulus, elements] : {std::pair{60e6, 2}, {60e6, 3}, {500e6, 3}}) {
        Scenario scenario;
        scenario.ice.elastic_modulus = modulus;
        const BeamStrength shown =
            measure_beam_strength(scenario, {.elements = elements, .floating = true, .increment = 0.01});
        const double nu = scenario.ice.poisson_ratio;
        const double elastic =
            floating_cantilever_factor(modulus / (1 - nu * nu), elements * 0.2, scenario.floe.thickness, 9810);
        EXPECT_EQ(shown.joint, 0);
        EXPECT_NEAR(shown.strength / shown.set, elastic, 0.012 * elastic) << modulus << " Pa, " << elements;
    }
}

// The clamp's joint has twice Σ; what is refused is what was given.
TEST(Beam, SaysWhichSigmaCannotBeTested) {
    Scenario scenario = sweeping_scenario();
    for (const auto& [cfm, words] : {std::pair{-1.0, "A beam of Σ = -1 cannot"}, {0.5, "A beam of Σ = 0.5 cannot"}}) {
        scenario.joint.cfm = cfm;
        EXPECT_THAT(refusal([&] { measure_beam_strength(scenario, {}); }), testing::HasSubstr(words));
    }
}

TEST(Beam, RefusesWhatCannotBeTested) {
    const Scenario scenario = sweeping_scenario();
    EXPECT_THROW(measure_beam_strength(scenario, {.elements = 0}), InputError);
    EXPECT_THROW(measure_beam_strength(scenario, {.increment = 0}), InputError);
}

}  // namespace cantilever_test
}  // namespace floes
