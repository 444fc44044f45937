#pragma once
// What an emulator is made of: the data, and the form that was fitted to them.

#include <Eigen/Dense>

#include "inference/kriging.hpp"

namespace floes {

/// Where and what was simulated.
struct EmulatorData {
    Eigen::MatrixXd at;      ///< points x axes, coordinates in [-1, 1]
    Eigen::VectorXd values;  ///< one a point, any unit
    Eigen::VectorXd noise;   ///< variance of each value (scatter over arrangements / their number), >= 0
};

enum class EmulatorKind { constant, linear, quadratic, gaussian_process };

/// How the statistic deviates from its mean function.
struct EmulatorCovariance {
    Eigen::VectorXd lengths;  ///< of correlation along each axis, in half axes; empty unless a Gaussian process
    double variance = 0;      ///< of the correlated part, in the unit of the values squared
    double extra = 0;         ///< the same, of the part that no two points share
};

/// Covariances that are about equally likely, each with the prediction that follows from it; one if it is not in doubt.
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

}  // namespace floes
