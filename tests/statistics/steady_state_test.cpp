// Steady state and autocorrelation of loads with known results.

#include "statistics/load_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace floes {
namespace steady_state_test {

double normal(RandomStream& random) {
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::acos(-1.0) * random.uniform());
}

/// x_i = φ x_{i-1} + noise about `mean`, variance 1.
std::vector<double> autoregressive(double phi, std::size_t count, std::uint32_t number, double mean = 0) {
    RandomStream random{4, number, StreamId::monte_carlo, 0};
    std::vector<double> load(count);
    double x = normal(random);
    for (double& value : load) {
        value = mean + x;
        x = phi * x + std::sqrt(1 - phi * phi) * normal(random);
    }
    return load;
}

TEST(SteadyStart, FindsTheEndOfARamp) {
    std::vector<double> load = autoregressive(0.5, 4000, 1, 20);
    for (std::size_t i = 0; i < 1000; ++i) load[i] -= 20 * (1 - static_cast<double>(i) / 1000);
    const auto start = steady_start(load);
    ASSERT_TRUE(start.has_value());
    EXPECT_GT(*start, 850u);
    EXPECT_LT(*start, 1150u);
    EXPECT_EQ(*start % 80, 0u) << "50 batches of 80";
}

// By hand: 0, then 1 for ever: without the first mean the error is 0.
TEST(SteadyStart, LeavesOutWhatIsNotSteadyAndNoMore) {
    std::vector<double> load(100, 1.0);
    EXPECT_EQ(steady_start(load), 0u);
    for (std::size_t i = 0; i < 10; ++i) load[i] = 0;
    EXPECT_EQ(steady_start(load), 10u);
    load[10] = 0;  // in the mean of the samples 10 and 11
    EXPECT_EQ(steady_start(load), 12u);
}

TEST(SteadyStart, FindsNoneInALoadThatRisesAllTheTime) {
    std::vector<double> load(1000);
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = static_cast<double>(i);
    EXPECT_FALSE(steady_start(load).has_value());
}

TEST(SteadyStart, FindsNoneInNextToNothing) {
    EXPECT_FALSE(steady_start(std::vector<double>(3, 1.0)).has_value());
    EXPECT_EQ(steady_start(std::vector<double>(4, 1.0)), 0u);
}

// Before the structure meets the ice there is no load, and after that it scatters as much as its mean: means of few
// samples scatter least with the beginning in.
TEST(SteadyStart, IsNotBeforeAQuietRunUp) {
    std::vector<double> load = autoregressive(0.9, 4000, 3);
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = i < 1200 ? 0 : 30 + 20 * load[i];
    const auto start = steady_start(load);
    ASSERT_TRUE(start.has_value());
    EXPECT_GE(*start, 1200u);
    EXPECT_LE(*start, 1360u) << "two batches later";
}

// τ of an autoregressive load is (1 + φ) / (1 - φ) samples.
TEST(Autocorrelation, OfAnAutoregressiveLoad) {
    for (const double phi : {0.0, 0.9, 0.98}) {
        const std::vector<double> load = autoregressive(phi, 200000, 2);
        const Autocorrelation found = autocorrelation(load, 0.02);
        const double tau = (1 + phi) / (1 - phi);
        EXPECT_NEAR(found.time, 0.02 * tau, 0.1 * 0.02 * tau) << phi;
        EXPECT_NEAR(found.effective_samples * found.time, 200000 * 0.02, 1e-6);
    }
}

// What it is for: the spread of means of many loads is σ² over the effective samples.
TEST(Autocorrelation, TellsHowFarTheMeanIsSure) {
    constexpr int loads = 400;
    double squares = 0;
    double promised = 0;
    for (std::uint32_t number = 0; number < loads; ++number) {
        const std::vector<double> load = autoregressive(0.95, 5000, 100 + number);
        double mean = 0;
        for (const double value : load) mean += value / 5000;
        squares += mean * mean / loads;
        promised += 1 / autocorrelation(load, 0.02).effective_samples / loads;
    }
    EXPECT_NEAR(squares / promised, 1, 0.25);
}

// A load that was thinned to means tells the same, given the variance of the load itself.
TEST(Autocorrelation, IsTheSameOfAThinnedLoad) {
    constexpr int loads = 100;
    double whole = 0;
    double thinned = 0;
    for (std::uint32_t number = 0; number < loads; ++number) {
        const std::vector<double> load = autoregressive(0.95, 5000, 100 + number);
        double square = 0;
        double mean = 0;
        for (const double value : load) mean += value / 5000;
        for (const double value : load) square += (value - mean) * (value - mean) / 5000;
        whole += autocorrelation(load, 0.02).time / loads;
        thinned += autocorrelation(batch_means(load, 10), 0.2, 1, square).time / loads;
        const double time = autocorrelation(load, 0.02).time;
        EXPECT_NEAR(autocorrelation(batch_means(load, 5), 0.1, 1, square).time, time, 1e-9 * time);
    }
    EXPECT_NEAR(thinned / whole, 1, 0.05);
}

TEST(Autocorrelation, IsUndefinedForALoadThatNeverChanges) {
    EXPECT_TRUE(std::isnan(autocorrelation(std::vector<double>(100, 3.0), 0.02).time));
    EXPECT_TRUE(std::isnan(autocorrelation(std::vector<double>(19, 3.0), 0.02).effective_samples));
}

}  // namespace steady_state_test
}  // namespace floes
