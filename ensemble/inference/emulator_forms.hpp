#pragma once
// The forms that an emulator can take, fitted to values whose deviations from a plane are of the order of 1.

#include "inference/emulator.hpp"

namespace floes {

/// One row for each row of `at`: 1, then the coordinates, then their products in pairs; as many as the trend has.
Eigen::MatrixXd trend_terms(EmulatorKind trend, const Eigen::MatrixXd& at);

/// Whether a trend has fewer terms than there are points, and every one is determined without any single point.
bool determines(const Eigen::MatrixXd& at, EmulatorKind trend);

/// Matern's ν = 5/2 at a squared distance in lengths.
Eigen::ArrayXd matern(const Eigen::ArrayXd& squared);

/// Variance that is added to every noise to keep sums solvable: negligible beside deviations of 1.
inline constexpr double solvable = 1e-10;

EmulatorForm fit_gaussian_process(const EmulatorData& data);
EmulatorForm fit_polynomial(const EmulatorData& data);

/// Errors without each point, over their SD, from Q of Kriging::projection().
Eigen::VectorXd left_out_errors(const Eigen::MatrixXd& projection, const Eigen::VectorXd& values);

/// Emulator::fault().
std::string emulator_fault(const Eigen::MatrixXd& projection, const Eigen::VectorXd& values);

}  // namespace floes
