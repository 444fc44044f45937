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
    const std::vector<LeftOut> points = predict_left_out(form_, scaled_.data.values);
    fault_ = emulator_fault(points, form_.parts.front().kriging.projection());
    left_out_.resize(points.size());
    for (std::size_t row = 0; row < points.size(); ++row) {
        const Eigen::Index point = scaled_.order[row];
        left_out_[static_cast<std::size_t>(point)] = {
            data.values(point), scaled_.shift + scaled_.scale * points[row].predicted, scaled_.scale * points[row].sd};
    }
}

std::vector<EmulatorCovariance> Emulator::covariances() const {
    const double square = scaled_.scale * scaled_.scale;
    std::vector<EmulatorCovariance> found;
    for (const auto& [covariance, kriging] : form_.parts)
        found.push_back({covariance.lengths, covariance.variance * square, covariance.extra * square});
    return found;
}

Emulated Emulator::at(const Eigen::VectorXd& x) const {
    const Eigen::MatrixXd& points = scaled_.data.at;
    if (x.size() != points.cols())
        throw InputError(fmt::format("The emulator has {} axes and not {}.", points.cols(), x.size()));
    const Eigen::VectorXd terms = trend_terms(form_.trend, x.transpose()).transpose();
    const Eigen::MatrixXd squares = (points.rowwise() - x.transpose()).array().square();
    std::vector<Emulated> predictions;
    for (const auto& [covariance, kriging] : form_.parts) {
        Eigen::VectorXd shared = Eigen::VectorXd::Zero(points.rows());
        if (form_.kind == EmulatorKind::gaussian_process) shared = shared_variance(covariance, squares);
        predictions.push_back(kriging.at(terms, shared, covariance.variance + covariance.extra));
    }
    const Emulated found = combined(predictions);
    return {scaled_.shift + scaled_.scale * found.mean, scaled_.scale * scaled_.scale * found.variance};
}

}  // namespace floes
