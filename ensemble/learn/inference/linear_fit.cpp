#include "inference/linear_fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

using Decomposition = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

/// A column of ones, then the coordinates.
Eigen::MatrixXd model(const PointCoordinates& points) {
    const auto axes = static_cast<Eigen::Index>(points.empty() ? 0 : points.front().size());
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), axes + 1);
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
        const std::vector<double>& point = points[static_cast<std::size_t>(row)];
        matrix(row, 0) = 1;
        for (Eigen::Index axis = 0; axis < axes; ++axis)
            matrix(row, axis + 1) = point.at(static_cast<std::size_t>(axis));
    }
    return matrix;
}

bool solvable(const Eigen::MatrixXd& matrix) {
    return matrix.rows() > matrix.cols() && matrix.allFinite() && Decomposition(matrix).rank() == matrix.cols();
}

Eigen::MatrixXd checked_model(const PointCoordinates& points) {
    Eigen::MatrixXd matrix = model(points);
    if (!solvable(matrix))
        throw InputError("A plane needs more points than axes + 1, and no axis that depends on the others.");
    return matrix;
}

Eigen::VectorXd checked_values(std::span<const double> values, Eigen::Index points) {
    const Eigen::VectorXd vector =
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    if (vector.size() != points || !vector.allFinite())
        throw InputError("A plane needs one finite value for each point.");
    return vector;
}

double r_squared(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values, const Eigen::VectorXd& coefficients) {
    const double total = (values.array() - values.mean()).square().sum();
    return total > 0 ? 1 - (values - matrix * coefficients).squaredNorm() / total : undefined;
}

}  // namespace

bool can_fit(const PointCoordinates& points) {
    return solvable(model(points));
}

LinearFit fit_repetitions(const PointCoordinates& points, std::span<const std::vector<double>> repetitions) {
    if (repetitions.size() < 2) throw InputError("An interval over repetitions needs at least two.");
    const Eigen::MatrixXd matrix = checked_model(points);
    const Decomposition decomposition(matrix);
    const auto count = static_cast<Eigen::Index>(repetitions.size());
    Eigen::MatrixXd values(matrix.rows(), count);
    for (Eigen::Index r = 0; r < count; ++r)
        values.col(r) = checked_values(repetitions[static_cast<std::size_t>(r)], matrix.rows());
    const Eigen::MatrixXd coefficients = decomposition.solve(values);
    LinearFit fit;
    fit.repetitions = static_cast<int>(count);
    fit.centre = coefficients.row(0).mean();
    for (Eigen::Index axis = 1; axis < matrix.cols(); ++axis) {
        const Eigen::VectorXd slopes = coefficients.row(axis);
        const Interval interval = mean_interval({slopes.data(), static_cast<std::size_t>(count)});
        fit.slopes.push_back({interval.estimate, interval.low, interval.high});
    }
    fit.r_squared = r_squared(matrix, values.rowwise().mean(), coefficients.rowwise().mean());
    return fit;
}

LinearFit fit_points(const PointCoordinates& points, std::span<const double> values) {
    const Eigen::MatrixXd matrix = checked_model(points);
    const Eigen::VectorXd vector = checked_values(values, matrix.rows());
    const Decomposition decomposition(matrix);
    const Eigen::VectorXd coefficients = decomposition.solve(vector);
    // (XᵀX)⁻¹ = P R⁻¹ R⁻ᵀ Pᵀ, so its diagonal is the squared norms of the rows of P R⁻¹.
    const Eigen::Index columns = matrix.cols();
    const Eigen::MatrixXd inverse = decomposition.matrixR().topRows(columns).triangularView<Eigen::Upper>().solve(
        Eigen::MatrixXd::Identity(columns, columns));
    const Eigen::VectorXd norms = (decomposition.colsPermutation() * inverse).rowwise().norm();
    const double freedom = static_cast<double>(matrix.rows() - columns);
    const double residual = std::sqrt((vector - matrix * coefficients).squaredNorm() / freedom);
    const double t = student_t(freedom, (1 - 0.95) / 2);
    LinearFit fit;
    fit.centre = coefficients(0);
    for (Eigen::Index axis = 1; axis < columns; ++axis) {
        const double half = t * residual * norms(axis);
        fit.slopes.push_back({coefficients(axis), coefficients(axis) - half, coefficients(axis) + half});
    }
    fit.r_squared = r_squared(matrix, vector, coefficients);
    return fit;
}

}  // namespace floes
