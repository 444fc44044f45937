#pragma once
// Decompositions of dense matrices, by Eigen, which takes many seconds to compile them wherever they are used.

#include <memory>
#include <optional>

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

struct SymmetricEigen {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< one a column
};

SymmetricEigen eigen_of_symmetric(const Eigen::MatrixXd& matrix);

}  // namespace floes
