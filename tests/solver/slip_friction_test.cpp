// Friction that depends on the speed of sliding, against the figures of its sources: docs/convergence.md.

#include "solver/slip_friction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace floes::test {
namespace slip_friction_test {

/// Of surfaces that slide steadily.
double steady(const SlipLaw& law, const SlipFriction& parameters, double speed) {
    return friction_coefficient(law, parameters, speed, speed);
}

TEST(SlipFriction, ConstantKnowsNoSpeed) {
    for (const double speed : {0.0, 1e-3, 10.0}) {
        EXPECT_EQ(steady({SlipEffect::constant, 0.3, 0.35}, {}, speed), 0.3);
        EXPECT_EQ(steady({SlipEffect::constant, 7.0, 0.35}, {}, speed), 7.0) << "no bound of the other laws";
    }
}

// Jones et al. 1991, warm saline ice: 0.1 at 1 mm/s with the power 0.35 from 0.5 at 0.01 mm/s, down to 0.05.
TEST(SlipFriction, PowerIsThatOfPolishedIce) {
    const SlipFriction parameters{.speed = 1e-5, .least = 0.05, .largest = 0.5};
    const SlipLaw law{SlipEffect::power, 0.5, 0.35};
    EXPECT_NEAR(steady(law, parameters, 1e-5), 0.5, 1e-12);
    EXPECT_NEAR(steady(law, parameters, 1e-3), 0.1, 0.001);
    EXPECT_EQ(steady(law, parameters, 0.1), 0.05) << "the least";
    EXPECT_EQ(steady(law, parameters, 0.0), 0.5) << "the largest";
}

// Frederking and Barker 2002: nearly doubles from 100 to 10 mm/s.
TEST(SlipFriction, PowerIsThatOfHulls) {
    const SlipLaw law = slip_law({.ice_structure_friction = 0.1, .slip = {.ice_structure = SlipEffect::power}}, true);
    EXPECT_NEAR(steady(law, {}, 0.1), 0.1, 1e-12);
    EXPECT_NEAR(steady(law, {}, 0.01) / steady(law, {}, 0.1), 1.9, 0.01);
}

// Lishman et al. 2011: 0.872 + 0.310 ln(v/V) - 0.382 ln(v/V) at V = 10 micrometres a second, given at 0.1 m/s here.
TEST(SlipFriction, RateAndStateIsThatOfItsSource) {
    const SlipLaw law{SlipEffect::rate_and_state, 0.872 - 0.072 * std::log(1e4), 0};
    constexpr std::array figures{std::pair(0.01, 0.37), std::pair(0.07, 0.23), std::pair(0.1, 0.21)};
    for (const auto& [speed, expected] : figures) EXPECT_NEAR(steady(law, {}, speed), expected, 0.006) << speed;
}

TEST(SlipFriction, AChangeOfSpeedActsAtOnceAndIsForgottenInTheMemory) {
    const SlipFriction parameters{.largest = 10};
    const SlipLaw law{SlipEffect::rate_and_state, 1, 0};
    double remembered = remembered_slip(parameters, 0.01, -1, 0.02);
    EXPECT_EQ(remembered, 0.01) << "a new contact has slid so for ever";
    const double before = friction_coefficient(law, parameters, 0.01, remembered);
    EXPECT_NEAR(friction_coefficient(law, parameters, 0.1, remembered) - before, 0.310 * std::log(10), 1e-12);
    for (int step = 0; step < 500; ++step) remembered = remembered_slip(parameters, 0.1, remembered, 0.02);
    const double left = std::exp(-1.0);
    EXPECT_NEAR(std::log(remembered / 0.1), left * std::log(0.1), 1e-9) << "after 10 s a share of 1/e is left";
    EXPECT_NEAR(friction_coefficient(law, parameters, 0.1, remembered), 1 - 0.382 * left * std::log(0.1), 1e-9);
    double in_one = remembered_slip(parameters, 0.1, 0.01, 10.0);
    EXPECT_NEAR(in_one, remembered, 1e-12) << "whatever the step";
}

TEST(SlipFriction, WithoutFrictionThereIsNone) {
    for (const SlipEffect effect : {SlipEffect::power, SlipEffect::rate_and_state})
        EXPECT_EQ(steady({effect, 0, 0.35}, {}, 1e-4), 0);
}

TEST(SlipFriction, EachKindOfSurfacesHasItsOwnLaw) {
    const ContactLaw law{.ice_ice_friction = 0.3,
                         .ice_structure_friction = 0.2,
                         .slip = {.ice_ice = SlipEffect::power, .ice_structure = SlipEffect::rate_and_state}};
    EXPECT_EQ(slip_law(law, false).effect, SlipEffect::power);
    EXPECT_EQ(slip_law(law, false).coefficient, 0.3);
    EXPECT_EQ(slip_law(law, true).effect, SlipEffect::rate_and_state);
    EXPECT_EQ(slip_law(law, true).coefficient, 0.2);
}

}  // namespace slip_friction_test
}  // namespace floes::test
