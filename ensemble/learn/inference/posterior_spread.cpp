#include "inference/posterior_spread.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace floes {

namespace {

constexpr double step = 0.1;             // of a parameter, for second differences
constexpr double least_curvature = 0.1;  // the prior of each parameter has more

std::vector<double> moved(const std::vector<double>& from, const Eigen::VectorXd& by) {
    std::vector<double> to = from;
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += by(static_cast<Eigen::Index>(k));
    return to;
}

Eigen::MatrixXd curvature(const Cost& cost, const Minimum& least) {
    const auto count = static_cast<Eigen::Index>(least.at.size());
    const Eigen::MatrixXd steps = step * Eigen::MatrixXd::Identity(count, count);
    Eigen::MatrixXd found(count, count);
    for (Eigen::Index a = 0; a < count; ++a) {
        for (Eigen::Index b = 0; b <= a; ++b) {
            const auto at = [&](double along_a, double along_b) {
                return cost(moved(least.at, along_a * steps.col(a) + along_b * steps.col(b)));
            };
            found(a, b) = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * step * step);
        }
    }
    return found;
}

/// Corners of a regular simplex with m coordinates, one a column: mean 0, covariance 1 (Helmert's contrasts).
Eigen::MatrixXd corners(Eigen::Index count) {
    Eigen::MatrixXd found = Eigen::MatrixXd::Zero(count, count + 1);
    for (Eigen::Index row = 0; row < count; ++row) {
        const double j = static_cast<double>(row + 1);
        const double entry = std::sqrt(static_cast<double>(count + 1) / (j * (j + 1)));
        found.row(row).head(row + 1).setConstant(entry);
        found(row, row + 1) = -j * entry;
    }
    return found;
}

}  // namespace

std::vector<std::vector<double>> spread(const Cost& cost, const Minimum& least) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(curvature(cost, least));
    const Eigen::VectorXd sds = solver.eigenvalues().array().max(least_curvature).rsqrt();
    const Eigen::MatrixXd ways = solver.eigenvectors() * sds.asDiagonal() * corners(sds.size());
    const double rise = 0.5 * static_cast<double>(sds.size());  // of the normal distribution's cost at the corners
    std::vector<std::vector<double>> places;
    for (Eigen::Index corner = 0; corner < ways.cols(); ++corner) {
        double reach = 1;
        for (int k = 0; k < 10; ++k) {
            const double found = cost(moved(least.at, reach * ways.col(corner))) - least.cost;
            if (found < 1.1 * rise) break;
            reach *= std::isfinite(found) ? std::max(std::sqrt(rise / found), 0.3) : 0.3;
        }
        places.push_back(moved(least.at, reach * ways.col(corner)));
    }
    return places;
}

}  // namespace floes
