#pragma once
// The numerical methods that inference uses: decompositions of dense matrices, the minimum of a function without
// derivatives, and draws from a density. Eigen takes many seconds to compile its decompositions wherever they are used.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace floes {

/// K = L Lᵀ of a symmetric positive definite matrix, of which only the lower half is read.
class Cholesky {
  public:
    Cholesky() = default;
    explicit Cholesky(const Eigen::MatrixXd& matrix);

    /// Whether the matrix is positive definite; otherwise nothing else may be called.
    bool exists() const { return exists_; }
    double log_determinant() const;
    Eigen::VectorXd solve(const Eigen::VectorXd& right) const;  ///< K⁻¹ right
    Eigen::VectorXd solve_lower(const Eigen::VectorXd& right) const;
    Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& right) const;  ///< L⁻¹ right
    Eigen::VectorXd solve_upper(const Eigen::VectorXd& right) const;
    Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& right) const;  ///< L⁻ᵀ right

  private:
    struct Factor;
    std::shared_ptr<const Factor> factor_;
    bool exists_ = false;
};

// Least squares by a QR decomposition with column pivots: of a matrix with at least as many rows as columns.

Eigen::Index rank_of(const Eigen::MatrixXd& matrix);
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& values);  ///< column by column

/// Roots of the diagonal of (XᵀX)⁻¹.
Eigen::VectorXd inverse_norms(const Eigen::MatrixXd& matrix);

/// The diagonal of X (XᵀX)⁻¹ Xᵀ; none if columns depend on each other.
std::optional<Eigen::VectorXd> leverages(const Eigen::MatrixXd& matrix);

Eigen::MatrixXd inverse_of(const Eigen::MatrixXd& matrix);

// Where a condition that holds up to a place ends, by halving the range in which that lies.

double halved(double low, double high, int times, const std::function<bool(double)>& lies_above);
/// In the range above `low` > 0, without an upper end: doubled at most 60 times first.
double halved_from(double low, int times, const std::function<bool(double)>& lies_above);

// The local minimum of a function of a few parameters without derivatives: the Nelder-Mead simplex of NLopt.

/// Cost of parameters; anything that is not finite counts as outside their range.
using Cost = std::function<double(std::span<const double>)>;

struct Minimum {
    std::vector<double> at;
    double cost;  ///< infinite if no finite cost was met
};

struct SimplexOptions {
    double size;          ///< edge of the first simplex, the same along all parameters
    double small_enough;  ///< ends when no corner is farther than this from their centre along any parameter
};

/// Walks from `start`. Scale the parameters so that one size suits all. Deterministic.
Minimum walk_simplex(const Cost& cost, std::span<const double> start, const SimplexOptions& options);

// Draws from a distribution of a few parameters of which only the density is known, up to a factor: the adaptive
// Metropolis walk of H. Haario, E. Saksman and J. Tamminen, Bernoulli 7 (2001) 223-242. It adapts in its first part
// only, which is thrown away, so that the rest is an ordinary Metropolis walk.

/// Log of the density at parameters; -infinity outside their range.
using LogDensity = std::function<double(std::span<const double>)>;

struct WalkOptions {
    int steps = 6000;        ///< after the first part, which is a third as long
    int kept = 600;          ///< draws, evenly spaced over the steps
    std::uint32_t draw = 0;  ///< each number gives another, independent walk
};

struct Walk {
    std::vector<std::vector<double>> draws;
    /// Log of the integral of the density, by Laplace's method with the covariance of the draws.
    double log_evidence = 0;
};

/// Walks from `start`, where the density is positive, with first steps of about `sizes`. Deterministic. No draws if the
/// density at the start is not finite.
Walk walk_at_random(const LogDensity& density, std::span<const double> start, std::span<const double> sizes,
                    const WalkOptions& options = {});

// Sigma points: a few sets of parameters, of equal weight, that represent a posterior distribution better than its
// mode.

/// `cost` is the negative logarithm of the posterior, `least` its minimum at m parameters. m + 1 places at the corners
/// of a regular simplex have the mean and covariance of the normal distribution with the curvature at the minimum (S.
/// J. Julier and J. K. Uhlmann, Proc. Am. Control Conf. 2002, 887-892). A corner where
/// the cost is higher than that distribution's is moved towards the minimum.
std::vector<std::vector<double>> spread(const Cost& cost, const Minimum& least);

}  // namespace floes
