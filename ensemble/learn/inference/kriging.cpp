#include "inference/kriging.hpp"

#include <algorithm>

namespace floes {

namespace {

double log_determinant(const Eigen::LLT<Eigen::MatrixXd>& root) {
    return 2 * root.matrixLLT().diagonal().array().log().sum();
}

}  // namespace

Kriging::Kriging(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& trend, const Eigen::VectorXd& values)
    : root_(covariance) {
    if (root_.info() != Eigen::Success) return;
    trend_ = root_.matrixL().solve(trend);
    precision_.compute(trend_.transpose() * trend_);
    if (precision_.info() != Eigen::Success) return;
    const Eigen::VectorXd white = root_.matrixL().solve(values);
    beta_ = precision_.solve(trend_.transpose() * white);
    const Eigen::VectorXd rest = white - trend_ * beta_;
    misfit_ = rest.squaredNorm();
    weights_ = root_.matrixU().solve(rest);
    valid_ = weights_.allFinite() && beta_.allFinite();
}

double Kriging::log_likelihood() const {
    return -0.5 * (log_determinant(root_) + log_determinant(precision_) + misfit_);
}

Emulated Kriging::at(const Eigen::VectorXd& f, const Eigen::VectorXd& k, double prior) const {
    const Eigen::VectorXd white = root_.matrixL().solve(k);
    const Eigen::VectorXd unknown = precision_.matrixL().solve(f - trend_.transpose() * white);
    const double variance = prior - white.squaredNorm() + unknown.squaredNorm();
    return {f.dot(beta_) + k.dot(weights_), std::max(variance, 0.0)};
}

Eigen::MatrixXd Kriging::projection() const {
    const Eigen::Index count = trend_.rows();
    const Eigen::MatrixXd half = precision_.matrixL().solve(trend_.transpose());
    const Eigen::MatrixXd inside = Eigen::MatrixXd::Identity(count, count) - half.transpose() * half;
    const Eigen::MatrixXd left = root_.matrixU().solve(inside);
    return root_.matrixU().solve(left.transpose());
}

}  // namespace floes
