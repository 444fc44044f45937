// Design loads: of peaks that are known, and what the parts have to do with each other. How often the intervals hold:
// interval_coverage_test.cpp.

#include "inference/design_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace floes {
namespace design_load_test {

/// Windows of 100 s with about 20 exponential peaks of scale 20 N above 30 N each, and five segments.
std::vector<PeakRow> exponential_rows(std::size_t count, double scale = 20, std::uint32_t number = 0) {
    RandomStream random{21, number, StreamId::bootstrap, 0};
    std::vector<PeakRow> rows(count);
    for (PeakRow& row : rows) {
        for (int segment = 0; segment < 5; ++segment) {
            double largest = 30;
            for (int k = 0; k < 4; ++k) {
                row.peaks.push_back(30 - scale * std::log(random.uniform(1e-16, 1)));
                largest = std::max(largest, row.peaks.back());
            }
            row.segment_maxima.push_back(largest);
        }
        std::ranges::sort(row.peaks, std::ranges::greater{});
    }
    return rows;
}

const Exposure three_times{.time = 30000, .probabilities = {0.5, 0.9}};

constexpr Measured measured{.window = 100, .segment = 20, .separation = 1e-9, .mean = 20};  // hides nothing

double truth(double p) {
    return 30 + 20 * std::log(30000 * 0.2 / -std::log(p));
}

TEST(DesignLoad, OfExponentialPeaksIsWhatTheirTailSays) {
    const DesignLoad load = design_load(exponential_rows(100), measured, three_times);
    ASSERT_TRUE(load.valid());
    EXPECT_EQ(load.arrangements, 100u);
    EXPECT_EQ(load.time_run, 10000);
    EXPECT_EQ(load.peaks, 500u);  // a quarter of 2000
    EXPECT_NEAR(load.threshold, 30 + 20 * std::log(4), 3);
    ASSERT_EQ(load.estimates.size(), 5u);
    for (const DesignLoadEstimate& made : load.estimates) {
        for (std::size_t k = 0; k < 2; ++k) {
            const LoadFigure& figure = made.quantiles[k];
            if (made.method == LargestBy::both_tails) {
                EXPECT_LT(figure.interval.low, figure.value);
                EXPECT_GT(figure.interval.high, figure.value);
            } else {
                EXPECT_TRUE(std::isnan(figure.interval.low)) << name_of(made.method);
            }
            EXPECT_NEAR(figure.value / truth(three_times.probabilities[k]), 1, 0.25) << name_of(made.method);
        }
        EXPECT_LT(made.quantiles[0].value, made.quantiles[1].value);
        EXPECT_GT(made.expected.value, made.quantiles[0].value);  // the mean of a largest load is above its median
        EXPECT_LT(made.expected.value, made.quantiles[1].value);
    }
}

TEST(DesignLoad, OfMembersThatStandOutHasThemAsAClass) {
    std::vector<PeakRow> rows = exponential_rows(40);
    for (const std::size_t out : {7u, 23u})
        for (double& peak : rows[out].peaks) peak *= 5;
    const DesignLoad load = design_load(rows, measured, three_times);
    EXPECT_EQ(load.unlike.out, (std::vector<std::size_t>{7, 23}));
    // 300 windows have about 15 such members, each with 20 peaks.
    const double high = 5 * (30 + 20 * std::log(15 * 20 / -std::log(0.9)));
    const LoadFigure& figure = load.estimates.front().quantiles[1];
    EXPECT_LT(figure.interval.low, high);
    EXPECT_GT(figure.interval.high, high);
    EXPECT_LT(figure.interval.high, 5 * figure.interval.low);
    EXPECT_LT(load.estimates.front().expected.value, figure.value);
}

// A tail so heavy that the mean of the largest is infinite, or nearly, has no expected load.
TEST(DesignLoad, ExpectsNothingOfTailsWithoutAMean) {
    std::vector<PeakRow> rows = exponential_rows(40);
    for (PeakRow& row : rows)
        for (double& peak : row.peaks) peak = 30 * std::exp((peak - 30) / 20);  // shape 1
    const DesignLoad load = design_load(rows, measured, three_times);
    ASSERT_GE(load.pareto.shape, 0.9);
    EXPECT_TRUE(std::isnan(load.estimates[1].expected.value));
    EXPECT_TRUE(std::isfinite(load.estimates[1].quantiles[1].value));
    EXPECT_LT(load.estimates[0].expected.value, load.estimates[0].quantiles[1].value);
}

TEST(DesignLoad, OfLoadsTwiceAsHighIsTwiceAsHigh) {
    const std::vector<PeakRow> rows = exponential_rows(30);
    std::vector<PeakRow> doubled = rows;
    for (PeakRow& row : doubled) {
        for (double& value : row.peaks) value *= 2;
        for (double& value : row.segment_maxima) value *= 2;
    }
    const DesignLoad one = design_load(rows, measured, three_times);
    const DesignLoad other = design_load(doubled, {100, 20, 1e-9, 40}, three_times);
    for (std::size_t method = 0; method < one.estimates.size(); ++method) {
        const LoadFigure& low = one.estimates[method].quantiles[1];
        const LoadFigure& high = other.estimates[method].quantiles[1];
        EXPECT_NEAR(high.value / low.value, 2, 1e-3) << name_of(one.estimates[method].method);
    }
    EXPECT_NEAR(other.estimates[0].quantiles[1].interval.high / one.estimates[0].quantiles[1].interval.high, 2, 2e-2);
}

TEST(DesignLoad, IsTheSameAgain) {
    const DesignLoad one = design_load(exponential_rows(30), measured, three_times);
    const DesignLoad other = design_load(exponential_rows(30), measured, three_times);
    EXPECT_EQ(one.estimates[0].quantiles[1].interval, other.estimates[0].quantiles[1].interval);
    EXPECT_EQ(one.draws, other.draws);
}

TEST(DesignLoad, OfTooFewPeaksIsNone) {
    EXPECT_FALSE(design_load(exponential_rows(2), measured, three_times).valid());
    EXPECT_FALSE(design_load({}, measured, three_times).valid());
    EXPECT_FALSE(
        design_load(exponential_rows(30), {100, 20, 1e-9, 500}, three_times).valid());  // no peak above the mean
}

TEST(DesignLoad, OverThresholdsAgreesWithItself) {
    const std::vector<PeakRow> rows = exponential_rows(50);
    const DesignLoad load = design_load(rows, measured, three_times);
    const auto found = over_thresholds(rows, measured, three_times, {0.5, 0.25, 1e-3});
    EXPECT_NEAR(found[1][1] / load.estimates[0].quantiles[1].value, 1, 0.2);
    EXPECT_NEAR(found[0][1] / found[1][1], 1, 0.2);
    EXPECT_TRUE(std::isnan(found[2][1]));  // a single peak
}

}  // namespace design_load_test
}  // namespace floes
