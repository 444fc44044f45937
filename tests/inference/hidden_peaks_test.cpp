// Peaks hidden by higher ones: Rényi's closed form, and independent events declustered.

#include "inference/tails.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "statistics/averaged_load.hpp"

namespace floes {
namespace hidden_peaks_test {

TEST(HiddenPeaks, AreNoneWherePeaksAreRare) {
    EXPECT_EQ(events_per_peak(0), 1);
    // 1/θ' = exp(2 u - u²/2 + …) and θ = u - u² + …, so 1/θ' = 1 + 2 θ + ….
    EXPECT_NEAR(events_per_peak(0.01), 1.02, 5e-4);
}

// θ(1) and θ'(1) by quadrature at another step than the table's: exponent Ein(1) = 0.7965995993.
TEST(HiddenPeaks, FollowRenyi) {
    double kept = 0, exponent = 0;
    const int steps = 200000;
    for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        exponent += -std::expm1(-t) / t / steps;
        kept += std::exp(-2 * (exponent + std::expm1(-t) / t / (2 * steps))) / steps;
    }
    EXPECT_NEAR(exponent, 0.7965995993, 1e-9);
    EXPECT_NEAR(events_per_peak(kept), std::exp(2 * 0.7965995993), 1e-4);
}

TEST(HiddenPeaks, NeverFall) {
    double before = 1;
    for (double kept = 0; kept < 0.8; kept += 0.001) {
        EXPECT_GE(events_per_peak(kept), before);
        before = events_per_peak(kept);
    }
    EXPECT_LT(before, 100);
}

// Events at random with exponential heights: weighted by what hides them, the declustered ones above any level are as
// many as there were events. Up to 0.45 peaks in a separation, where half of the events are hidden.
TEST(HiddenPeaks, AreMadeUpFor) {
    RandomStream random{4, 0, StreamId::bootstrap, 0};
    constexpr std::size_t apart = 500;
    std::vector<double> load(4'000'000, 0);
    std::vector<double> heights;
    for (double& value : load) {
        if (random.uniform(0, 1) > 0.002) continue;  // one event in a separation
        value = 1 - std::log(random.uniform(1e-16, 1));
        heights.push_back(value);
    }
    const std::vector<double> peaks = declustered_peaks(load, apart, 0.5);
    std::ranges::sort(heights, std::ranges::greater{});
    double events = 0;
    std::size_t seen = 0;
    for (const double share : {0.05, 0.2, 0.5, 0.8}) {
        const auto true_count = static_cast<std::size_t>(share * static_cast<double>(heights.size()));
        const double level = heights[true_count];
        for (; seen < peaks.size() && peaks[seen] > level; ++seen)
            events += events_per_peak((static_cast<double>(seen) + 0.5) * apart / static_cast<double>(load.size()));
        // Five standard errors of the number of peaks seen.
        EXPECT_NEAR(events / static_cast<double>(true_count), 1, 5 / std::sqrt(static_cast<double>(seen))) << share;
        if (share > 0.4) {
            EXPECT_LT(static_cast<double>(seen), 0.75 * static_cast<double>(true_count));
        }
    }
}

}  // namespace hidden_peaks_test
}  // namespace floes
