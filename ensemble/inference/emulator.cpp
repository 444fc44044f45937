#include "inference/emulator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "inference/emulator_forms.hpp"

namespace floes {

namespace {

void check(const EmulatorData& data) {
    const Eigen::Index count = data.at.rows();
    if (count < 2 || data.at.cols() < 1) throw InputError("An emulator needs at least two points and one axis.");
    if (data.values.size() != count || data.noise.size() != count)
        throw InputError("An emulator needs one value and one variance of its noise for each point.");
    if (!data.at.allFinite() || !data.values.allFinite() || !data.noise.allFinite())
        throw InputError("The points, values and noise of an emulator must be finite.");
    if (data.noise.minCoeff() < 0) throw InputError("The noise of an emulator is a variance and cannot be negative.");
}

/// The order of the points by coordinates, then by value and noise.
std::vector<Eigen::Index> sorted_rows(const EmulatorData& data) {
    Eigen::MatrixXd keys(data.at.rows(), data.at.cols() + 2);
    keys << data.at, data.values, data.noise;
    std::vector<Eigen::Index> order(static_cast<std::size_t>(keys.rows()));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, [&](Eigen::Index a, Eigen::Index b) {
        for (Eigen::Index column = 0; column < keys.cols(); ++column)
            if (keys(a, column) != keys(b, column)) return keys(a, column) < keys(b, column);
        return false;
    });
    return order;
}

/// SD of the deviations from a plane; from what else is known about the size of the values where these are 0.
double size_of_deviations(const EmulatorData& data) {
    const EmulatorKind trend =
        determines(data.at, EmulatorKind::linear) ? EmulatorKind::linear : EmulatorKind::constant;
    const Eigen::MatrixXd terms = trend_terms(trend, data.at);
    const Eigen::VectorXd rest = data.values - terms * terms.colPivHouseholderQr().solve(data.values);
    const double freedom = static_cast<double>(terms.rows() - terms.cols());
    const double from_plane = rest.squaredNorm() / freedom;
    const double from_mean = (data.values.array() - data.values.mean()).square().mean();
    if (from_plane > 1e-12 * from_mean && from_mean > 1e-24 * data.values.squaredNorm()) return std::sqrt(from_plane);
    const double size = std::max({1e-12 * from_mean, data.noise.mean(), 1e-24 * data.values.squaredNorm()});
    return size > 0 ? std::sqrt(size) : 1;
}

EmulatorForm fitted(const EmulatorData& data) {
    return data.at.rows() >= 3 * (data.at.cols() + 2) ? fit_gaussian_process(data) : fit_polynomial(data);
}

}  // namespace

Emulator::Scaled Emulator::scaled(const EmulatorData& data) {
    check(data);
    const std::vector<Eigen::Index> order = sorted_rows(data);
    const EmulatorData sorted{data.at(order, Eigen::all), data.values(order), data.noise(order)};
    const double shift = sorted.values.mean();
    const double scale = size_of_deviations(sorted);
    return {order,
            shift,
            scale,
            {sorted.at, (sorted.values.array() - shift) / scale, sorted.noise.array() / scale / scale + solvable}};
}

Emulator::Emulator(const EmulatorData& data) : scaled_(scaled(data)), form_(fitted(scaled_.data)) {
    const Eigen::MatrixXd projection = form_.kriging.projection();
    const Eigen::VectorXd errors = left_out_errors(projection, scaled_.data.values);
    left_out_.resize(scaled_.order.size());
    for (Eigen::Index row = 0; row < errors.size(); ++row) {
        const Eigen::Index point = scaled_.order[static_cast<std::size_t>(row)];
        const double sd = scaled_.scale / std::sqrt(projection(row, row));
        left_out_[static_cast<std::size_t>(point)] = {data.values(point), data.values(point) - errors(row) * sd, sd};
    }
    fault_ = emulator_fault(projection, scaled_.data.values);
}

EmulatorCovariance Emulator::covariance() const {
    const double square = scaled_.scale * scaled_.scale;
    return {form_.covariance.lengths, form_.covariance.variance * square, form_.covariance.extra * square};
}

Emulated Emulator::at(const Eigen::VectorXd& x) const {
    const Eigen::MatrixXd& points = scaled_.data.at;
    if (x.size() != points.cols())
        throw InputError(fmt::format("The emulator has {} axes and not {}.", points.cols(), x.size()));
    const Eigen::VectorXd terms = trend_terms(form_.trend, x.transpose()).transpose();
    Eigen::VectorXd shared = Eigen::VectorXd::Zero(points.rows());
    if (form_.kind == EmulatorKind::gaussian_process) {
        const Eigen::ArrayXd per_length = form_.covariance.lengths.array().inverse();
        const Eigen::MatrixXd apart = (points.rowwise() - x.transpose()) * per_length.matrix().asDiagonal();
        shared = form_.covariance.variance * matern(apart.rowwise().squaredNorm()).matrix();
    }
    const Emulated found = form_.kriging.at(terms, shared, form_.covariance.variance + form_.covariance.extra);
    return {scaled_.shift + scaled_.scale * found.mean, scaled_.scale * scaled_.scale * found.variance};
}

}  // namespace floes
