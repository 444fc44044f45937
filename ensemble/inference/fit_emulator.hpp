#pragma once
// The forms that an emulator can take, fitted to values whose deviations from a plane are of the order of 1.

#include "inference/emulator_form.hpp"

namespace floes {

/// One row for each row of `at`: 1, then the coordinates, then their products in pairs; as many as the trend has.
Eigen::MatrixXd trend_terms(EmulatorKind trend, const Eigen::MatrixXd& at);

/// Whether a trend has fewer terms than there are points, and every one is determined without any single point.
bool determines(const Eigen::MatrixXd& at, EmulatorKind trend);

/// Covariance of the correlated part for pairs of points; `squares`: of their differences, pairs x axes.
Eigen::VectorXd shared_variance(const EmulatorCovariance& covariance, const Eigen::MatrixXd& squares);

/// Variance that is added to every noise to keep sums solvable: negligible beside deviations of 1.
inline constexpr double solvable = 1e-10;

EmulatorForm fit_gaussian_process(const EmulatorData& data);
EmulatorForm fit_polynomial(const EmulatorData& data);

/// Mean and variance of predictions of equal weight.
Emulated combined(const std::vector<Emulated>& predictions);

/// In the order and unit of the values.
std::vector<LeftOut> predict_left_out(const EmulatorForm& form, const Eigen::VectorXd& values);

/// Emulator::fault().
std::string emulator_fault(const std::vector<LeftOut>& points, const Eigen::MatrixXd& projection);

}  // namespace floes
