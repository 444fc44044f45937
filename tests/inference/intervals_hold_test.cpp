// That intervals hold about as often as they say, in few trials; tests/coverage/interval_coverage_test.cpp has more of
// them, of more sets.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "inference/interval.hpp"
#include "inference/known_sets.hpp"
#include "inference/posterior_load.hpp"

namespace floes {
namespace intervals_hold_test {

TEST(Intervals, OfMeansAndOfOneFurtherRunHold) {
    constexpr int trials = 300;
    for (const known::Set& set : known::verification()) {
        if (set.share > 0) continue;
        const double truth = set.mean_load();
        for (const std::size_t members : {4u, 12u}) {
            int mean = 0, further = 0;
            for (std::uint32_t trial = 0; trial < trials; ++trial) {
                RandomStream random{73, trial, StreamId::bootstrap, members};
                const std::vector<double> loads = known::draw(set, members, random, false).loads;
                const Interval found =
                    mixed_interval(loads, positive_interval(loads), apart(loads, Sides::above), Sides::above);
                mean += found.low <= truth && truth <= found.high;
                const double next = known::draw(set, 1, random, false).loads.front();
                further += found.prediction_low <= next && next <= found.prediction_high;
            }
            // Some three standard deviations of so few trials; skewed values cost up to 5 % of few members.
            EXPECT_GT(mean, 0.86 * trials) << set.name << ", " << members;
            EXPECT_GT(further, 0.9 * trials) << set.name << ", " << members;
        }
    }
}

// 24 trials of gamma distributed peaks over 8 members, of an exposure of ten times the time run: an interval of both
// tails that held always would be too wide.
TEST(Intervals, OfBothTailsHoldAndAreNoWiderThanThat) {
    constexpr int trials = 24;
    const known::Set set = known::verification()[1];
    const double truth = set.largest(80, 0.9);
    int within = 0;
    double width = 0;  // of the logarithm
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        RandomStream random{74, trial, StreamId::bootstrap, 8};
        const known::SetMembers made = known::draw(set, 8, random);
        const auto peaks = known::spans(made.peaks);
        const PosteriorLoad load(peaks, unlike_members(peaks, 0.25).out, {known::window, 0, 1e-9, made.least},
                                 averaged_shares(0.25, false));
        const Limits found = load.quantile(80 * known::window, 0.9).interval;
        within += found.low <= truth && truth <= found.high;
        width += std::log(found.high / found.low) / trials;
    }
    EXPECT_GE(within, 20);
    EXPECT_LT(width, std::log(3.6));  // 3.3; of the central 95 % of the draws 4.0
}

}  // namespace intervals_hold_test
}  // namespace floes
