// Thresholds of Eqs. (1)-(3) and the choice of the mode.

#include "ice/failure.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace floes {
namespace failure_test {

constexpr double none = std::numeric_limits<double>::infinity();

TEST(ThresholdsTest, AreForcesByDefault) {
    const Thresholds t = make_thresholds({}, {});
    EXPECT_NEAR(t.compression, 960.96, 1e-9);
    EXPECT_NEAR(t.shear, 480.48, 1e-9);
    EXPECT_NEAR(t.bending, 1.32132, 1e-12);
    EXPECT_EQ(t.tension, none);
    EXPECT_EQ(t.torsion, none);
    EXPECT_EQ(t.in_plane_bending, none);
}

TEST(ThresholdsTest, AreAsPrintedOnRequest) {
    Scenario scenario;
    scenario.joint.threshold_form = ThresholdForm::as_printed;
    const Thresholds t = make_thresholds(scenario.floe, scenario.material());
    EXPECT_NEAR(t.compression, 31.71168, 1e-9);
    EXPECT_NEAR(t.shear, 15.85584, 1e-9);
    EXPECT_NEAR(t.bending, 1.32132, 1e-12);
}

TEST(ThresholdsTest, HaveTheirOwnSectionsWhereThePaperIsSilent) {
    Scenario scenario;
    scenario.ice.tensile_strength = 1e4;
    scenario.ice.torsion_strength = 2e4;
    scenario.ice.in_plane_bending_strength = 3e4;
    const Thresholds t = make_thresholds(scenario.floe, scenario.material());
    EXPECT_NEAR(t.tension, 0.2 * 0.033 * 1e4, 1e-12);
    EXPECT_NEAR(t.torsion, 0.2 * 0.033 * 0.033 / 3 * 2e4, 1e-12);
    EXPECT_NEAR(t.in_plane_bending, 0.033 * 0.2 * 0.2 / 6 * 3e4, 1e-12);
}

// A cantilever that bears P at a distance x from the joint: the moment about the centre of the element that holds it is
// P (x + L_e / 2).
TEST(ThresholdsTest, TakeTheMomentAboutTheCentreOfTheElementOnRequest) {
    Scenario scenario;
    scenario.joint.moment_about = MomentAbout::element_centre;
    const Thresholds centre = make_thresholds(scenario.floe, scenario.material());
    const Thresholds pivot = make_thresholds({}, {});
    const double load = centre.bending / (0.15 + 0.1);
    const auto held = [](double force) { return JointReaction{.shear_vertical = -force, .bending = -force * 0.15}; };
    EXPECT_FALSE(failure(held(0.999 * load), centre));
    EXPECT_EQ(failure(held(1.001 * load), centre), FailureMode::bending);
    EXPECT_FALSE(failure(held(1.001 * load), pivot));
}

const Thresholds thresholds{
    .bending = 1, .shear = 50, .compression = 100, .tension = 20, .torsion = 2, .in_plane_bending = 4};

/// The reaction that is `share` of the threshold of `mode`, with either sign where the sign does not matter.
JointReaction reaction_of(FailureMode mode, double share, double sign) {
    switch (mode) {
        case FailureMode::bending:
            return {.bending = sign * share * thresholds.bending};
        case FailureMode::shear:
            return {.shear_vertical = sign * 0.6 * share * thresholds.shear,
                    .shear_in_plane = 0.8 * share * thresholds.shear};
        case FailureMode::compression:
            return {.axial = -share * thresholds.compression};
        case FailureMode::tension:
            return {.axial = share * thresholds.tension};
        case FailureMode::torsion:
            return {.torsion = sign * share * thresholds.torsion};
        case FailureMode::in_plane_bending:
            return {.in_plane_bending = sign * share * thresholds.in_plane_bending};
    }
    return {};
}

TEST(FailureTest, BeginsAtTheThresholdOfEachMode) {
    for (int number = 0; number < static_cast<int>(failure_mode_names.size()); ++number) {
        const auto mode = static_cast<FailureMode>(number);
        for (const double sign : {1.0, -1.0}) {
            EXPECT_EQ(failure(reaction_of(mode, 0.99, sign), thresholds), std::nullopt) << failure_mode_names[number];
            EXPECT_EQ(failure(reaction_of(mode, 1.000001, sign), thresholds), mode) << failure_mode_names[number];
        }
    }
}

TEST(FailureTest, IsInTheModeThatIsMostOverloaded) {
    JointReaction reaction = reaction_of(FailureMode::bending, 1.5, 1);
    reaction.axial = -120;
    EXPECT_EQ(failure(reaction, thresholds), FailureMode::bending);
    reaction.axial = -160;
    EXPECT_EQ(failure(reaction, thresholds), FailureMode::compression);
    reaction.shear_vertical = -85;
    EXPECT_EQ(failure(reaction, thresholds), FailureMode::shear);
}

TEST(FailureTest, NeedsACriterion) {
    const Thresholds paper = make_thresholds({}, {});
    EXPECT_EQ(failure({.axial = 1e9}, paper), std::nullopt);
    EXPECT_EQ(failure({.torsion = 1e9}, paper), std::nullopt);
    EXPECT_EQ(failure({.in_plane_bending = 1e9}, paper), std::nullopt);
}

TEST(PeakReactionsTest, KeepTheLargestOfEachPart) {
    PeakReactions peaks;
    peaks = raised(
        peaks,
        {.axial = -5, .shear_vertical = 3, .shear_in_plane = -4, .torsion = -1, .in_plane_bending = 2, .bending = -3});
    peaks = raised(peaks, {.axial = 4, .torsion = 0.5, .bending = 2});
    const PeakReactions expected{
        .compression = 5, .tension = 4, .shear = 5, .bending = 3, .torsion = 1, .in_plane_bending = 2};
    EXPECT_EQ(peaks, expected);
}

}  // namespace failure_test
}  // namespace floes
