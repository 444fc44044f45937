// Whether an emulator's leave-one-out errors are as large as it states.

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "inference/emulator_forms.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

constexpr double far = 3;  // SDs
constexpr double many_far_by_chance = 0.01;
// Covariances were fitted to the same values, so mean squares scatter less than those of a covariance that is given: of
// right emulators with 20 to 100 points at most one in a hundred exceeds this.
constexpr double large_by_chance = 0.02;

/// The most points that may lie far off.
int most_far(Eigen::Index points) {
    using boost::math::cdf;
    using boost::math::complement;
    const double share = 2 * normal_above(far);
    const boost::math::binomial number(static_cast<double>(points), share);
    int most = 0;
    while (cdf(complement(number, most)) > many_far_by_chance) ++most;
    return most;
}

/// The largest mean of squares. Their correlations are those of Q scaled to a diagonal of 1, so the mean is 1 and its
/// variance 2 Σ C² / n²: a scaled χ² with the same two moments.
double largest_mean_square(const Eigen::MatrixXd& projection) {
    const Eigen::ArrayXd scale = projection.diagonal().array().rsqrt();
    const Eigen::MatrixXd correlation = scale.matrix().asDiagonal() * projection * scale.matrix().asDiagonal();
    const double freedom = static_cast<double>(scale.size() * scale.size()) / correlation.squaredNorm();
    return chi_squared_quantile_above(large_by_chance, freedom) / freedom;
}

}  // namespace

Emulated combined(const std::vector<Emulated>& predictions) {
    const double count = static_cast<double>(predictions.size());
    Emulated sum;
    for (const Emulated& one : predictions) sum.mean += one.mean / count;
    for (const Emulated& one : predictions)
        sum.variance += (one.variance + (one.mean - sum.mean) * (one.mean - sum.mean)) / count;
    return sum;
}

std::vector<LeftOut> predict_left_out(const EmulatorForm& form, const Eigen::VectorXd& values) {
    std::vector<std::vector<Emulated>> predictions(static_cast<std::size_t>(values.size()));
    for (const EmulatorForm::Part& part : form.parts) {
        const Eigen::MatrixXd projection = part.kriging.projection();
        const Eigen::VectorXd errors = (projection * values).cwiseQuotient(projection.diagonal());
        for (Eigen::Index i = 0; i < values.size(); ++i)
            predictions[static_cast<std::size_t>(i)].push_back({values(i) - errors(i), 1 / projection(i, i)});
    }
    std::vector<LeftOut> points;
    for (const std::vector<Emulated>& one : predictions) {
        const Emulated predicted = combined(one);
        points.push_back({values(std::ssize(points)), predicted.mean, std::sqrt(predicted.variance)});
    }
    return points;
}

std::string emulator_fault(const std::vector<LeftOut>& points, const Eigen::MatrixXd& projection) {
    Eigen::ArrayXd errors(std::ssize(points));
    std::ranges::transform(points, errors.begin(), [](const LeftOut& point) { return point.standardised(); });
    const auto count = (errors.abs() > far).count();
    const int most = most_far(errors.size());
    if (count > most)
        return fmt::format(
            "{} of {} points, each left out in turn, lie more than {:g} SD from what the others predict; by chance it "
            "is at most {}.",
            count, errors.size(), far, most);
    const double mean = errors.square().mean();
    const double largest = largest_mean_square(projection);
    if (mean > largest)
        return fmt::format(
            "Points that are left out lie {:.2f} times as far from what the others predict as stated (RMS); by chance "
            "it "
            "is at most {:.2f}.",
            std::sqrt(mean), std::sqrt(largest));
    return {};
}

}  // namespace floes
