#pragma once
// An emulator of a statistic over the axes of a design. It interpolates between the simulated points and takes account
// of the noise in their values, which comes from the scatter over arrangements.
//
// With at least 3 (axes + 2) points it is a Gaussian process about a plane (universal kriging). The plane's
// coefficients are unknown, and their uncertainty is part of the prediction variance. The correlation is Matérn's with
// ν = 5/2 and one length for each axis. Loads have kinks, where floes begin to break or a bound begins to act; near
// them the squared exponential, which is infinitely smooth, is far too certain (M. L. Stein, Interpolation of Spatial
// Data, Springer 1999, 1.7). Lengths and variance maximise the restricted likelihood times a broad prior, which keeps
// them in a sensible range where the values say little. Predictions are averaged over parameters + 1 sets of parameters
// about the maximum (posterior_spread.hpp); with the maximum alone, 95 % intervals covered about 90 %. A nugget, the
// same variance at every point, is added if the likelihood gains enough: for roughness between the points, or for noise
// that is larger than stated. It is part of the prediction variance.
//
// With fewer points it is a quadratic, a plane or a constant, fitted by weighted least squares: of those that leave at
// least three points more than terms, the one that predicts left-out points best (largest sum of log densities). If the
// values deviate by more than their noise, the nugget is estimated from the deviations, and enlarged for its few
// degrees of freedom.
//
// A library (OpenTURNS) was considered: 37 packages of 259 MB for what is one Cholesky factor here.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "inference/emulator_forms.hpp"

namespace floes {

class Emulator {
  public:
    /// Throws InputError unless there are at least 2 points and 1 axis, sizes agree, everything is finite and no noise
    /// is negative. The result does not depend on the order of the points, to the bit.
    explicit Emulator(const EmulatorData& data);

    EmulatorKind kind() const { return form_.kind; }

    /// Those that predictions are averaged over, with equal weights.
    std::vector<EmulatorCovariance> covariances() const;

    /// The statistic without noise, at one coordinate an axis, with the variance of the emulator's own uncertainty.
    /// Throws InputError for another number of coordinates.
    Emulated at(const Eigen::VectorXd& x) const;

    /// In the order of the points given; covariances are those of all points.
    const std::vector<LeftOut>& left_out() const { return left_out_; }

    /// Empty if the emulator passes its leave-one-out check; otherwise a sentence that says why it cannot be trusted:
    /// more errors beyond 3 SD, or a larger mean of the standardised squares, than chance allows. A right emulator
    /// fails with a probability of about 1 % at most. Errors smaller than stated are no fault.
    std::string fault() const { return fault_; }

  private:
    /// Sorted points, with values scaled so that their deviations from a plane are of the order of 1.
    struct Scaled {
        std::vector<Eigen::Index> order;
        double shift;
        double scale;
        EmulatorData data;
    };
    static Scaled scaled(const EmulatorData& data);

    Scaled scaled_;
    EmulatorForm form_;
    std::vector<LeftOut> left_out_;
    std::string fault_;
};

}  // namespace floes
