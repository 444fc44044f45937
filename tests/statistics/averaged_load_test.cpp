// Running means against closed forms, and against sums that are taken anew at every step.

#include "statistics/averaged_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/contract.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {
namespace averaged_load_test {

constexpr double step = 0.02;

AveragedLoad over(const std::vector<double>& window, double time, int segments = 3) {
    const std::vector times{time};
    return averaged_load(window, {.time_step = step, .segments = segments, .times = times, .peak_separation = 5})
        .front();
}

TEST(AveragedLoad, OfAConstantLoadIsThatLoad) {
    const AveragedLoad found = over(std::vector<double>(300, 3.75), 0.5);
    EXPECT_EQ(found.time, 0.5);
    EXPECT_EQ(found.sd, 0);
    EXPECT_EQ(found.segment_maximum, std::vector<double>(3, 3.75));
    EXPECT_EQ(found.mean_maximum, 3.75);
    EXPECT_EQ(found.sd_maximum, 0);
}

// Each running mean is the ramp in the middle of its steps; N of them in a row have the variance (N² - 1) / 12 steps².
TEST(AveragedLoad, OfARampIsTheRampEarlier) {
    std::vector<double> ramp(300);
    std::iota(ramp.begin(), ramp.end(), 0.0);
    const int steps = 25;
    const AveragedLoad found = over(ramp, steps * step);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(found.segment_maximum[static_cast<std::size_t>(k)], 100 * k + 99 - 0.5 * (steps - 1), 1e-10);
    const double count = 300 - steps + 1;
    EXPECT_NEAR(found.sd, std::sqrt((count * count - 1) / 12), 1e-10);
    EXPECT_NEAR(found.mean_maximum, 199 - 0.5 * (steps - 1), 1e-10);
    EXPECT_NEAR(found.sd_maximum, 100 * std::sqrt(2.0 / 3), 1e-10);
}

// The spike of one step is in as many running means as the time has steps: the last of these end in the next segment.
TEST(AveragedLoad, OfASpikeIsItsImpulseOverTheTime) {
    std::vector<double> spike(300, 0.0);
    spike[99] = 1200;
    EXPECT_EQ(over(spike, 0.1).segment_maximum, (std::vector<double>{240, 240, 0}));
    spike[99] = 0;
    spike[95] = 1200;
    EXPECT_EQ(over(spike, 0.1).segment_maximum, (std::vector<double>{240, 0, 0}));
    EXPECT_EQ(over(spike, step).segment_maximum, (std::vector<double>{1200, 0, 0}));
}

// Only what lies wholly inside counts: a spike in the first step is in one running mean, the first.
TEST(AveragedLoad, BeginsWithTheFirstWholeRunningMean) {
    std::vector<double> spike(9, 0.0);
    spike[0] = 30;
    const AveragedLoad found = over(spike, 3 * step);
    EXPECT_EQ(found.segment_maximum, (std::vector<double>{10, 0, 0}));
    EXPECT_NEAR(found.sd, 10 * std::sqrt(1.0 / 7 - 1.0 / 49), 1e-14);  // of seven running means
}

// sin over n steps: the amplitude falls by sin(n φ / 2) / (n sin(φ / 2)), φ the phase of a step.
TEST(AveragedLoad, OfASinusoidFallsByItsSinc) {
    const int period = 40;
    const int steps = 10;
    const double phase = 2 * std::numbers::pi / period;
    std::vector<double> wave(12 * period + steps - 1);  // whole periods of running means
    for (std::size_t k = 0; k < wave.size(); ++k)
        wave[k] = std::sin(phase * (static_cast<double>(k) - 0.5 * (steps - 1)));  // some mean meets a crest
    const double amplitude = std::sin(0.5 * steps * phase) / (steps * std::sin(0.5 * phase));
    const AveragedLoad found = over(wave, steps * step);
    EXPECT_NEAR(found.sd, amplitude / std::numbers::sqrt2, 1e-12);
    for (const double maximum : found.segment_maximum) EXPECT_NEAR(maximum, amplitude, 1e-12);
}

TEST(AveragedLoad, OverOneStepIsTheLoadItself) {
    std::vector<double> load(300);
    for (std::size_t k = 0; k < load.size(); ++k) load[k] = std::fmod(7919.0 * static_cast<double>(k * k), 101);
    const LoadStatistics plain = load_statistics(load, step, 3);
    const AveragedLoad found = over(load, step);
    EXPECT_EQ(found.segment_maximum, plain.segment_maximum);
    EXPECT_EQ(found.sd, plain.sd);
    EXPECT_EQ(found.mean_maximum, plain.mean_maximum);
    EXPECT_EQ(found.sd_maximum, plain.sd_maximum);
}

// A sum without compensation keeps 2 in 1e4 here after the peak has left.
TEST(RunningMeans, ForgetAPeakThatHasLeft) {
    std::vector<double> load(100000);
    for (std::size_t k = 0; k < load.size(); ++k)
        load[k] = k % 1000 == 0 ? 1e12 / 3 : std::fmod(0.1 * static_cast<double>(k), 1.7);
    const std::size_t count = 50;
    const std::vector<double> means = running_means(load, count);
    ASSERT_EQ(means.size(), load.size() - count + 1);
    for (std::size_t k = 0; k < means.size(); k += 37) {
        const double anew = std::accumulate(&load[k], &load[k] + count, 0.0) / static_cast<double>(count);
        EXPECT_NEAR(means[k], anew, 1e-12 * anew) << k;
    }
}

TEST(RunningMeans, AreNoneOfFewerValues) {
    EXPECT_TRUE(running_means(std::vector<double>{1, 2}, 3).empty());
}

TEST(AveragedLoad, RefusesATimeLongerThanASegment) {
    const std::vector<double> load(9, 1.0);
    EXPECT_NO_THROW(over(load, 3 * step));
    EXPECT_THROW(over(load, 4 * step), ContractError);
    EXPECT_THROW(over(load, 20 * step), ContractError);
}

}  // namespace averaged_load_test
}  // namespace floes
