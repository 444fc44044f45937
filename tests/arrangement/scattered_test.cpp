// Scattered fields: valid, disordered, even, reproducible, and in equilibrium after many sweeps.

#include "arrangement/scattered.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/check.hpp"
#include "arrangement/order.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace {

Scenario scattered_scenario(double concentration = 0.75) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::scattered;
    scenario.field.concentration = concentration;
    return scenario;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double error_of_mean(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean(values), 2);
    const auto count = static_cast<double>(values.size());
    return std::sqrt(squares / count / (count - 1));
}

/// Figures of arrangements: [figure][arrangement].
using Figures = std::vector<std::vector<double>>;

template <class Measure>
Figures figures_of(const Scenario& scenario, int count, Measure measure) {
    Figures figures;
    for (int number = 0; number < count; ++number) {
        const std::vector<double> values = measure(make_arrangement(scenario, 1, static_cast<std::uint32_t>(number)));
        figures.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) figures[i].push_back(values[i]);
    }
    return figures;
}

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
        const std::vector<PlanarPose> poses = make_arrangement(scenario, 1, number).poses;
        ASSERT_EQ(poses.size(), 189u);
        const auto fault = find_fault(scenario, poses);
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
        return make_arrangement(of, seed, number).poses[100].yaw;
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
    EXPECT_NE(made.poses[0].yaw, 0);
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
        for (const PlanarPose& pose : made.poses) {
            values[0] += pose.x - scenario.field.begin - 0.5 * scenario.field_length();
            values[1] += pose.z;
        }
        Walls part = field_walls(scenario);
        part.length /= parts;
        for (int i = 0; i < parts; ++i, part.low_x += part.length)
            values.push_back(coverage(part, floe_shape(scenario), made.poses));
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

TEST(OrderingSweeps, ContinueTheSameField) {
    Scenario scenario = scattered_scenario();
    const std::vector<PlanarPose> start = make_arrangement(scenario, 1, 0).poses;
    scenario.arrangement.ordering_sweeps = 1;
    const std::vector<PlanarPose> moved = make_arrangement(scenario, 1, 0).poses;
    double furthest = 0;
    for (std::size_t i = 0; i < start.size(); ++i)
        furthest = std::max({furthest, std::abs(moved[i].x - start[i].x), std::abs(moved[i].z - start[i].z)});
    EXPECT_GT(furthest, 0);
    EXPECT_LT(furthest, 0.1);
    EXPECT_NE(geometry_key(scenario), geometry_key(scattered_scenario()));
}

TEST(OrderingSweeps, OfAnotherMethodChangeNothing) {
    Scenario scenario;
    const std::uint64_t key = geometry_key(scenario);
    scenario.arrangement.ordering_sweeps = 1;
    EXPECT_EQ(geometry_key(scenario), key);
}

TEST(OrderingSweeps, OrderADenseField) {
    Scenario scenario = scattered_scenario();
    const auto local = [](const Arrangement& made) { return std::vector{made.local_order}; };
    const Figures before = figures_of(scenario, 6, local);
    scenario.arrangement.ordering_sweeps = 3000;
    const Figures after = figures_of(scenario, 6, local);
    EXPECT_GT(mean(after[0]) - mean(before[0]), 0.2);
}

// Order and the numbers of pairs at rising distances, for the whole field.
std::vector<double> equilibrium_figures(const Arrangement& made) {
    constexpr std::array distances{0.6, 0.65, 0.7, 0.8, 0.9, 1.1, 1.4, 2.0};
    std::vector<double> values(1 + distances.size(), 0);
    values[0] = made.psi4;
    values[1] = made.local_order;
    for (std::size_t i = 0; i < made.poses.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double distance = std::hypot(made.poses[i].x - made.poses[j].x, made.poses[i].z - made.poses[j].z);
            for (std::size_t k = 0; k + 1 < distances.size(); ++k)
                values[2 + k] += distance >= distances[k] && distance < distances[k + 1];
        }
    }
    return values;
}

/// The largest difference of a figure between method monte_carlo and scattered floes after those sweeps, in standard
/// errors.
double largest_difference(int ordering_sweeps) {
    constexpr int count = 40;
    Scenario scenario = scattered_scenario(0.45);
    scenario.arrangement.ordering_sweeps = ordering_sweeps;
    const Figures scattered = figures_of(scenario, count, equilibrium_figures);
    scenario.arrangement = {};
    scenario.arrangement.sweeps = 3000;
    const Figures equilibrium = figures_of(scenario, count, equilibrium_figures);
    double largest = 0;
    for (std::size_t i = 0; i < equilibrium.size(); ++i) {
        const double error = std::hypot(error_of_mean(scattered[i]), error_of_mean(equilibrium[i]));
        largest = std::max(largest, std::abs(mean(scattered[i]) - mean(equilibrium[i])) / error);
    }
    return largest;
}

TEST(OrderingSweeps, EndInTheEquilibriumOfMonteCarlo) {
    EXPECT_LT(largest_difference(5000), 3.5);
}

TEST(OrderingSweeps, AreNeededToReachEquilibrium) {
    EXPECT_GT(largest_difference(0), 10);
}

}  // namespace
}  // namespace floes
