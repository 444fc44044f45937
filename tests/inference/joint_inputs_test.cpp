// Environmental contours: against closed forms, and the shares of draws outside of tangents.

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

#include "inference/joint_inputs.hpp"
#include "inference/known_processes.hpp"

namespace floes {
namespace joint_inputs_test {

constexpr double pi = std::numbers::pi;

double beyond(double radius) {
    return 0.5 * std::erfc(radius / std::numbers::sqrt2);
}

InputDistribution weibull(double scale, double shape) {
    return {InputLaw::weibull, {.a = scale}, {.a = shape}};
}

TEST(Contour, RadiusIsThatOfTheStatesOfAYear) {
    const double radius = contour_radius(0.01, 2922);
    EXPECT_NEAR(std::pow(1 - beyond(radius), 2922), 0.99, 1e-12);
    // 100 years of 2922 states of 3 h: 1/292200, or nearly so.
    EXPECT_NEAR(beyond(radius) * 292200, -std::log(0.99) / 0.01, 1e-4);
    EXPECT_NEAR(radius, 4.5, 0.02);
    EXPECT_LT(contour_radius(0.01, 0.005), 0);
}

TEST(Contour, OfIndependentNormalsIsAnEllipse) {
    const JointInputs inputs{{InputLaw::normal, {.a = 3}, {.a = 0.5}}, {InputLaw::normal, {.a = -1}, {.a = 2}}};
    for (const ContourPoint& point : contour(inputs, 3.7, 16)) {
        const double x = (point.value[0] - 3) / 0.5;
        const double y = (point.value[1] + 1) / 2;
        EXPECT_NEAR(std::hypot(x, y), 3.7, 1e-12);
        EXPECT_NEAR(std::remainder(std::atan2(y, x) - point.degrees * pi / 180, 2 * pi), 0, 1e-12);
    }
}

/// Bivariate normal with correlation ρ: the mean of y is ρ x, its standard deviation √(1 - ρ²), and the contour is
/// x² - 2 ρ x y + y² = (1 - ρ²) β².
TEST(Contour, OfNormalsThatDependIsTheEllipseOfTheirCorrelation) {
    const double rho = 0.7;
    const JointInputs inputs{{InputLaw::normal, {.a = 0}, {.a = 1}},
                             {InputLaw::normal, {0, rho, 1}, {.a = std::sqrt(1 - rho * rho)}}};
    for (const ContourPoint& point : contour(inputs, 4.2, 24)) {
        const auto [x, y] = point.value;
        EXPECT_NEAR(x * x - 2 * rho * x * y + y * y, (1 - rho * rho) * 4.2 * 4.2, 1e-10);
    }
}

TEST(Contour, OfAnExponentialInputReachesItsQuantiles) {
    const JointInputs inputs{{InputLaw::exponential, {.a = 0.4}, {}}, {InputLaw::lognormal, {.a = 2}, {.a = 0.3}}};
    for (const double radius : {1.0, 4.5, 6.0, 8.0}) {
        const std::vector<ContourPoint> points = contour(inputs, radius, 4);
        EXPECT_NEAR(points[0].value[0], -0.4 * std::log(beyond(radius)), 1e-12);
        EXPECT_NEAR(points[2].value[0], -0.4 * std::log1p(-beyond(radius)), 1e-15);
        EXPECT_NEAR(points[1].value[1], 2 * std::exp(0.3 * radius), 1e-12);
    }
}

TEST(Contour, ScoreIsTheInverseOfValue) {
    const InputDistribution laws[]{{InputLaw::normal, {.a = 3}, {.a = 0.5}},
                                   {InputLaw::lognormal, {1, 2, 0.5}, {.a = 0.4}},
                                   weibull(2, 1.7),
                                   {InputLaw::exponential, {0, 3, 1}, {}}};
    for (const InputDistribution& law : laws)
        for (const double score : {-7.0, -2.0, -0.1, 0.0, 0.3, 3.0, 8.0})
            EXPECT_NEAR(law.score(law.value(score, 1.3), 1.3), score, 1e-9) << name_of(law.law) << ' ' << score;
    EXPECT_NEAR(weibull(2, 1.7).between(1, 3, 0), std::exp(-std::pow(0.5, 1.7)) - std::exp(-std::pow(1.5, 1.7)), 1e-14);
}

/// Outside of the tangent at any point of the circle lies Φ(-β), in the scores that the draws have by Rosenblatt.
TEST(Contour, LeavesTheProbabilityOutsideOfEachTangent) {
    const JointInputs inputs{weibull(0.03, 2.5), {InputLaw::lognormal, {0.05, 4, 1.2}, {0.1, 3, 1}}};
    const double radius = 1.8;
    const int draws = 200000;
    RandomStream random{3, 4, StreamId::monte_carlo, 0};
    std::vector<std::array<double, 2>> scores;
    for (int k = 0; k < draws; ++k) {
        const double x = 0.03 * std::pow(known::exponential(random), 1 / 2.5);
        const double y = (0.05 + 4 * std::pow(x, 1.2)) * std::exp((0.1 + 3 * x) * known::normal(random));
        scores.push_back({inputs.one.score(x, 0), inputs.other.score(y, x)});
    }
    const double wanted = beyond(radius);
    for (const ContourPoint& point : contour(inputs, radius, 8)) {
        const std::array<double, 2> touched{inputs.one.score(point.value[0], 0),
                                            inputs.other.score(point.value[1], point.value[0])};
        int outside = 0;
        for (const auto& [u, v] : scores) outside += u * touched[0] + v * touched[1] > radius * radius;
        EXPECT_NEAR(outside, draws * wanted, 4 * std::sqrt(draws * wanted)) << point.degrees;
    }
    // Along the first input the tangent is one in the inputs themselves: its own quantile.
    EXPECT_NEAR(std::exp(-std::pow(contour(inputs, radius, 4)[0].value[0] / 0.03, 2.5)), wanted, 1e-12);
}

/// A scatter diagram of a known distribution: hours are probabilities of cells, so the fit finds it.
std::vector<ClassHours> diagram(const JointInputs& inputs, double width, double other_width) {
    std::vector<ClassHours> classes;
    for (double x = width / 2; x < 0.1; x += width)
        for (double y = other_width / 2; y < 5; y += other_width) {
            const double hours = 1000 * inputs.one.between(x - width / 2, x + width / 2, 0) *
                                 inputs.other.between(y - other_width / 2, y + other_width / 2, x);
            if (hours > 1e-9) classes.push_back({{x, y}, hours});
        }
    return classes;
}

TEST(FitJointInputs, FindsTheDistributionThatMadeTheDiagram) {
    const JointInputs truth{weibull(0.03, 2.5), {InputLaw::lognormal, {0, 2, 0.6}, {0, 0.8, 0.2}}};
    const JointFit fit = fit_joint_inputs(diagram(truth, 0.004, 0.05));
    ASSERT_TRUE(fit.valid());
    EXPECT_EQ(fit.inputs.one.law, InputLaw::weibull);
    EXPECT_GT(fit.ahead, 0);
    EXPECT_FALSE(fit.scatter_fixed);
    EXPECT_NEAR(fit.inputs.one.first.a, 0.03, 1e-6);
    EXPECT_NEAR(fit.inputs.one.second.a, 2.5, 1e-4);
    for (const double x : {0.01, 0.03, 0.06}) {
        EXPECT_NEAR(fit.inputs.other.first.at(x) / truth.other.first.at(x), 1, 1e-3);
        EXPECT_NEAR(fit.inputs.other.second.at(x) / truth.other.second.at(x), 1, 5e-3);
    }
    for (const ClassCheck& one : fit.classes) EXPECT_NEAR(one.by_law, one.hours, 1e-3) << one.value;
    const std::array<double, 2> far = truth.at(3, 3);
    EXPECT_NEAR(fit.inputs.at(3, 3)[0] / far[0], 1, 1e-3);
    EXPECT_NEAR(fit.inputs.at(3, 3)[1] / far[1], 1, 0.01);
}

TEST(FitJointInputs, TakesTheLikelierOfWeibullAndLognormal) {
    const JointInputs truth{{InputLaw::lognormal, {.a = 0.02}, {.a = 0.4}},
                            {InputLaw::lognormal, {.a = 0.4}, {.a = 0.3}}};
    const JointFit fit = fit_joint_inputs(diagram(truth, 0.004, 0.05));
    ASSERT_TRUE(fit.valid());
    EXPECT_EQ(fit.inputs.one.law, InputLaw::lognormal);
    EXPECT_NEAR(fit.inputs.one.first.a, 0.02, 1e-6);
    EXPECT_NEAR(fit.inputs.other.first.at(0.03), 0.4, 1e-3);  // no dependence
    EXPECT_NEAR(fit.inputs.other.second.at(0.03), 0.3, 1e-3);
}

}  // namespace joint_inputs_test
}  // namespace floes
