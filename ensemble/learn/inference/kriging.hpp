#pragma once
// Best linear unbiased prediction with a mean whose coefficients are unknown (universal kriging, generalised least
// squares): values y = F β + e with cov(e) = K. O. Dubrule, Math. Geol. 15 (1983) 687-699; C. E. Rasmussen and C. K. I.
// Williams, Gaussian Processes for Machine Learning, MIT Press 2006, 2.7 and 5.4.2.

#include <Eigen/Dense>

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
    Eigen::LLT<Eigen::MatrixXd> root_;       // K = L Lᵀ
    Eigen::MatrixXd trend_;                  // L⁻¹ F
    Eigen::LLT<Eigen::MatrixXd> precision_;  // of β: Fᵀ K⁻¹ F
    Eigen::VectorXd beta_;
    Eigen::VectorXd weights_;  // K⁻¹ (y - F β)
    double misfit_ = 0;
    bool valid_ = false;
};

}  // namespace floes
