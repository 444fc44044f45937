// How far design loads are off by each method, and how often the interval of both tails holds, for processes whose
// largest value is known: exposures of one and ten times the time run. docs/design_load.md has the result. Several
// minutes: label slow.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "inference/design_load.hpp"
#include "inference/known_processes.hpp"
#include "statistics/averaged_load.hpp"

namespace floes {
namespace design_coverage_test {

constexpr std::size_t arrangements = 100;
constexpr std::array probabilities{0.5, 0.9};

PeakRow row_of(const std::vector<double>& load) {
    double mean = 0;
    for (const double value : load) mean += value / static_cast<double>(load.size());
    PeakRow row{declustered_peaks(load, known::samples(known::separation), mean), {}};
    const std::size_t steps = known::samples(known::segment);
    for (std::size_t first = 0; first < load.size(); first += steps)
        row.segment_maxima.push_back(*std::max_element(load.begin() + static_cast<std::ptrdiff_t>(first),
                                                       load.begin() + static_cast<std::ptrdiff_t>(first + steps)));
    return row;
}

struct Held {
    int within = 0;
    double ratio = 0;  ///< sum of estimate / truth
};

/// Of each method, at each probability.
std::vector<std::array<Held, probabilities.size()>> try_often(const known::Process& process, double times, int trials) {
    std::vector<std::array<Held, probabilities.size()>> held(5);
    const Exposure exposure{.time = times * known::window * arrangements,
                            .probabilities = {probabilities.begin(), probabilities.end()}};
    for (int trial = 0; trial < trials; ++trial) {
        RandomStream random{33, static_cast<std::uint32_t>(trial), StreamId::bootstrap, 0};
        std::vector<PeakRow> rows;
        double mean = 0;
        for (std::size_t k = 0; k < arrangements; ++k) {
            const std::vector<double> load = process.load(random);
            for (const double value : load) mean += value / static_cast<double>(load.size() * arrangements);
            rows.push_back(row_of(load));
        }
        const DesignLoad found = design_load(rows, {known::window, known::segment, known::separation, mean}, exposure);
        for (std::size_t method = 0; method < found.estimates.size(); ++method) {
            for (std::size_t k = 0; k < probabilities.size(); ++k) {
                const double truth = known::largest(process, exposure.time, probabilities[k]);
                const LoadFigure& figure = found.estimates[method].quantiles[k];
                Held& one = held[method][k];
                one.within += figure.interval.low <= truth && truth <= figure.interval.high;
                one.ratio += figure.value / truth;
            }
        }
    }
    return held;
}

int trials() {
    const char* given = std::getenv("FLOES_TRIALS");
    return given != nullptr ? std::atoi(given) : 100;
}

class DesignCoverage : public testing::TestWithParam<std::size_t> {};

TEST_P(DesignCoverage, IsAsTheIntervalsSay) {
    const known::Process process = known::all()[GetParam()];
    const int count = trials();
    // Of 100 trials with 90 % the count is above 81 with 99.8 %.
    const double least = 0.9 - 3 * std::sqrt(0.9 * 0.1 / count);
    for (const double times : {1.0, 10.0}) {
        const auto held = try_often(process, times, count);
        for (std::size_t method = 0; method < held.size(); ++method)
            for (std::size_t k = 0; k < probabilities.size(); ++k)
                fmt::print("| design | {} | {:g} | {} | {:g} | {:+.1f} % |\n", process.name, times,
                           name_of(static_cast<LargestBy>(method)), probabilities[k],
                           100 * (held[method][k].ratio / count - 1));
        for (std::size_t k = 0; k < probabilities.size(); ++k)
            EXPECT_GE(static_cast<double>(held[0][k].within) / count, least) << process.name << ", " << times;
    }
}

INSTANTIATE_TEST_SUITE_P(Processes, DesignCoverage, testing::Range<std::size_t>(0, 5));

}  // namespace design_coverage_test
}  // namespace floes
