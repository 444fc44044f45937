// Whether the chain forgets its start: arrangements from two very different starts are compared, figure by figure, in
// units of the standard error from their scatter over arrangements.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "arrangement/arrangement.hpp"

namespace floes {
namespace start_test {

constexpr int bins_along = 9;
constexpr int bins_across = 8;

// What an arrangement looks like: order, slow waves of the density, mean position, and floes per bin along x and z.
std::vector<double> figures(const Scenario& scenario, const Arrangement& arrangement) {
    std::vector<double> result(5 + bins_along + bins_across, 0);
    result[0] = arrangement.psi4;
    for (const PlanarPose& pose : arrangement.poses()) {
        const double along = (pose.x - scenario.field.begin) / scenario.field_length();
        const double across = 0.5 + 0.5 * pose.z / scenario.field.half_width;
        result[1] += std::cos(std::numbers::pi * along);
        result[2] += std::cos(2 * std::numbers::pi * along);
        result[3] += across;
        result[4] += across * across;
        ++result[5 + static_cast<std::size_t>(along * bins_along)];
        ++result[5 + bins_along + static_cast<std::size_t>(across * bins_across)];
    }
    return result;
}

struct Sample {
    std::vector<double> mean;
    std::vector<double> variance;  // of the mean
};

Sample sample(ArrangementStart start, int sweeps, int count) {
    Scenario scenario;
    scenario.arrangement.method = ArrangementMethod::monte_carlo;
    scenario.arrangement.start = start;
    scenario.arrangement.sweeps = sweeps;
    std::vector<double> sum, squares;
    for (int number = 0; number < count; ++number) {
        const auto values = figures(scenario, make_arrangement(scenario, 1, static_cast<std::uint32_t>(number)));
        sum.resize(values.size());
        squares.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum[i] += values[i];
            squares[i] += values[i] * values[i];
        }
    }
    Sample result;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const double mean = sum[i] / count;
        result.mean.push_back(mean);
        result.variance.push_back((squares[i] / count - mean * mean) / (count - 1));
    }
    return result;
}

// The largest difference of a figure between the two starts, in standard errors.
double largest_difference(int sweeps, int count) {
    const Sample lattice = sample(ArrangementStart::lattice, sweeps, count);
    const Sample stripes = sample(ArrangementStart::stripes, sweeps, count);
    double largest = 0;
    for (std::size_t i = 0; i < lattice.mean.size(); ++i) {
        const double error = std::sqrt(lattice.variance[i] + stripes.variance[i]);
        // A figure that never varies and never differs (bins that walls keep at one number) says nothing.
        if (lattice.mean[i] != stripes.mean[i]) {
            largest = std::max(largest, std::abs(lattice.mean[i] - stripes.mean[i]) / error);
        }
    }
    return largest;
}

TEST(Start, IsForgottenAfterTheDefaultNumberOfSweeps) {
    EXPECT_LT(largest_difference(ArrangementRule{}.sweeps, 12), 4);
}

TEST(Start, IsStillSeenAfterFewSweeps) {
    EXPECT_GT(largest_difference(200, 12), 20);
}

}  // namespace start_test
}  // namespace floes
