// Scattered fields: valid, disordered, even, reproducible.

#include "arrangement/scattered.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "arrangement/order.hpp"
#include "arrangement/scattered_scenario.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace scattered_test {

struct Geometry {
    double length;
    double breadth;
    double concentration;
    double clearance;
};

class ScatteredFields : public testing::TestWithParam<Geometry> {};

TEST_P(ScatteredFields, LieApartWithinTheirWalls) {
    const Geometry& geometry = GetParam();
    Scenario scenario = scattered_scenario(geometry.concentration);
    scenario.floe.length = geometry.length;
    scenario.floe.breadth = geometry.breadth;
    scenario.arrangement.clearance = geometry.clearance;
    for (std::uint32_t number = 0; number < 3; ++number) {
        const std::vector<PlanarPose> poses = make_arrangement(scenario, 1, number).poses();
        ASSERT_EQ(poses.size(), 189u);
        const auto fault = find_fault(scenario, floes_at(scenario, poses));
        EXPECT_FALSE(fault.has_value()) << fault->sentence;
    }
}

INSTANTIATE_TEST_SUITE_P(Geometries, ScatteredFields,
                         testing::Values(Geometry{0.6, 0.6, 0.10, 0.002}, Geometry{0.6, 0.6, 0.50, 0.002},
                                         Geometry{0.6, 0.6, 0.75, 0}, Geometry{0.6, 0.6, 0.80, 0.002},
                                         Geometry{0.6, 0.6, 0.60, 0.05}, Geometry{0.8, 0.4, 0.75, 0.002},
                                         Geometry{0.4, 0.8, 0.75, 0.002}, Geometry{1.2, 0.3, 0.75, 0.002},
                                         Geometry{2.4, 0.2, 0.60, 0.002}, Geometry{4.6, 0.2, 0.40, 0.002}));

TEST(Scattered, IsAFunctionOfSeedNumberAndGeometry) {
    const Scenario scenario = scattered_scenario();
    const auto yaw = [](const Scenario& of, std::uint64_t seed, std::uint32_t number) {
        return make_arrangement(of, seed, number).floes[100].pose.yaw;
    };
    const double first = yaw(scenario, 1, 0);
    EXPECT_EQ(first, yaw(scenario, 1, 0));
    EXPECT_NE(first, yaw(scenario, 2, 0));
    EXPECT_NE(first, yaw(scenario, 1, 1));
    Scenario another_case = scenario;
    another_case.joint.cfm = 0.03;
    EXPECT_EQ(first, yaw(another_case, 1, 0));
}

TEST(Scattered, OneFloeLiesAnywhere) {
    Scenario scenario = scattered_scenario(0.1);
    scenario.field.floes = 1;
    const Arrangement made = make_arrangement(scenario, 1, 0);
    EXPECT_NEAR(made.psi4, 1, 1e-15);
    EXPECT_NE(made.floes[0].pose.yaw, 0);
}

TEST(Scattered, DoesNotCrystallise) {
    const Figures figures = figures_of(scattered_scenario(), 20, [](const Arrangement& made) {
        return std::vector{made.psi4, made.local_order};
    });
    EXPECT_LT(mean(figures[0]), 0.3);  // a crystal has 0.89
    EXPECT_GT(mean(figures[1]), 0.3);
    EXPECT_LT(mean(figures[1]), 0.55);  // 0.85
}

// Nothing drives the floes to one side, and each part of the field's length is covered alike, the ends included.
TEST(Scattered, CoversTheFieldEvenly) {
    const Scenario scenario = scattered_scenario(0.6);
    constexpr int parts = 6;
    const Figures figures = figures_of(scenario, 300, [&](const Arrangement& made) {
        std::vector<double> values{0, 0};
        for (const PlanarPose& pose : made.poses()) {
            values[0] += pose.x - scenario.field.begin - 0.5 * scenario.field_length();
            values[1] += pose.z;
        }
        Walls part = field_walls(scenario);
        part.length /= parts;
        for (int i = 0; i < parts; ++i, part.low_x += part.length)
            values.push_back(coverage(part, rectangles(made), made.poses()));
        return values;
    });
    EXPECT_LT(std::abs(mean(figures[0])), 4 * error_of_mean(figures[0]));
    EXPECT_LT(std::abs(mean(figures[1])), 4 * error_of_mean(figures[1]));
    for (std::size_t i = 2; i < figures.size(); ++i)
        EXPECT_NEAR(mean(figures[i]), 0.6, 4 * error_of_mean(figures[i])) << i;
}

TEST(Scattered, ImpossibleFieldsAreRefused) {
    Scenario scenario = scattered_scenario(0.96);
    scenario.field.floes = 12;
    scenario.field.half_width = 1.0;
    EXPECT_THAT(refusal([&] { make_arrangement(scenario, 1, 0); }),
                testing::AllOf(testing::HasSubstr("12 floes of 0.6 m x 0.6 m, scattered in a field of 2.250 m x 2.000 "
                                                  "m, still overlap after 10 attempts"),
                               testing::HasSubstr("lower field.concentration_percent")));
}

}  // namespace scattered_test
}  // namespace floes
