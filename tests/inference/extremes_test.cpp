// Fits of maxima: recovered parameters, closed forms; against scipy: tests/inference/summarize_against_scipy.py.

#include "inference/extremes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "core/random.hpp"

namespace floes {
namespace extremes_test {

std::vector<double> sample(const ExtremeFit& from, std::size_t count, std::uint32_t number = 0) {
    RandomStream random{11, number, StreamId::monte_carlo, 0};
    std::vector<double> values(count);
    for (double& value : values) value = extreme_quantile(from, random.uniform(1e-16, 1));
    return values;
}

TEST(Extremes, QuantileAndProbabilityAreInverse) {
    for (const double shape : {-0.3, 0.0, 1e-12, 0.2}) {
        const ExtremeFit fit{100, 20, shape};
        for (const double p : {0.01, 0.5, 0.99, 0.9999}) {
            EXPECT_NEAR(extreme_cdf(fit, extreme_quantile(fit, p)), p, 1e-12) << shape;
        }
    }
    EXPECT_EQ(extreme_cdf({0, 1, -0.5}, 2.5), 1.0);  // beyond the upper end at 2
    EXPECT_EQ(extreme_cdf({0, 1, 0.5}, -2.5), 0.0);
    EXPECT_EQ(log_likelihood({0, 1, 0.5}, std::vector<double>{-2.5}), -std::numeric_limits<double>::infinity());
}

// Standard errors of maximum likelihood at n = 4000 (Gumbel: 1.05 and 0.78 scale / √n; GEV a little more): five of
// them.
TEST(Extremes, RecoversWhatTheMaximaWereDrawnFrom) {
    const double error = 20 / std::sqrt(4000.0);
    const ExtremeFit gumbel = fit_maxima(sample({100, 20, 0}, 4000), ExtremeKind::gumbel);
    EXPECT_NEAR(gumbel.location, 100, 5 * 1.05 * error);
    EXPECT_NEAR(gumbel.scale, 20, 5 * 0.78 * error);
    for (const double shape : {-0.25, 0.0, 0.25}) {
        const ExtremeFit gev = fit_maxima(sample({100, 20, shape}, 4000), ExtremeKind::gev);
        EXPECT_NEAR(gev.location, 100, 5 * 1.2 * error) << shape;
        EXPECT_NEAR(gev.scale, 20, 5 * 1.2 * error) << shape;
        EXPECT_NEAR(gev.shape, shape, 5 * 0.9 / std::sqrt(4000.0)) << shape;
    }
}

TEST(Extremes, HaveNoFitWhereTheShapeEnds) {
    EXPECT_FALSE(fit_maxima(sample({100, 20, 1.5}, 400), ExtremeKind::gev).valid());
    EXPECT_TRUE(fit_maxima(sample({100, 20, 0.7}, 400), ExtremeKind::gev).valid());
}

// At the maximum every direction goes down.
TEST(Extremes, TheFitIsTheMostLikely) {
    const std::vector<double> maxima = sample({100, 20, 0.1}, 60);
    const ExtremeFit gev = fit_maxima(maxima, ExtremeKind::gev);
    const ExtremeFit gumbel = fit_maxima(maxima, ExtremeKind::gumbel);
    EXPECT_DOUBLE_EQ(gev.log_likelihood, log_likelihood(gev, maxima));
    EXPECT_GE(gev.log_likelihood, gumbel.log_likelihood);
    EXPECT_GE(gumbel.log_likelihood, fit_by_l_moments(maxima, ExtremeKind::gumbel).log_likelihood);
    EXPECT_GE(gev.log_likelihood, fit_by_l_moments(maxima, ExtremeKind::gev).log_likelihood);
    for (const double step : {-1e-3, 1e-3}) {
        EXPECT_LT(log_likelihood({gev.location + 20 * step, gev.scale, gev.shape}, maxima), gev.log_likelihood);
        EXPECT_LT(log_likelihood({gev.location, gev.scale * (1 + step), gev.shape}, maxima), gev.log_likelihood);
        EXPECT_LT(log_likelihood({gev.location, gev.scale, gev.shape + step}, maxima), gev.log_likelihood);
        EXPECT_LT(log_likelihood({gumbel.location + 20 * step, gumbel.scale, 0}, maxima), gumbel.log_likelihood);
        EXPECT_LT(log_likelihood({gumbel.location, gumbel.scale * (1 + step), 0}, maxima), gumbel.log_likelihood);
    }
}

// python3: x = np.array([…]); stats.gumbel_r.fit(x); stats.genextreme.fit(x) sharpened by minimize(…,
// method="Nelder-Mead", options=dict(xatol=1e-10, fatol=1e-12)); stats.anderson(x, "gumbel_r").statistic. scipy 1.10.1
TEST(Extremes, AgreeWithScipy) {
    const std::vector<double> maxima{93.4, 106.6, 46.8,  126.8, 117.9,  88.2,  143.1, 161.3, 101.2, 79.5,
                                     95.7, 134.0, 112.4, 70.9,  121.38, 152.6, 84.3,  99.9,  108.8, 187.5};
    const ExtremeFit gumbel = fit_maxima(maxima, ExtremeKind::gumbel);
    EXPECT_NEAR(gumbel.location, 96.04681478869419, 1e-6);
    EXPECT_NEAR(gumbel.scale, 29.436488177023854, 1e-6);
    EXPECT_NEAR(gumbel.log_likelihood, -98.22149509627528, 1e-9);
    EXPECT_NEAR(distances(gumbel, maxima).anderson_darling, 0.19449467392598407, 1e-7);
    const ExtremeFit gev = fit_maxima(maxima, ExtremeKind::gev);
    EXPECT_NEAR(gev.location, 98.919614, 1e-4);
    EXPECT_NEAR(gev.scale, 30.106112, 1e-4);
    EXPECT_NEAR(gev.shape, -0.1825112, 1e-5);
    EXPECT_NEAR(gev.log_likelihood, -97.5683070036179, 1e-9);
}

TEST(Extremes, FollowTheUnit) {
    std::vector<double> maxima = sample({100, 20, -0.1}, 40);
    const ExtremeFit newtons = fit_maxima(maxima, ExtremeKind::gev);
    for (double& x : maxima) x *= 1e-3;
    const ExtremeFit kilonewtons = fit_maxima(maxima, ExtremeKind::gev);
    EXPECT_NEAR(kilonewtons.location * 1e3, newtons.location, 1e-4);
    EXPECT_NEAR(kilonewtons.shape, newtons.shape, 1e-6);
}

TEST(Extremes, AreNotFittedToTooLittle) {
    EXPECT_FALSE(fit_maxima(std::vector<double>{1, 2, 3}, ExtremeKind::gumbel).valid());
    EXPECT_FALSE(fit_maxima(std::vector<double>(20, 5.0), ExtremeKind::gev).valid());
    EXPECT_TRUE(std::isnan(return_level(fit_maxima({}, ExtremeKind::gev), 100)));
}

TEST(Extremes, ReturnLevelOfOneInAHundred) {
    const ExtremeFit gumbel{100, 20, 0};
    EXPECT_DOUBLE_EQ(return_level(gumbel, 100), 100 - 20 * std::log(-std::log(0.99)));
}

using Scaled = std::function<double(const Distances&)>;

/// The one of 400 samples of Gumbel whose distance lies nearest to a value.
std::vector<double> sample_at(double value, std::size_t count, const Scaled& scaled) {
    std::vector<double> nearest;
    double closest = 1e9;
    for (std::uint32_t number = 0; number < 400; ++number) {
        std::vector<double> one = sample({0, 1, 0}, count, number);
        const double off = std::abs(scaled(distances(fit_maxima(one, ExtremeKind::gumbel), one)) - value);
        if (off >= closest) continue;
        closest = off;
        nearest = std::move(one);
    }
    EXPECT_LT(closest, 0.02);
    return nearest;
}

GoodnessOfFit of_gumbel(const std::vector<double>& maxima) {
    return goodness_of_fit(fit_maxima(maxima, ExtremeKind::gumbel), ExtremeKind::gumbel, maxima, 1999);
}

// M. A. Stephens, Biometrika 64 (1977) 583-588: A² (1 + 0.2 / √n) of Gumbel with both parameters fitted exceeds 0.757
// in 5 % of samples. M. Chandra, N. D. Singpurwalla and M. A. Stephens, J. Am. Stat. Assoc. 76 (1981) 729-731: √n D
// exceeds 0.856 of n = 50 and 0.874 of very many. The bootstrap must agree within its own error, also where its samples
// are smaller than the data.
TEST(GoodnessOfFit, AgreesWithStephensTable) {
    for (const auto& [count, limit] : {std::pair{50.0, 0.856}, std::pair{5000.0, 0.874}}) {
        const auto n = static_cast<std::size_t>(count);
        const auto a2 = [root = std::sqrt(count)](const Distances& of) {
            return of.anderson_darling * (1 + 0.2 / root);
        };
        EXPECT_NEAR(of_gumbel(sample_at(0.757, n, a2)).anderson_darling_p, 0.05, 0.02) << count;
        const auto d = [root = std::sqrt(count)](const Distances& of) { return root * of.kolmogorov_smirnov; };
        EXPECT_NEAR(of_gumbel(sample_at(limit, n, d)).kolmogorov_smirnov_p, 0.05, 0.02) << count;
    }
}

TEST(GoodnessOfFit, SeesWhatIsNoGumbel) {
    std::vector<double> uniform;
    for (int k = 0; k < 100; ++k) uniform.push_back(k + 0.5);
    const ExtremeFit fit = fit_maxima(uniform, ExtremeKind::gumbel);
    EXPECT_LT(goodness_of_fit(fit, ExtremeKind::gumbel, uniform).anderson_darling_p, 0.02);
    const std::vector<double> right = sample({100, 20, 0}, 100);
    EXPECT_GT(goodness_of_fit(fit_maxima(right, ExtremeKind::gumbel), ExtremeKind::gumbel, right).anderson_darling_p,
              0.05);
}

// One value x of the unit uniform distribution: D = max(F, 1 - F), A² = -1 - (log F + log (1 - F)).
TEST(Distances, OfOneValueAreClosedForm) {
    const ExtremeFit fit{0, 1, 0};
    const double x = extreme_quantile(fit, 0.3);
    const Distances found = distances(fit, std::vector<double>{x});
    EXPECT_NEAR(found.kolmogorov_smirnov, 0.7, 1e-12);
    EXPECT_NEAR(found.anderson_darling, -1 - std::log(0.3) - std::log(0.7), 1e-12);
}

TEST(Exceedance, IsPlottedAfterWeibull) {
    const std::vector<ExceedancePoint> curve = exceedance_curve({30, 10, 20});
    ASSERT_EQ(curve.size(), 3u);
    EXPECT_EQ(curve[0].load, 10);
    EXPECT_EQ(curve[0].probability, 0.75);
    EXPECT_EQ(curve[2].load, 30);
    EXPECT_EQ(curve[2].probability, 0.25);
}

}  // namespace extremes_test
}  // namespace floes
