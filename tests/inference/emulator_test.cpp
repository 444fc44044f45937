// Emulators against closed forms: sums by hand, the kriging system written out, refits without a point.

#include "inference/emulator.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "toy_simulator.hpp"

namespace floes {
namespace emulator_test {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// The statistic at x by Lagrange's form of universal kriging: weights that are unbiased for a plane and least in
/// variance.
Emulated by_hand(const EmulatorData& data, const EmulatorCovariance& covariance, const Vector& x) {
    const Eigen::Index n = data.at.rows();
    const Eigen::Index terms = data.at.cols() + 1;
    Matrix system = Matrix::Zero(n + terms, n + terms);
    Vector right(n + terms);
    for (Eigen::Index a = 0; a < n; ++a) {
        for (Eigen::Index b = 0; b < n; ++b)
            system(a, b) = covariance.variance * toy::correlation(data.at.row(a), data.at.row(b), covariance.lengths);
        system(a, a) += data.noise(a) + covariance.extra;
        system(a, n) = system(n, a) = 1;
        right(a) = covariance.variance * toy::correlation(data.at.row(a), x, covariance.lengths);
    }
    system.block(0, n + 1, n, terms - 1) = data.at;
    system.block(n + 1, 0, terms - 1, n) = data.at.transpose();
    right(n) = 1;
    right.tail(terms - 1) = x;
    const Vector weights = system.fullPivLu().solve(right);
    return {weights.head(n).dot(data.values), covariance.variance + covariance.extra - weights.dot(right)};
}

Emulated by_hand(const EmulatorData& data, const std::vector<EmulatorCovariance>& covariances, const Vector& x) {
    Emulated sum;
    double square = 0;
    for (const EmulatorCovariance& covariance : covariances) {
        const Emulated one = by_hand(data, covariance, x);
        sum.mean += one.mean / std::ssize(covariances);
        square += (one.variance + one.mean * one.mean) / std::ssize(covariances);
    }
    return {sum.mean, square - sum.mean * sum.mean};
}

EmulatorData without(const EmulatorData& data, Eigen::Index left_out) {
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(data.at.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    rows.erase(rows.begin() + left_out);
    return {data.at(rows, Eigen::all), data.values(rows), data.noise(rows)};
}

TEST(Emulator, OfTwoPointsIsTheirWeightedMean) {
    const Emulator emulator(toy::on_line(Vector{{-1, 1}}, Vector{{3, 4.5}}, Vector{{1, 3}}));
    EXPECT_EQ(emulator.kind(), EmulatorKind::constant);
    EXPECT_NEAR(emulator.at(Vector{{0.3}}).mean, 3.375, 1e-8);
    EXPECT_NEAR(emulator.at(Vector{{0.3}}).variance, 0.75, 1e-8);
    EXPECT_NEAR(emulator.left_out()[0].predicted, 4.5, 1e-8);
    EXPECT_NEAR(emulator.left_out()[0].sd, 2, 1e-8);
    EXPECT_NEAR(emulator.left_out()[1].standardised(), 0.75, 1e-8);
    EXPECT_EQ(emulator.fault(), "");
}

// The difference of 10 has 50 times its variance: the further variance g follows from 100 / (2 (1 + g)) = 1 / 3.
TEST(Emulator, OfTwoPointsThatDisagreeIsAsWideAsTheirDifference) {
    const Emulator emulator(toy::on_line(Vector{{-1, 1}}, Vector{{0, 10}}, Vector{{1, 1}}));
    EXPECT_NEAR(emulator.covariances().front().extra, 149, 1e-6);
    EXPECT_NEAR(emulator.at(Vector{{0}}).mean, 5, 1e-9);
    EXPECT_NEAR(emulator.at(Vector{{0}}).variance, 75 + 149, 1e-6);
}

TEST(Emulator, OfEqualValuesIsConstant) {
    const Emulator emulator(
        toy::on_line(Vector::LinSpaced(8, -1, 1), Vector::Constant(8, 7), Vector::Constant(8, 0.08)));
    EXPECT_EQ(emulator.kind(), EmulatorKind::constant);
    EXPECT_NEAR(emulator.at(Vector{{0.5}}).mean, 7, 1e-12);
    EXPECT_NEAR(emulator.at(Vector{{0.5}}).variance, 0.01, 1e-8);
    EXPECT_EQ(emulator.fault(), "");
    const Emulator exact(toy::on_line(Vector::LinSpaced(20, -1, 1), Vector::Constant(20, 7), Vector::Zero(20)));
    EXPECT_NEAR(exact.at(Vector{{0.5}}).mean, 7, 1e-9);
    EXPECT_LT(exact.at(Vector{{0.5}}).variance, 1e-12);
}

TEST(Emulator, IsTheKrigingSystemAveragedOverCovariances) {
    const toy::Toy toy = toy::drawn(18, Vector{{0.8, 2}}, 0.05);
    const Emulator emulator(toy.data);
    ASSERT_EQ(emulator.kind(), EmulatorKind::gaussian_process);
    EXPECT_EQ(emulator.covariances().size(), 4);
    for (const Vector& x : {Vector{{0.2, -0.3}}, Vector{{1, 1}}, Vector{{4, -6}}}) {
        const Emulated expected = by_hand(toy.data, emulator.covariances(), x);
        EXPECT_NEAR(emulator.at(x).mean, expected.mean, 1e-7);
        EXPECT_NEAR(emulator.at(x).variance, expected.variance, 1e-7);
    }
}

TEST(Emulator, LeavesOutAsARefitDoes) {
    const toy::Toy toy = toy::drawn(18, Vector{{0.8, 2}}, 0.05);
    const Emulator emulator(toy.data);
    for (Eigen::Index i = 0; i < 18; ++i) {
        const Emulated refit = by_hand(without(toy.data, i), emulator.covariances(), toy.data.at.row(i));
        const LeftOut& found = emulator.left_out()[static_cast<std::size_t>(i)];
        EXPECT_EQ(found.value, toy.data.values(i));
        EXPECT_NEAR(found.predicted, refit.mean, 1e-7);
        EXPECT_NEAR(found.sd, std::sqrt(refit.variance + toy.data.noise(i)), 1e-7);
    }
}

TEST(Emulator, InterpolatesWithoutNoiseAndKnowsLessAway) {
    const Vector at = Vector::LinSpaced(15, -1, 1);
    const Emulator emulator(toy::on_line(at, (3 * at).array().sin(), Vector::Zero(15)));
    for (const double x : at) {
        EXPECT_NEAR(emulator.at(Vector{{x}}).mean, std::sin(3 * x), 1e-6);
        EXPECT_LT(emulator.at(Vector{{x}}).variance, 1e-8);
    }
    EXPECT_NEAR(emulator.at(Vector{{0.07}}).mean, std::sin(0.21), 1e-3);
    EXPECT_GT(emulator.at(Vector{{0.07}}).variance, 10 * emulator.at(Vector{{0}}).variance);
    EXPECT_GT(emulator.at(Vector{{3}}).variance, 100 * emulator.at(Vector{{1.1}}).variance);
    EXPECT_EQ(emulator.fault(), "");
}

TEST(Emulator, WithHugeNoiseIsTheWeightedPlane) {
    toy::Toy toy = toy::drawn(24, Vector{{0.8, 2}}, 0.05);
    toy.data.noise *= 1e8;
    Matrix terms(24, 3);
    terms << Vector::Ones(24), toy.data.at;
    const Matrix weighted = toy.data.noise.cwiseInverse().asDiagonal() * terms;
    const Matrix inverse = (terms.transpose() * weighted).inverse();
    const Vector plane = inverse * (weighted.transpose() * toy.data.values);
    const Vector f{{1, 0.4, -0.7}};
    const Emulator emulator(toy.data);
    EXPECT_NEAR(emulator.at(f.tail(2)).mean, f.dot(plane), 1e-3);
    EXPECT_NEAR(emulator.at(f.tail(2)).variance / f.dot(inverse * f), 1, 1e-3);
}

TEST(Emulator, FindsAPlaneAndAQuadraticExactly) {
    const toy::Toy toy = toy::drawn(20, Vector{{1, 1, 1}}, 0);
    const Vector slopes{{3, -2, 0.5}};
    const Emulator plane({toy.data.at, (toy.data.at * slopes).array() + 10, Vector::Zero(20)});
    EXPECT_EQ(plane.kind(), EmulatorKind::gaussian_process);
    EXPECT_NEAR(plane.at(Vector{{0.1, 0.9, -1}}).mean, 10 + 0.3 - 1.8 - 0.5, 1e-8);
    EXPECT_LT(plane.at(Vector{{0.1, 0.9, -1}}).variance, 1e-12);
    const Matrix few = toy.data.at.topLeftCorner(10, 2);
    const Emulator quadratic(
        {few, 1 + few.col(0).array() * few.col(1).array() * 2 - few.col(0).array().square(), Vector::Zero(10)});
    EXPECT_EQ(quadratic.kind(), EmulatorKind::quadratic);
    EXPECT_NEAR(quadratic.at(Vector{{0.5, -0.4}}).mean, 1 - 0.4 - 0.25, 1e-8);
    const Emulator linear({few, few.col(0), Vector::Constant(10, 0.01)});
    EXPECT_EQ(linear.kind(), EmulatorKind::linear);
}

TEST(Emulator, TellsAnAxisThatDoesNothing) {
    const toy::Toy toy = toy::drawn(30, Vector{{1, 1}}, 0);
    const Emulator emulator({toy.data.at, (3 * toy.data.at.col(0)).array().sin(), Vector::Constant(30, 1e-6)});
    for (const EmulatorCovariance& covariance : emulator.covariances())
        EXPECT_GT(covariance.lengths(1), 3 * covariance.lengths(0));
    EXPECT_NEAR(emulator.at(Vector{{0.5, -0.9}}).mean, emulator.at(Vector{{0.5, 0.9}}).mean, 0.02);
}

}  // namespace emulator_test
}  // namespace floes
