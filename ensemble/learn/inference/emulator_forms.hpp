#pragma once
// The data of an emulator and the forms that it can take. Forms are fitted to values whose deviations from a plane are
// of the order of 1; Emulator scales.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "inference/kriging.hpp"

namespace floes {

/// Where and what was simulated.
struct EmulatorData {
    Eigen::MatrixXd at;      ///< points x axes, coordinates in [-1, 1]
    Eigen::VectorXd values;  ///< one a point, any unit
    Eigen::VectorXd noise;   ///< variance of each value (scatter over arrangements / their number), >= 0
};

enum class EmulatorKind { constant, linear, quadratic, gaussian_process };

/// The deviations of the statistic from its mean function.
struct EmulatorCovariance {
    Eigen::VectorXd lengths;  ///< of correlation along each axis, in half axes; empty unless a Gaussian process
    double variance = 0;      ///< of the correlated part, in the unit of the values squared
    double extra = 0;         ///< the same, of the part that no two points share
};

/// Covariances of equal weight, each with its prediction; a single one where there is no doubt about it.
struct EmulatorForm {
    struct Part {
        EmulatorCovariance covariance;
        Kriging kriging;
    };
    EmulatorKind kind;
    EmulatorKind trend;  ///< of the mean function: constant, linear or quadratic
    std::vector<Part> parts;
};

/// A point's value and what the emulator predicts without it, in the unit of the values.
struct LeftOut {
    double value;
    double predicted;
    double sd;  ///< of a new noisy value there: that of the emulator and of the noise

    double standardised() const { return (value - predicted) / sd; }
};

/// One row for each row of `at`: 1, then the coordinates, then their products in pairs; as many as the trend has.
Eigen::MatrixXd trend_terms(EmulatorKind trend, const Eigen::MatrixXd& at);

/// Whether a trend has fewer terms than there are points, and every one is determined without any single point.
bool determines(const Eigen::MatrixXd& at, EmulatorKind trend);

/// Covariance of the correlated part for pairs of points; `squares`: of their differences, pairs x axes.
Eigen::VectorXd shared_variance(const EmulatorCovariance& covariance, const Eigen::MatrixXd& squares);

/// Added to every noise variance so that the equations can be solved; negligible beside deviations of 1.
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
