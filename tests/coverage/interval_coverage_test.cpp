// How often the intervals of a mean, of one further run and of a design load hold, and how often a steady load is seen
// to rise or fall, over the sets for verification. docs/statistics.md has the result. Label slow: FLOES_TRIALS gives
// the trials of a row.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "inference/interval.hpp"
#include "inference/known_sets.hpp"
#include "inference/paired.hpp"
#include "inference/posterior_load.hpp"

namespace floes {
namespace interval_coverage_test {

constexpr double times = 10;  // the time run, of a design load's exposure
constexpr int cheap = 20;     // times as many trials of means

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return quantile_of_sorted(values, 0.5);
}

struct Held {
    int of = 0, within = 0, below = 0;
    std::vector<double> widths;

    void add(const Limits& limits, double truth, double width) {
        ++of;
        within += limits.low <= truth && truth <= limits.high;
        below += limits.high < truth;
        widths.push_back(width);
    }
    double share() const { return static_cast<double>(within) / of; }
};

struct Row {
    std::size_t set;
    std::size_t members;
};

class IntervalCoverage : public testing::TestWithParam<Row> {};

TEST_P(IntervalCoverage, IsAsTheIntervalsSay) {
    const auto [number, members] = GetParam();
    const known::Set set = known::verification()[number];
    const char* given = std::getenv("FLOES_TRIALS");
    const int trials = given != nullptr ? std::atoi(given) : 100;
    const double mean = set.mean_load(), largest = set.largest(times * static_cast<double>(members), 0.9);
    std::map<std::string, Held> held;
    // No sample says what is not in it.
    const auto for_each_sample = [&](std::uint32_t stream, int samples, bool with_peaks, const auto& use) {
        for (std::uint32_t trial = 0, met = 0; met < static_cast<std::uint32_t>(samples); ++trial) {
            RandomStream random{stream, trial, StreamId::bootstrap, 1000 * number + members};
            const known::SetMembers made = known::draw(set, members, random, with_peaks);
            if (set.share > 0 && !made.other) continue;
            ++met;
            use(made, random);
        }
    };
    for_each_sample(71, cheap * trials, false, [&](const known::SetMembers& made, RandomStream& random) {
        const Interval found =
            mixed_interval(made.loads, positive_interval(made.loads), apart(made.loads, Sides::above), Sides::above);
        held["mean"].add({found.low, found.high}, mean, (found.high - found.low) / mean);
        for (const double further : known::draw(set, 5, random, false).loads)
            held["one further run"].add({found.prediction_low, found.prediction_high}, further,
                                        (found.prediction_high - found.prediction_low) / mean);
    });
    for_each_sample(72, trials, true, [&](const known::SetMembers& made, RandomStream&) {
        const auto peaks = known::spans(made.peaks);
        const PosteriorLoad load(peaks, unlike_members(peaks, 0.25).out, {known::window, 0, 1e-9, made.least},
                                 averaged_shares(0.25, false));
        if (!load.valid()) return;
        const LoadFigure figure = load.quantile(times * static_cast<double>(members) * known::window, 0.9);
        held["design load, both tails"].add(figure.interval, largest, figure.interval.high / figure.interval.low);
    });
    for (const auto& [method, one] : held)
        fmt::print("| interval | {} | {} | {} | {:.0f} | {:.0f} | {:.2f} |\n", method, set.name, members,
                   100 * one.share(), 100.0 * one.below / one.of, median(one.widths));
    std::fflush(stdout);
    // Three standard deviations of so few trials below 90 %; heavy and unlike values cost some more with few members.
    const double least = 0.88 - 3 * std::sqrt(0.88 * 0.12 / trials);
    for (const auto& [method, one] : held) EXPECT_GE(one.share(), least) << method;
}

std::vector<Row> rows() {
    std::vector<Row> all;
    for (std::size_t set = 0; set < known::verification().size(); ++set)
        for (const std::size_t members : {4u, 8u, 20u, 50u}) all.push_back({set, members});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Rows, IntervalCoverage, testing::ValuesIn(rows()));

}  // namespace interval_coverage_test
}  // namespace floes
