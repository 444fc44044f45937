// Tails of peaks: what they were drawn from, closed forms, and the largest peak of an exposure.

#include "inference/tails.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace floes {
namespace tails_test {

constexpr double rate = 0.1;  // per s, above the threshold

Tail pareto(double shape) {
    return {.kind = TailKind::pareto, .threshold = 50, .rate = rate, .scale = 20, .shape = shape};
}

Tail weibull(double shape) {
    return {.kind = TailKind::weibull, .threshold = 50, .rate = rate, .origin = 30, .scale = 15, .shape = shape};
}

/// Excesses of `count` peaks drawn from the tail.
std::vector<double> excesses(const Tail& from, std::size_t count, std::uint32_t number = 0) {
    RandomStream random{12, number, StreamId::bootstrap, 0};
    std::vector<double> values(count);
    for (double& value : values) value = level_at(from, from.rate * random.uniform(1e-16, 1)) - from.threshold;
    return values;
}

Tail fitted(TailKind kind, const std::vector<double>& values, double time) {
    return fit_tail(kind, values, std::vector<double>(values.size(), 1), 50, 30, time);
}

Tail refit(const Tail& from, std::size_t count) {
    return fitted(from.kind, excesses(from, count), static_cast<double>(count) / from.rate);
}

TEST(Tails, LevelAndRateAreInverse) {
    for (const Tail& tail :
         {pareto(-0.3), pareto(0), pareto(1e-12), pareto(0.3), weibull(0.7), weibull(1), weibull(2)}) {
        for (const double rarer : {1.0, 0.3, 1e-3, 1e-8})
            EXPECT_NEAR(rate_above(tail, level_at(tail, rate * rarer)) / (rate * rarer), 1, 1e-9) << tail.shape;
        EXPECT_EQ(level_at(tail, 2 * rate), 50);
        EXPECT_EQ(rate_above(tail, 40), rate);
    }
    EXPECT_EQ(rate_above(pareto(-0.5), 90.001), 0);  // beyond the upper end at 90
}

TEST(Tails, OfShapesThatMeanTheSameAreTheSame) {
    for (const double load : {55.0, 80.0, 200.0}) {
        const double exponential = rate * std::exp(-(load - 50) / 20);
        EXPECT_NEAR(rate_above(pareto(0), load) / exponential, 1, 1e-12);
        Tail same = weibull(1);
        same.scale = 20;
        EXPECT_NEAR(rate_above(same, load) / exponential, 1, 1e-12);
        EXPECT_NEAR(rate_above(pareto(1e-7), load) / exponential, 1, 1e-4);
    }
    // A Gaussian process of mean 30 and SD 15/√2 crosses x upwards in proportion to exp(-(x - 30)²/15²).
    EXPECT_NEAR(rate_above(weibull(2), 70) / (rate * std::exp((400.0 - 1600.0) / 225)), 1, 1e-12);
}

// Five standard errors of maximum likelihood: of ξ (1 + ξ)/√n, of the scale √(2 (1 + ξ)/n).
TEST(Tails, RecoverParetoPeaks) {
    const double n = 10000;
    for (const double shape : {-0.3, -0.1, 0.0, 0.2}) {
        const Tail found = refit(pareto(shape), static_cast<std::size_t>(n));
        EXPECT_NEAR(found.shape, shape, 5 * (1 + shape) / std::sqrt(n)) << shape;
        EXPECT_NEAR(found.scale / 20, 1, 5 * std::sqrt(2 * (1 + shape) / n)) << shape;
        EXPECT_NEAR(found.rate, rate, 1e-12);
    }
}

// The shape and scale of a Weibull tail go together, the levels that they give do not: within 3 % at a thousandth of
// the rate from 10,000 peaks.
TEST(Tails, RecoverWeibullPeaks) {
    for (const double shape : {0.7, 1.0, 2.0}) {
        const Tail from = weibull(shape);
        const Tail found = refit(from, 10000);
        EXPECT_NEAR(found.shape, shape, 0.1 * shape + 0.05) << shape;
        for (const double rarer : {0.1, 1e-3})
            EXPECT_NEAR(level_at(found, rate * rarer) / level_at(from, rate * rarer), 1, 0.03) << shape;
    }
}

/// log likelihood of a Pareto tail's excesses.
double pareto_likelihood(const std::vector<double>& values, double scale, double shape) {
    double sum = 0;
    for (const double value : values) sum -= std::log(scale) + (1 + 1 / shape) * std::log1p(shape * value / scale);
    return sum;
}

double weibull_likelihood(const std::vector<double>& values, double scale, double shape) {
    double sum = 0;
    for (const double value : values) {
        const double z = (20 + value) / scale;
        sum += std::log(shape / scale) + (shape - 1) * std::log(z) - std::pow(z, shape) + std::pow(20 / scale, shape);
    }
    return sum;
}

TEST(Tails, TheFitIsTheMostLikely) {
    const std::vector<double> values = excesses(pareto(0.15), 200);
    const Tail one = fitted(TailKind::pareto, values, 2000);
    EXPECT_NEAR(one.log_likelihood, pareto_likelihood(values, one.scale, one.shape), 1e-6);
    const Tail other = fitted(TailKind::weibull, values, 2000);
    EXPECT_NEAR(other.log_likelihood, weibull_likelihood(values, other.scale, other.shape), 1e-6);
    for (const double step : {-0.02, 0.02}) {
        EXPECT_LT(pareto_likelihood(values, one.scale * (1 + step), one.shape), one.log_likelihood);
        EXPECT_LT(pareto_likelihood(values, one.scale, one.shape + step), one.log_likelihood);
        EXPECT_LT(weibull_likelihood(values, other.scale * (1 + step), other.shape), other.log_likelihood);
        EXPECT_LT(weibull_likelihood(values, other.scale, other.shape + step), other.log_likelihood);
    }
}

TEST(Tails, OfTooFewOrEqualPeaksAreNone) {
    EXPECT_FALSE(fitted(TailKind::pareto, excesses(pareto(0.1), fewest_peaks - 1), 100).valid());
    EXPECT_FALSE(fitted(TailKind::weibull, std::vector<double>(100, 3.0), 100).valid());
}

// Peaks below a near limit are likelier the closer the tail's end is to the highest; the fit stops at ξ = -1/2.
TEST(Tails, OfPeaksBelowALimitStopAtTheLowestShape) {
    std::vector<double> values;
    for (int k = 1; k <= 100; ++k) values.push_back(0.1 * k);
    const Tail found = fitted(TailKind::pareto, values, 1000);
    ASSERT_TRUE(found.valid());
    EXPECT_NEAR(found.shape, -0.5, 1e-6);
    EXPECT_GE(found.threshold - found.scale / found.shape, 60);  // its end lies above the highest
}

TEST(Tails, APeakOfWeightTwoIsTwoPeaks) {
    const std::vector<double> values = excesses(pareto(0.1), 50);
    std::vector<double> twice = values;
    twice.insert(twice.end(), values.begin(), values.end());
    for (const TailKind kind : {TailKind::pareto, TailKind::weibull}) {
        const Tail one = fit_tail(kind, values, std::vector<double>(50, 2), 50, 30, 100);
        const Tail other = fitted(kind, twice, 100);
        EXPECT_EQ(one.rate, other.rate);
        EXPECT_NEAR(one.shape, other.shape, 1e-6);
        EXPECT_NEAR(one.scale / other.scale, 1, 1e-6);
        EXPECT_NEAR(one.log_likelihood, other.log_likelihood, 1e-6);
    }
}

// Of n exponential peaks: the quantile at p is u + σ log(n / -log p), the mean u + σ (log n + 0.5772) for large n.
TEST(Tails, TheLargestOfExponentialPeaksIsGumbel) {
    const double exposure = 36000;
    EXPECT_NEAR(quantile_of_largest(pareto(0), exposure, 0.9), 50 + 20 * std::log(3600 / -std::log(0.9)), 1e-9);
    EXPECT_NEAR(expected_largest(pareto(0), exposure), 50 + 20 * (std::log(3600) + 0.5772156649), 1e-6);
    // Of Pareto peaks: u + σ/ξ (n^ξ Γ(1 - ξ) - 1).
    for (const double shape : {-0.2, 0.2}) {
        const double mean = 50 + 20 / shape * (std::pow(3600, shape) * std::tgamma(1 - shape) - 1);
        EXPECT_NEAR(expected_largest(pareto(shape), exposure) / mean, 1, 1e-6) << shape;
    }
}

TEST(Tails, AShortExposureStaysAtTheThreshold) {
    EXPECT_EQ(quantile_of_largest(pareto(0.1), 1, 0.5), 50);
    EXPECT_NEAR(expected_largest(pareto(0), 1e-3), 50, 0.01);
}

}  // namespace tails_test
}  // namespace floes
