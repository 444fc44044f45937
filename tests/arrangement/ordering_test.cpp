// Sweeps after scattering: the same field moves on, orders where it is dense, and ends in equilibrium.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/scattered_scenario.hpp"

namespace floes {
namespace ordering_test {

TEST(OrderingSweeps, ContinueTheSameField) {
    Scenario scenario = scattered_scenario();
    const std::vector<PlanarPose> start = make_arrangement(scenario, 1, 0).poses();
    scenario.arrangement.ordering_sweeps = 1;
    const std::vector<PlanarPose> moved = make_arrangement(scenario, 1, 0).poses();
    double furthest = 0;
    for (std::size_t i = 0; i < start.size(); ++i)
        furthest = std::max({furthest, std::abs(moved[i].x - start[i].x), std::abs(moved[i].z - start[i].z)});
    EXPECT_GT(furthest, 0);
    EXPECT_LT(furthest, 0.1);
    EXPECT_NE(geometry_key(scenario), geometry_key(scattered_scenario()));
}

TEST(OrderingSweeps, OfAnotherMethodChangeNothing) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
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
    for (std::size_t i = 0; i < made.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double distance =
                std::hypot(made.floes[i].pose.x - made.floes[j].pose.x, made.floes[i].pose.z - made.floes[j].pose.z);
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
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
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

}  // namespace ordering_test
}  // namespace floes
