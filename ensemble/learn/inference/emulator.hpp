#pragma once
// A statistic of a campaign's members as a function of the axes of a design: between the points where it was computed,
// with the noise that the scatter over arrangements leaves in each point's value.
//
// A Gaussian process round a plane (universal kriging), where there are at least 3 (axes + 2) points: the coefficients
// of the plane are unknown and their uncertainty is part of the prediction's. Its correlation is Matern's with ν = 5/2
// and a length for each axis: loads have kinks, where floes begin to break or a bound begins to act, and the squared
// exponential, which is smooth to all orders, claims far too much certainty near them (M. L. Stein, Interpolation of
// Spatial Data, Springer 1999, 1.7). The restricted likelihood of lengths and variance, times a broad prior that keeps
// them in a sensible range where the values say little, is maximised; predictions are means over parameters + 1 places
// spread round the maximum as its curvature tells. With the likeliest place alone, 95 % intervals held about 90 %. A
// further variance, of the same size at all points, is added where the values ask for it: for roughness that the points
// are too far apart to resolve, or noise that is larger than stated. It is part of the variance of predictions.
//
// With fewer points: a quadratic, a plane or a constant by weighted least squares, each only if it leaves at least
// three points more than terms, whichever predicts points that are left out best (largest sum of log densities). If the
// values deviate by more than their noise, the further variance is estimated from the deviations, and enlarged for its
// few degrees of freedom.
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
    /// is negative. The order of the points does not matter to a single bit.
    explicit Emulator(const EmulatorData& data);

    EmulatorKind kind() const { return form_.kind; }

    /// Of equal weight in all predictions; they lie round the likeliest one.
    std::vector<EmulatorCovariance> covariances() const;

    /// The statistic without noise, at one coordinate an axis, with the variance of the emulator's own uncertainty.
    /// Throws InputError for another number of coordinates.
    Emulated at(const Eigen::VectorXd& x) const;

    /// In the order of the points given; covariances are those of all points.
    const std::vector<LeftOut>& left_out() const { return left_out_; }

    /// Empty when the check by leaving one out is passed; else a sentence saying why it is not to be trusted: more
    /// errors beyond 3 SD, or a larger mean of their squares over the variance, than chance allows. A right emulator
    /// fails with a probability of at most about 1 %. Errors smaller than stated are no fault.
    std::string fault() const { return fault_; }

  private:
    /// Points in an order of their own, with values of which deviations from a plane are of the order of 1.
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
