#include "statistics/load_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/contract.hpp"

namespace floes {
namespace load_statistics_test {

// By the definition, with sums as they stand.
TEST(LoadStatistics, ShapeIsThatOfTheMoments) {
    std::vector<double> load;
    for (int k = 0; k < 7500; ++k) load.push_back(30 + 20 * std::sin(0.1 * k) + std::exp(3 * std::sin(0.37 * k)));
    long double mean = 0;
    for (const double value : load) mean += value;
    mean /= 7500;
    long double second = 0;
    long double third = 0;
    long double fourth = 0;
    for (const double value : load) {
        const long double off = value - mean;
        second += off * off / 7500;
        third += off * off * off / 7500;
        fourth += off * off * off * off / 7500;
    }
    const LoadStatistics found = load_statistics(load, 0.02, 3);
    EXPECT_NEAR(found.mean, static_cast<double>(mean), 1e-12 * 30);
    EXPECT_NEAR(found.sd, static_cast<double>(std::sqrt(second)), 1e-12 * found.sd);
    EXPECT_NEAR(found.skewness, static_cast<double>(third / (second * std::sqrt(second))), 1e-12);
    EXPECT_NEAR(found.excess_kurtosis, static_cast<double>(fourth / (second * second) - 3), 1e-12);
    EXPECT_TRUE(std::isnan(load_statistics(std::vector<double>(100, 7.0), 0.02, 3).skewness));
}

TEST(LoadStatistics, OfASmallWindowByHand) {
    const std::vector<double> window{1, 3, 2, 6, 5, 1};
    const LoadStatistics load = load_statistics(window, 0.02, 3);
    EXPECT_DOUBLE_EQ(load.mean, 3);
    EXPECT_DOUBLE_EQ(load.sd, std::sqrt((4 + 0 + 1 + 9 + 4 + 4) / 6.0));
    EXPECT_EQ(load.maximum, 6);
    EXPECT_EQ(load.segment_maximum, (std::vector<double>{3, 6, 5}));
    EXPECT_DOUBLE_EQ(load.mean_maximum, 14 / 3.0);
    EXPECT_DOUBLE_EQ(load.sd_maximum, std::sqrt((9 + 36 + 25) / 3.0 - 196 / 9.0));
}

// The paper's Table 3, E = 30, 60 and 200 MPa: its SD of the maxima is the population SD.
TEST(LoadStatistics, GivesThePapersMeanAndSdOfTheMaxima) {
    const auto row = [](double a, double b, double c) {
        return load_statistics(std::vector<double>{0, a, 0, b, 0, c}, 0.02, 3);
    };
    EXPECT_NEAR(row(106.58, 46.75, 126.84).mean_maximum, 93.39, 0.005);
    EXPECT_NEAR(row(106.58, 46.75, 126.84).sd_maximum, 34.00, 0.01);
    EXPECT_NEAR(row(162.22, 93.10, 98.50).mean_maximum, 117.94, 0.005);
    EXPECT_NEAR(row(162.22, 93.10, 98.50).sd_maximum, 31.39, 0.01);
    EXPECT_NEAR(row(86.48, 127.36, 150.30).mean_maximum, 121.38, 0.005);
    EXPECT_NEAR(row(86.48, 127.36, 150.30).sd_maximum, 26.39, 0.01);
}

TEST(LoadStatistics, AConstantLoadHasNoTrend) {
    const LoadStatistics load = load_statistics(std::vector<double>(100, 7.0), 0.02, 3);
    EXPECT_EQ(load.sd, 0);
    EXPECT_EQ(load.trend, 0);
    EXPECT_EQ(load.trend_p, 1);
    EXPECT_TRUE(load.steady);
}

TEST(LoadStatistics, ARampIsNotSteadyAndItsSlopeIsPerSecond) {
    std::vector<double> ramp;
    for (int k = 0; k < 900; ++k) ramp.push_back(5 - 0.25 * (0.02 * k));
    const LoadStatistics load = load_statistics(ramp, 0.02, 3);
    EXPECT_NEAR(load.trend, -0.25, 1e-12);
    EXPECT_LT(load.trend_p, 1e-12);
    EXPECT_FALSE(load.steady);
}

// Figures from numpy 1.24 and scipy 1.10:
//   k = arange(300); x = 10 + 3 sin(0.37 k) + 0.5 cos(1.9 k) + drift k
//   x.mean(), x.std(), linregress(0.02 k, x).slope, linregress(arange(15), x.reshape(15, 20).mean(1)).pvalue
TEST(LoadStatistics, AgreesWithScipy) {
    const auto series = [](double drift) {
        std::vector<double> x;
        for (int k = 0; k < 300; ++k) x.push_back(10 + 3 * std::sin(0.37 * k) + 0.5 * std::cos(1.9 * k) + drift * k);
        return load_statistics(x, 0.02, 3);
    };
    const LoadStatistics still = series(0.0005);
    EXPECT_NEAR(still.mean, 10.119631688920292, 1e-12);
    EXPECT_NEAR(still.sd, 2.143988213113682, 1e-12);
    EXPECT_NEAR(still.trend, 0.014497657180140837, 1e-12);
    EXPECT_NEAR(still.trend_p, 0.7967226981362243, 1e-9);
    EXPECT_TRUE(still.steady);
    const LoadStatistics drifting = series(0.005);
    EXPECT_NEAR(drifting.mean, 10.79238168892029, 1e-12);
    EXPECT_NEAR(drifting.trend, 0.2394976571801408, 1e-12);
    EXPECT_NEAR(drifting.trend_p, 0.00022676798280638148, 1e-9);
    EXPECT_FALSE(drifting.steady);
}

// A slow wave is correlated over its period: sample by sample its slope would be "significant", batch by batch it is
// not.
TEST(LoadStatistics, AutocorrelationDoesNotMakeATrend) {
    std::vector<double> wave;
    for (int k = 0; k < 7500; ++k) wave.push_back(30 + 15 * std::sin(2 * 3.14159265358979 * k / 1500.0));
    const LoadStatistics load = load_statistics(wave, 0.02, 3);
    EXPECT_LT(load.trend, 0);
    EXPECT_TRUE(load.steady);
}

TEST(LoadStatistics, RefusesWhatHasNoStatistics) {
    const std::vector<double> window(6, 1.0);
    EXPECT_THROW(load_statistics(window, 0.02, 0), ContractError);
    EXPECT_THROW(load_statistics(window, 0.02, 4), ContractError);
    EXPECT_THROW(load_statistics(window, 0, 3), ContractError);
    std::vector<double> broken = window;
    broken[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(load_statistics(broken, 0.02, 3), ContractError);
}

}  // namespace load_statistics_test
}  // namespace floes
