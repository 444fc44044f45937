// Floes of mixed sizes and rectangles, laid down by each method.

#include <gtest/gtest.h>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "scattered_scenario.hpp"

namespace floes {
namespace mixed_test {

Scenario mixed_scenario(double concentration) {
    Scenario scenario = scattered_scenario();
    scenario.field.concentration = concentration;
    scenario.sizes = {.law = SizeLaw::lognormal, .smallest = 0.3, .largest = 1.5, .cov = 0.5, .largest_ratio = 1.6};
    scenario.floe.element = 0.1;
    return scenario;
}

std::vector<double> numbers(const std::vector<PlanarPose>& poses) {
    std::vector<double> found;
    for (const PlanarPose& pose : poses) found.insert(found.end(), {pose.x, pose.z, pose.yaw});
    return found;
}

TEST(MixedFloes, LieApartUpTo85Percent) {
    for (const double concentration : {0.5, 0.75, 0.85}) {
        const Scenario scenario = mixed_scenario(concentration);
        for (std::uint32_t number = 0; number < 3; ++number) {
            const Arrangement made = make_arrangement(scenario, 1, number);
            EXPECT_EQ(find_fault(scenario, made), std::nullopt);
            EXPECT_NEAR(covered_area(made) / (scenario.field_length() * 2 * scenario.field.half_width), concentration,
                        1e-12);
        }
    }
}

TEST(MixedFloes, AreMovedByMonteCarlo) {
    Scenario scenario = mixed_scenario(0.75);
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
    scenario.arrangement.sweeps = 200;
    EXPECT_EQ(find_fault(scenario, make_arrangement(scenario, 1, 0)), std::nullopt);
    scenario.arrangement.method = ArrangementMethod::scattered;
    scenario.arrangement.ordering_sweeps = 200;
    EXPECT_EQ(find_fault(scenario, make_arrangement(scenario, 1, 0)), std::nullopt);
}

TEST(MixedFloes, TheIceChangesNoArrangement) {
    const Scenario plain = mixed_scenario(0.7);
    Scenario drawn = plain;
    drawn.spread.thickness = {LawKind::lognormal, 0.2};
    drawn.spread.strength = {LawKind::normal, 0.2};
    EXPECT_EQ(geometry_key(plain), geometry_key(drawn));
    const Arrangement one = make_arrangement(plain, 3, 1);
    const Arrangement other = make_arrangement(drawn, 3, 1);
    EXPECT_EQ(numbers(one.poses()), numbers(other.poses()));
    drawn.spread.draw = 1;
    const Arrangement third = make_arrangement(drawn, 3, 1);
    EXPECT_EQ(numbers(one.poses()), numbers(third.poses()));
    EXPECT_NE(third.shape(0).thickness, other.shape(0).thickness);
    EXPECT_EQ(one.coverage_ahead, third.coverage_ahead);
}

TEST(MixedFloes, AnotherLawIsAnotherGeometry) {
    const Scenario scenario = mixed_scenario(0.7);
    Scenario other = scenario;
    other.sizes.cov = 0.3;
    EXPECT_NE(geometry_key(scenario), geometry_key(other));
    other = scenario;
    other.sizes.law = SizeLaw::one;
    EXPECT_NE(geometry_key(scenario), geometry_key(other));
}

}  // namespace mixed_test
}  // namespace floes
