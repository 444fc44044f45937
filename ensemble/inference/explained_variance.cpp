#include "inference/explained_variance.hpp"

#include <cmath>

#include <Eigen/Core>

#include "core/error.hpp"
#include "core/units.hpp"
#include "inference/numerics.hpp"
#include "statistics/distributions.hpp"
#include "statistics/load_statistics.hpp"

namespace floes {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of rows of one length.
MatrixXd matrix_of(const std::vector<std::vector<double>>& rows) {
    MatrixXd made(static_cast<Index>(rows.size()), static_cast<Index>(rows.empty() ? 0 : rows.front().size()));
    for (Index row = 0; row < made.rows(); ++row)
        for (Index column = 0; column < made.cols(); ++column)
            made(row, column) = rows[static_cast<std::size_t>(row)].at(static_cast<std::size_t>(column));
    return made;
}

/// A column of ones, then the coordinates.
MatrixXd model(const PointCoordinates& points) {
    const MatrixXd coordinates = matrix_of(points);
    MatrixXd made(coordinates.rows(), coordinates.cols() + 1);
    made.col(0).setOnes();
    made.rightCols(coordinates.cols()) = coordinates;
    return made;
}

bool is_solvable(const Eigen::MatrixXd& matrix) {
    return matrix.rows() > matrix.cols() && matrix.allFinite() && rank_of(matrix) == matrix.cols();
}

Eigen::MatrixXd checked_model(const PointCoordinates& points) {
    Eigen::MatrixXd matrix = model(points);
    if (!is_solvable(matrix))
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
    return is_solvable(model(points));
}

LinearFit fit_repetitions(const PointCoordinates& points, std::span<const std::vector<double>> repetitions) {
    if (repetitions.size() < 2) throw InputError("An interval over repetitions needs at least two.");
    const Eigen::MatrixXd matrix = checked_model(points);
    const auto count = static_cast<Eigen::Index>(repetitions.size());
    Eigen::MatrixXd values(matrix.rows(), count);
    for (Eigen::Index r = 0; r < count; ++r)
        values.col(r) = checked_values(repetitions[static_cast<std::size_t>(r)], matrix.rows());
    const Eigen::MatrixXd coefficients = least_squares(matrix, values);
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
    const Eigen::VectorXd coefficients = least_squares(matrix, vector);
    const Eigen::VectorXd norms = inverse_norms(matrix);
    const Eigen::Index columns = matrix.cols();
    const double freedom = static_cast<double>(matrix.rows() - columns);
    const double residual = std::sqrt((vector - matrix * coefficients).squaredNorm() / freedom);
    const double t = student_t(freedom, beyond_limit);
    LinearFit fit;
    fit.centre = coefficients(0);
    for (Eigen::Index axis = 1; axis < columns; ++axis) {
        const double half = t * residual * norms(axis);
        fit.slopes.push_back({coefficients(axis), coefficients(axis) - half, coefficients(axis) + half});
    }
    fit.r_squared = r_squared(matrix, vector, coefficients);
    return fit;
}

namespace {

/// Rows with the columns that vary in both samples.
struct Samples {
    MatrixXd known;
    MatrixXd population;
};

Samples varying(const Covariates& known, const Covariates& population) {
    const MatrixXd one = matrix_of(known);
    const MatrixXd other = matrix_of(population);
    std::vector<Index> kept;
    for (Index column = 0; column < one.cols(); ++column) {
        const bool finite = one.col(column).allFinite() && other.col(column).allFinite();
        if (finite && one.col(column).minCoeff() != one.col(column).maxCoeff()) kept.push_back(column);
    }
    return {one(Eigen::all, kept), other(Eigen::all, kept)};
}

MatrixXd centred(const MatrixXd& rows) {
    return rows.rowwise() - rows.colwise().mean();
}

/// A plane through the values over centred covariates.
struct FittedPlane {
    VectorXd slopes;
    MatrixXd inverse;     ///< of X'X
    double residual = 0;  ///< sum of squares
    double left_out = 0;  ///< R² of predictions of each value from the others
};

FittedPlane fit(const VectorXd& values, const MatrixXd& covariates) {
    const MatrixXd x = centred(covariates);
    const double count = static_cast<double>(values.size());
    const VectorXd y = values.array() - values.mean();
    FittedPlane plane;
    plane.inverse = inverse_of(x.transpose() * x);
    plane.slopes = plane.inverse * x.transpose() * y;
    const VectorXd errors = y - x * plane.slopes;
    plane.residual = errors.squaredNorm();
    double predicted = 0;
    double total = 0;
    for (Index row = 0; row < values.size(); ++row) {
        const double leverage = 1 / count + (x.row(row) * plane.inverse * x.row(row).transpose()).value();
        predicted += std::pow(errors(row) / (1 - leverage), 2);
        total += std::pow(y(row) / (1 - 1 / count), 2);
    }
    plane.left_out = 1 - predicted / total;
    return plane;
}

}  // namespace

ControlledMean controlled_mean(std::span<const double> values, const Covariates& known, const Covariates& population) {
    ControlledMean result{.plain = mean_interval(values), .corrected = {}};
    result.corrected = result.plain;
    const Samples samples = varying(known, population);
    const Index count = static_cast<Index>(values.size());
    const double freedom = static_cast<double>(count - 1 - samples.known.cols());
    if (samples.known.cols() == 0 || freedom < 2 || values.size() < fewest_controlled || population.size() < 2)
        return result;
    const VectorXd y = Eigen::Map<const VectorXd>(values.data(), count);
    const FittedPlane plane = fit(y, samples.known);
    result.left_out = plane.left_out;
    if (!(plane.left_out > 0)) return result;
    const VectorXd shift = (samples.population.colwise().mean() - samples.known.colwise().mean()).transpose();
    const MatrixXd spread = centred(samples.population);
    const double drawn = static_cast<double>(population.size());
    const double of_population = (spread * plane.slopes).squaredNorm() / (drawn - 1) / drawn;
    const double variance = plane.residual / freedom *
                                (1 / static_cast<double>(count) + (shift.transpose() * plane.inverse * shift).value()) +
                            of_population;
    const double half = student_t(freedom, 0.025) * std::sqrt(variance);
    const double plain_half = 0.5 * (result.plain.high - result.plain.low);
    if (!(half < plain_half)) return result;
    result.used = true;
    result.corrected.estimate += plane.slopes.dot(shift);
    result.corrected.low = result.corrected.estimate - half;
    result.corrected.high = result.corrected.estimate + half;
    result.saved = static_cast<double>(count) * (std::pow(plain_half / half, 2) - 1);
    return result;
}

namespace {

using Rows = std::span<const std::uint32_t>;

void check(const SaltelliValues& values) {
    const auto check_one = [&](const std::vector<double>& one) {
        if (one.size() != values.a.size())
            throw InputError("Sobol indices need one value for each base point at each of Saltelli's points.");
        for (const double value : one) {
            if (!std::isfinite(value))
                throw InputError("Sobol indices need finite values; leave out base points with other ones.");
        }
    };
    check_one(values.a);
    check_one(values.b);
    for (const std::vector<double>& one : values.ab) check_one(one);
}

struct MeanVariance {
    double mean;
    double variance;
};

/// MeanVariance of y_A and y_B together, over the rows.
MeanVariance moments(const SaltelliValues& values, Rows rows) {
    const double count = 2 * static_cast<double>(rows.size());
    double sum = 0;
    for (const std::uint32_t row : rows) sum += values.a[row] + values.b[row];
    const double mean = sum / count;
    double squares = 0;
    for (const std::uint32_t row : rows) {
        const double a = values.a[row] - mean;
        const double b = values.b[row] - mean;
        squares += a * a + b * b;
    }
    return {mean, squares / count};
}

double first_order(const SaltelliValues& values, std::size_t input, Rows rows) {
    const auto [mean, variance] = moments(values, rows);
    double sum = 0;
    for (const std::uint32_t row : rows) sum += (values.b[row] - mean) * (values.ab[input][row] - values.a[row]);
    return sum / static_cast<double>(rows.size()) / variance;
}

double total(const SaltelliValues& values, std::size_t input, Rows rows) {
    double sum = 0;
    for (const std::uint32_t row : rows) {
        const double change = values.a[row] - values.ab[input][row];
        sum += change * change;
    }
    return sum / static_cast<double>(rows.size()) / (2 * moments(values, rows).variance);
}

}  // namespace

SobolIndices sobol_indices(const SaltelliValues& values, int resamples) {
    check(values);
    const std::size_t count = values.a.size();
    const std::vector<std::uint32_t> all = all_rows(count);
    const bool varies = count > 0 && moments(values, all).variance > 0;
    const auto index = [&](auto estimator, std::size_t input) -> SobolIndex {
        if (!varies) return {undefined, {undefined, undefined}};
        const RowStatistic statistic = [&](Rows rows) { return estimator(values, input, rows); };
        return {statistic(all), bca_interval(count, statistic, resamples)};
    };
    SobolIndices indices;
    for (std::size_t input = 0; input < values.ab.size(); ++input) {
        indices.first.push_back(index(first_order, input));
        indices.total.push_back(index(total, input));
    }
    return indices;
}

namespace {

constexpr double rounding = 1e-24;  // of the sum of squares, which equal values may scatter by

}  // namespace

ArrangementShare arrangement_share(std::span<const std::vector<double>> values) {
    ArrangementShare found{
        values.size(), values.empty() ? 0 : values.front().size(), undefined, undefined, {undefined, undefined}};
    for (const std::vector<double>& of_case : values)
        if (of_case.size() != found.arrangements)
            throw InputError("Cases over other arrangements have no common table.");
    if (found.cases < 2 || found.arrangements < 3) return found;
    const double cases = static_cast<double>(found.cases);
    const double count = static_cast<double>(found.arrangements);
    std::vector<double> of_arrangement(found.arrangements);  // mean difference from the mean of its case
    double all = 0, between = 0, size = 0;                   // sums of squares
    for (const std::vector<double>& of_case : values) {
        const double mean = mean_of(of_case);
        for (std::size_t k = 0; k < of_case.size(); ++k) {
            of_arrangement[k] += (of_case[k] - mean) / cases;
            all += (of_case[k] - mean) * (of_case[k] - mean);
            size += of_case[k] * of_case[k];
        }
    }
    for (const double one : of_arrangement) between += cases * one * one;
    const double freedom = count - 1;
    const double rest_freedom = freedom * (cases - 1);
    const double of_rest = (all - between) / rest_freedom;
    const double of_arrangements = between / freedom;
    if (!(all > rounding * size)) return found;
    found.sd = std::sqrt(all / (cases * freedom));
    const auto share_of = [&](double f) { return (f - 1) / (f + cases - 1); };
    if (!(of_rest > rounding * size)) {
        found.share = 1;
        return found;
    }
    const double f = of_arrangements / of_rest;
    found.share = share_of(f);
    found.interval = {share_of(f / fisher_quantile_above(0.025, freedom, rest_freedom)),
                      share_of(f * fisher_quantile_above(0.025, rest_freedom, freedom))};
    return found;
}

}  // namespace floes
