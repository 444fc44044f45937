#pragma once
// Best linear unbiased prediction with a mean whose coefficients are unknown (universal kriging, generalised least
// squares): values y = F β + e with cov(e) = K. O. Dubrule, Math. Geol. 15 (1983) 687-699; C. E. Rasmussen and C. K. I.
// Williams, Gaussian Processes for Machine Learning, MIT Press 2006, 2.7 and 5.4.2.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "inference/numerics.hpp"

namespace floes {

/// A prediction and the variance of its error.
struct Emulated {
    double mean = 0;
    double variance = 0;
};

class Kriging {
  public:
    /// `covariance`: K, n x n, of which only the lower half is read; `trend`: F, n x terms with n > terms; `values`: n.
    Kriging(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& trend, const Eigen::VectorXd& values);

    /// Whether K is positive definite and each β is determined; otherwise nothing else may be called.
    bool valid() const { return valid_; }
    /// Restricted: of the values' contrasts, which do not depend on β; without the constant.
    double log_likelihood() const;
    /// (y - F β)ᵀ K⁻¹ (y - F β): n - terms is expected.
    double misfit() const { return misfit_; }
    /// At a place with trend terms `f`, covariances `k` with the n values, and variance `prior` round the trend.
    Emulated at(const Eigen::VectorXd& f, const Eigen::VectorXd& k, double prior) const;
    /// Q = K⁻¹ - K⁻¹ F (Fᵀ K⁻¹ F)⁻¹ Fᵀ K⁻¹: without value i, its error would be (Q y)_i / Q_ii with variance 1 / Q_ii.
    Eigen::MatrixXd projection() const;

  private:
    Cholesky root_;          // K = L Lᵀ
    Eigen::MatrixXd trend_;  // L⁻¹ F
    Cholesky precision_;     // of β: Fᵀ K⁻¹ F
    Eigen::VectorXd beta_;
    Eigen::VectorXd weights_;  // K⁻¹ (y - F β)
    double misfit_ = 0;
    bool valid_ = false;
};

// The data of an emulator and the forms that it can take. Forms are fitted to values whose deviations from a plane are
// of the order of 1; Emulator scales.

/// Where and what was simulated.
struct EmulatorData {
    Eigen::MatrixXd at;      ///< points x axes, coordinates in [-1, 1]
    Eigen::VectorXd values;  ///< one a point, any unit
    Eigen::VectorXd noise;   ///< variance of each value (scatter over arrangements / their number), >= 0
};

enum class EmulatorKind { constant, linear, quadratic, gaussian_process };

/// "constant", "linear", "quadratic", "Gaussian process".
const char* name_of(EmulatorKind kind);

/// So many points make an emulator a Gaussian process.
inline int points_for_gaussian_process(int axes) {
    return 3 * (axes + 2);
}

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

// An emulator of a statistic over the axes of a design. It interpolates between the simulated points and takes account
// of the noise in their values, which comes from the scatter over arrangements.
//
// With at least 3 (axes + 2) points it is a Gaussian process about a plane (universal kriging). The plane's
// coefficients are unknown, and their uncertainty is part of the prediction variance. The correlation is Matérn's with
// ν = 5/2 and one length for each axis. Loads have kinks, where floes begin to break or a bound begins to act; near
// them the squared exponential, which is infinitely smooth, is far too certain (M. L. Stein, Interpolation of Spatial
// Data, Springer 1999, 1.7). Lengths and variance maximise the restricted likelihood times a broad prior, which keeps
// them in a sensible range where the values say little. Predictions are averaged over parameters + 1 sets of parameters
// about the maximum (numerics.hpp); with the maximum alone, 95 % intervals covered about 90 %. A nugget, the
// same variance at every point, is added if the likelihood gains enough: for roughness between the points, or for noise
// that is larger than stated. It is part of the prediction variance.
//
// With fewer points it is a quadratic, a plane or a constant, fitted by weighted least squares: of those that leave at
// least three points more than terms, the one that predicts left-out points best (largest sum of log densities). If the
// values deviate by more than their noise, the nugget is estimated from the deviations, and enlarged for its few
// degrees of freedom.
//
// A library (OpenTURNS) was considered: 37 packages of 259 MB for what is one Cholesky factor here.

class Emulator {
  public:
    /// Throws InputError unless there are at least 2 points and 1 axis, sizes agree, everything is finite and no noise
    /// is negative. The result does not depend on the order of the points, to the bit.
    explicit Emulator(const EmulatorData& data);

    EmulatorKind kind() const { return form_.kind; }
    /// What it is instead of a Gaussian process and how many points would make it one, without subject: "is a constant,
    /// the same at all inputs, because it has 4 points; 9 or more make it a Gaussian process, which follows them";
    /// empty for a Gaussian process.
    std::string simpler() const;

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
