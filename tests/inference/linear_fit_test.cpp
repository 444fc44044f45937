// Planes through the points of a design, against closed forms and stored results of numpy and scipy.

#include "inference/explained_variance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace floes {
namespace linear_fit_test {

const PointCoordinates points{{-1, -1}, {-1, 1}, {1, -1}, {1, 1}, {0, 0.5}, {0.25, 0}};
const std::vector<std::vector<double>> values{{1, 2, 4, 7, 3, 3.5}, {2, 2, 5, 6, 3.5, 4}, {0.5, 3, 4.5, 8, 3, 3}};

// numpy 1.24, scipy 1.10: A = np.c_[np.ones(6), points]; y = values[0]; b = np.linalg.lstsq(A, y, rcond=None)[0];
// r = y - A @ b; se = np.sqrt(np.diag(np.linalg.inv(A.T @ A)) * (r @ r) / 3); b -/+ stats.t.ppf(.975, 3) * se
TEST(LinearFit, IsNumpysWithItsStandardErrors) {
    const LinearFit fit = fit_points(points, values[0]);
    EXPECT_EQ(fit.repetitions, 0);
    EXPECT_NEAR(fit.centre, 3.2580940745265767, 1e-12);
    EXPECT_NEAR(fit.slopes[0].estimate, 1.9841172877214395, 1e-12);
    EXPECT_NEAR(fit.slopes[0].low, 0.7457712282443136, 1e-12);
    EXPECT_NEAR(fit.slopes[0].high, 3.2224633471985653, 1e-12);
    EXPECT_NEAR(fit.slopes[1].estimate, 0.9108124618204034, 1e-12);
    EXPECT_NEAR(fit.slopes[1].low, -0.3043270553045314, 1e-12);
    EXPECT_NEAR(fit.slopes[1].high, 2.1259519789453383, 1e-12);
    EXPECT_NEAR(fit.r_squared, 0.9132151511041929, 1e-12);
}

// The same: b = np.linalg.lstsq(A, np.transpose(values), rcond=None)[0];
// m = b.mean(1); m -/+ t * b.std(1, ddof=1) / np.sqrt(3), t = 0.95 * sqrt(2 / 0.0975): the quantile in closed form,
// since scipy's is off by 4e-11
TEST(LinearFit, OfRepetitionsIsTheMeanOfTheirs) {
    const LinearFit fit = fit_repetitions(points, values);
    EXPECT_EQ(fit.repetitions, 3);
    EXPECT_NEAR(fit.centre, 3.4599368763999223, 1e-12);
    EXPECT_NEAR(fit.slopes[0].estimate, 1.9716961922215412, 1e-12);
    EXPECT_NEAR(fit.slopes[0].low, 1.4209559582461508, 1e-12);
    EXPECT_NEAR(fit.slopes[0].high, 2.522436426196932, 1e-12);
    EXPECT_NEAR(fit.slopes[1].low, -0.599808315733989, 1e-12);
    EXPECT_NEAR(fit.slopes[1].high, 2.256293756581066, 1e-12);
    EXPECT_NEAR(fit.r_squared, 0.9243026329494495, 1e-12);
}

TEST(LinearFit, FindsAPlaneExactly) {
    std::vector<double> plane;
    for (const std::vector<double>& point : points) plane.push_back(10 + 3 * point[0] - 2 * point[1]);
    const LinearFit fit = fit_points(points, plane);
    EXPECT_NEAR(fit.centre, 10, 1e-12);
    EXPECT_NEAR(fit.slopes[0].estimate, 3, 1e-12);
    EXPECT_NEAR(fit.slopes[1].high, -2, 1e-12);
    EXPECT_NEAR(fit.r_squared, 1, 1e-12);
}

// What arrangements do to all points alike moves the centre and no slope.
TEST(LinearFit, IsBlindToWhatRepetitionsShare) {
    std::vector<std::vector<double>> shifted = values;
    for (double& value : shifted[1]) value += 100;
    EXPECT_NEAR(fit_repetitions(points, shifted).slopes[0].high, fit_repetitions(points, values).slopes[0].high, 1e-11);
}

// Noise of equal spread at each point: 95 % of 2000 intervals hold the slope, to within four standard errors.
TEST(LinearFit, HasIntervalsThatCover) {
    RandomStream random(1, 0, StreamId::bootstrap, 5);
    const auto noise = [&random] {
        return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * 3.14159265358979 * random.uniform());
    };
    int by_repetition = 0;
    int by_residual = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<std::vector<double>> drawn(3);
        for (std::vector<double>& one : drawn) {
            for (const std::vector<double>& point : points) one.push_back(2 * point[0] + noise());
        }
        const Slope over = fit_repetitions(points, drawn).slopes[0];
        const Slope within = fit_points(points, drawn[0]).slopes[0];
        by_repetition += over.low <= 2 && 2 <= over.high;
        by_residual += within.low <= 2 && 2 <= within.high;
    }
    EXPECT_NEAR(by_repetition / 2000.0, 0.95, 0.02);
    EXPECT_NEAR(by_residual / 2000.0, 0.95, 0.02);
}

TEST(LinearFit, WantsPointsThatTellTheAxesApart) {
    EXPECT_TRUE(can_fit(points));
    EXPECT_FALSE(can_fit({}));
    EXPECT_FALSE(can_fit({{-1, -1}, {0, 1}, {1, 0}}));                      // three numbers from three
    EXPECT_FALSE(can_fit({{-1, 1}, {0, 0}, {1, -1}, {0.5, -0.5}}));         // one axis is the other turned round
    EXPECT_FALSE(can_fit({{-1, 0}, {0, 0}, {1, 0}, {0.5, 0}, {-0.5, 0}}));  // an axis that does not move
    EXPECT_THROW(fit_points({{1}, {2}}, std::vector<double>{1, 2}), InputError);
    EXPECT_THROW(fit_points(points, std::vector<double>{1, 2}), InputError);
    EXPECT_THROW(fit_repetitions(points, std::vector<std::vector<double>>{values[0]}), InputError);
}

}  // namespace linear_fit_test
}  // namespace floes
