// The sampler against a reference: orientational order of 400 hard squares in a periodic square box. The reference
// figures are those of an independent program (0.4 to 1 million sweeps; the same program gives the density of hard
// discs within its error of the published one): concentration 0.50, 0.65, 0.75 -> psi4 0.0555(3), 0.126(3), 0.808(2).
// At 0.75 psi4 also depends on how the floes' common direction lies to the box, and that direction takes more than a
// million sweeps to turn round: from the lattice, along the box, this sampler gives 0.8155(12); compressed from a
// disordered fluid 0.810(2) and 0.798(4), at 30 and 15 degrees to the box.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "arrangement/arrangement.hpp"
#include "arrangement/sampler.hpp"
#include "arrangement/starts.hpp"

namespace floes {
namespace {

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

struct Chain {
    double concentration;
    int equilibration;  // sweeps
    int sweeps;         // measured, after those
    std::size_t batches;
};

Estimate psi4_of_periodic_squares(const Chain& chain) {
    constexpr int count = 400;
    constexpr int sweeps_per_sample = 10;
    const double side = std::sqrt(count / chain.concentration);
    const Rectangle square{0.5, 0.5};
    HardRectangles floes(PeriodicBox{0, 0, side, side}, square, 0, lattice_start({0, 0, side, side}, square, 0, count));
    RandomStream random(1, 0, StreamId::monte_carlo, 0);
    const Step step = tune(floes, random);
    for (int i = 0; i < chain.equilibration; ++i) floes.sweep(step, random);
    std::vector<double> series;
    for (int i = 0; i < chain.sweeps; ++i) {
        floes.sweep(step, random);
        if (i % sweeps_per_sample == 0) series.push_back(fourfold_order(floes.poses()));
    }
    return batch_means(series, chain.batches);
}

void expect_reference(const Chain& chain, const Estimate& reference) {
    const Estimate estimate = psi4_of_periodic_squares(chain);
    testing::Test::RecordProperty("psi4", testing::PrintToString(estimate.mean));
    testing::Test::RecordProperty("error", testing::PrintToString(estimate.error));
    EXPECT_LE(estimate.error, 0.01);
    EXPECT_NEAR(estimate.mean, reference.mean, 4 * std::hypot(estimate.error, reference.error));
}

TEST(HardSquares, HaveTheOrderOfTheReferenceAtConcentration050) {
    expect_reference({0.50, 2'000, 30'000, 100}, {0.0555, 0.0003});
}

TEST(HardSquares, HaveTheOrderOfTheReferenceAtConcentration065) {
    expect_reference({0.65, 10'000, 150'000, 20}, {0.126, 0.003});
}

TEST(HardSquares, HaveTheOrderOfTheReferenceAtConcentration075) {
    expect_reference({0.75, 10'000, 80'000, 10}, {0.808, 0.002});
}

}  // namespace
}  // namespace floes
