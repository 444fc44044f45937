// The sampler against a reference: orientational order of 400 hard squares in a periodic square box. The reference
// figures are those of an independent program (0.4 to 1 million sweeps; the same program gives the density of hard
// discs within its error of the published one): concentration 0.50, 0.65, 0.75 -> psi4 0.0555(3), 0.126(3), 0.808(2).
// At 0.75 psi4 seems to depend on the angle between the floes' common direction and the box, and that direction needs
// more than a million sweeps to turn: chains that begin along the box give 0.8155(12); two that were compressed from a
// disordered fluid gave 0.810(2) and 0.798(4), at 35 and 10 to 28 degrees. So one chain begins along the box, one
// across.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "arrangement/order.hpp"
#include "arrangement/periodic_box.hpp"
#include "arrangement/sampler.hpp"

namespace floes {
namespace reference_test {

struct Estimate {
    double mean;
    double error;  // of the mean
};

// Batch means. The batches must be long against the correlation time of psi4 for their means to be independent: it is
// some 20, 1600 and 3000 sweeps at concentration 0.50, 0.65 and 0.75.
Estimate batch_means(const std::vector<double>& series, std::size_t batches) {
    const std::size_t length = series.size() / batches;
    double sum = 0, squares = 0;
    for (std::size_t batch = 0; batch < batches; ++batch) {
        double mean = 0;
        for (std::size_t i = 0; i < length; ++i) mean += series[batch * length + i] / static_cast<double>(length);
        sum += mean;
        squares += mean * mean;
    }
    const double count = static_cast<double>(batches);
    const double mean = sum / count;
    return {mean, std::sqrt((squares / count - mean * mean) / (count - 1))};
}

struct Run {
    double concentration;
    int equilibration;  // sweeps of each chain
    int sweeps;         // of each chain, measured after those
    std::size_t batches;
};

// 400 squares of side 1 on a lattice with the vectors (m, n) / 400 and (-n, m) / 400 of the box's side: 400 = m² + n²
// of them fill the periodic box.
std::vector<PlanarPose> tilted_lattice(double side, int m, int n) {
    std::vector<PlanarPose> poses;
    const double yaw = -std::atan2(n, m);
    for (int i = -40; i <= 40; ++i) {
        for (int j = -40; j <= 40; ++j) {
            // Off the corner, so that rounding does not decide which sites are inside.
            const double x = ((i + 0.3) * m - (j + 0.37) * n) / 400;
            const double z = ((i + 0.3) * n + (j + 0.37) * m) / 400;
            if (x >= 0 && x < 1 && z >= 0 && z < 1) poses.push_back({x * side, z * side, yaw});
        }
    }
    return poses;
}

void append_psi4(std::vector<double>& series, const Run& run, const std::vector<PlanarPose>& start,
                 std::uint32_t chain) {
    constexpr int sweeps_per_sample = 10;
    const double side = std::sqrt(400 / run.concentration);
    HardFloes floes(PeriodicBox{0, 0, side, side}, std::vector(start.size(), corners_of(0.5, 0.5)), 0, start);
    RandomStream random(1, chain, StreamId::monte_carlo, 0);
    const Step step = tune(floes, random);
    for (int i = 0; i < run.equilibration; ++i) floes.sweep(step, random);
    for (int i = 0; i < run.sweeps; ++i) {
        floes.sweep(step, random);
        if (i % sweeps_per_sample == 0) series.push_back(fourfold_order(floes.poses()));
    }
}

void expect_reference(const Run& run, const Estimate& reference) {
    const double side = std::sqrt(400 / run.concentration);
    std::vector<double> series;
    for (const auto& start : {tilted_lattice(side, 20, 0), tilted_lattice(side, 16, 12)}) {
        ASSERT_EQ(start.size(), 400u);
        append_psi4(series, run, start, static_cast<std::uint32_t>(series.size()));
    }
    const Estimate estimate = batch_means(series, run.batches);
    testing::Test::RecordProperty("psi4", testing::PrintToString(estimate.mean));
    testing::Test::RecordProperty("error", testing::PrintToString(estimate.error));
    EXPECT_LE(estimate.error, 0.01);
    EXPECT_NEAR(estimate.mean, reference.mean, 4 * std::hypot(estimate.error, reference.error));
}

TEST(HardSquares, HaveTheOrderOfTheReferenceAtConcentration050) {
    expect_reference({0.50, 2'000, 50'000, 100}, {0.0555, 0.0003});
}

TEST(HardSquares, HaveTheOrderOfTheReferenceAtConcentration065) {
    expect_reference({0.65, 10'000, 75'000, 20}, {0.126, 0.003});
}

TEST(HardSquares, HaveTheOrderOfTheReferenceAtConcentration075) {
    expect_reference({0.75, 10'000, 40'000, 10}, {0.808, 0.002});
}

}  // namespace reference_test
}  // namespace floes
