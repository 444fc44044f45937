#include "inference/decompositions.hpp"

#include <Eigen/Dense>

#include "core/contract.hpp"

namespace floes {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using PivotedQr = Eigen::ColPivHouseholderQR<MatrixXd>;

}  // namespace

struct Cholesky::Factor {
    Eigen::LLT<MatrixXd> root;
};

Cholesky::Cholesky(const MatrixXd& matrix)
    : factor_(std::make_shared<Factor>(Eigen::LLT<MatrixXd>(matrix))),
      exists_(factor_->root.info() == Eigen::Success) {}

double Cholesky::log_determinant() const {
    FLOES_EXPECTS(exists_);
    return 2 * factor_->root.matrixLLT().diagonal().array().log().sum();
}

VectorXd Cholesky::solve(const VectorXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.solve(right);
}

VectorXd Cholesky::solve_lower(const VectorXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixL().solve(right);
}

MatrixXd Cholesky::solve_lower(const MatrixXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixL().solve(right);
}

VectorXd Cholesky::solve_upper(const VectorXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixU().solve(right);
}

MatrixXd Cholesky::solve_upper(const MatrixXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixU().solve(right);
}

Eigen::Index rank_of(const MatrixXd& matrix) {
    return PivotedQr(matrix).rank();
}

VectorXd least_squares(const MatrixXd& matrix, const VectorXd& values) {
    FLOES_EXPECTS(matrix.rows() == values.size());
    return PivotedQr(matrix).solve(values);
}

MatrixXd least_squares(const MatrixXd& matrix, const MatrixXd& values) {
    FLOES_EXPECTS(matrix.rows() == values.rows());
    return PivotedQr(matrix).solve(values);
}

VectorXd inverse_norms(const MatrixXd& matrix) {
    // (XᵀX)⁻¹ = P R⁻¹ R⁻ᵀ Pᵀ, so its diagonal is the squared norms of the rows of P R⁻¹.
    const PivotedQr decomposition(matrix);
    const Eigen::Index columns = matrix.cols();
    const MatrixXd inverse = decomposition.matrixR().topRows(columns).triangularView<Eigen::Upper>().solve(
        MatrixXd::Identity(columns, columns));
    return (decomposition.colsPermutation() * inverse).rowwise().norm();
}

std::optional<VectorXd> leverages(const MatrixXd& matrix) {
    const PivotedQr decomposition(matrix);
    if (decomposition.rank() < matrix.cols()) return {};
    const MatrixXd basis = decomposition.householderQ() * MatrixXd::Identity(matrix.rows(), matrix.cols());
    return basis.rowwise().squaredNorm();
}

MatrixXd inverse_of(const MatrixXd& matrix) {
    FLOES_EXPECTS(matrix.rows() == matrix.cols());
    return matrix.inverse();
}

SymmetricEigen eigen_of_symmetric(const MatrixXd& matrix) {
    FLOES_EXPECTS(matrix.rows() == matrix.cols());
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace floes
