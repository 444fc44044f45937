#include "inference/emulator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include "core/error.hpp"
#include "statistics/distributions.hpp"

namespace floes {

Kriging::Kriging(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& trend, const Eigen::VectorXd& values)
    : root_(covariance) {
    if (!root_.exists()) return;
    trend_ = root_.solve_lower(trend);
    precision_ = Cholesky(trend_.transpose() * trend_);
    if (!precision_.exists()) return;
    const Eigen::VectorXd white = root_.solve_lower(values);
    beta_ = precision_.solve(trend_.transpose() * white);
    const Eigen::VectorXd rest = white - trend_ * beta_;
    misfit_ = rest.squaredNorm();
    weights_ = root_.solve_upper(rest);
    valid_ = weights_.allFinite() && beta_.allFinite();
}

double Kriging::log_likelihood() const {
    return -0.5 * (root_.log_determinant() + precision_.log_determinant() + misfit_);
}

Emulated Kriging::at(const Eigen::VectorXd& f, const Eigen::VectorXd& k, double prior) const {
    const Eigen::VectorXd white = root_.solve_lower(k);
    const Eigen::VectorXd rest = f - trend_.transpose() * white;
    const Eigen::VectorXd unknown = precision_.solve_lower(rest);
    const double variance = prior - white.squaredNorm() + unknown.squaredNorm();
    return {f.dot(beta_) + k.dot(weights_), std::max(variance, 0.0)};
}

Eigen::MatrixXd Kriging::projection() const {
    const Eigen::Index count = trend_.rows();
    const Eigen::MatrixXd half = precision_.solve_lower(Eigen::MatrixXd(trend_.transpose()));
    const Eigen::MatrixXd inside = Eigen::MatrixXd::Identity(count, count) - half.transpose() * half;
    const Eigen::MatrixXd left = root_.solve_upper(inside);
    return root_.solve_upper(Eigen::MatrixXd(left.transpose()));
}

namespace {

/// Added to every noise variance so that the equations can be solved; negligible beside deviations of 1.
constexpr double solvable = 1e-10;

/// One row for each row of `at`: 1, then the coordinates, then their products in pairs; as many as the trend has.
Eigen::MatrixXd trend_terms(EmulatorKind trend, const Eigen::MatrixXd& at) {
    const Eigen::Index axes = at.cols();
    const Eigen::Index linear = trend == EmulatorKind::constant ? 0 : axes;
    const Eigen::Index products = trend == EmulatorKind::quadratic ? axes * (axes + 1) / 2 : 0;
    Eigen::MatrixXd terms(at.rows(), 1 + linear + products);
    terms.col(0).setOnes();
    terms.middleCols(1, linear) = at.leftCols(linear);
    Eigen::Index column = 1 + linear;
    for (Eigen::Index a = 0; products > 0 && a < axes; ++a)
        for (Eigen::Index b = a; b < axes; ++b) terms.col(column++) = at.col(a).cwiseProduct(at.col(b));
    return terms;
}

/// Whether a trend has fewer terms than there are points, and every one is determined without any single point.
bool determines(const Eigen::MatrixXd& at, EmulatorKind trend) {
    const Eigen::MatrixXd terms = trend_terms(trend, at);
    if (terms.rows() <= terms.cols()) return false;
    const std::optional<Eigen::VectorXd> found = leverages(terms);
    return found && found->maxCoeff() < 1 - 1e-6;  // a point of leverage 1 determines a term alone
}

EmulatorKind plane_or_constant(const Eigen::MatrixXd& at) {
    return determines(at, EmulatorKind::linear) ? EmulatorKind::linear : EmulatorKind::constant;
}

double freedom_of(const Eigen::MatrixXd& terms) {
    return static_cast<double>(terms.rows() - terms.cols());
}

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

/// Mean and variance of predictions of equal weight.
Emulated combined(const std::vector<Emulated>& predictions) {
    const double count = static_cast<double>(predictions.size());
    Emulated sum;
    for (const Emulated& one : predictions) sum.mean += one.mean / count;
    for (const Emulated& one : predictions)
        sum.variance += (one.variance + (one.mean - sum.mean) * (one.mean - sum.mean)) / count;
    return sum;
}

/// In the order and unit of the values.
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

/// Emulator::fault().
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
            "it is at most {:.2f}.",
            std::sqrt(mean), std::sqrt(largest));
    return {};
}

// Gaussian processes as emulators: the likeliest lengths and variances.

/// Prior of a parameter: normal in its logarithm, and cut.
struct Prior {
    double centre;
    double sd;  ///< of the logarithm
    double least;
    double most;

    double cost(double log) const { return 0.5 * std::pow((log - std::log(centre)) / sd, 2); }
    double cut(double log) const { return std::clamp(std::exp(log), least, most); }
};

constexpr Prior length{1, 1, 0.2, 20};      // half axes
constexpr Prior variance{1, 3, 1e-6, 1e4};  // squared deviations from a plane
constexpr Prior extra_prior{0.1, 3, 1e-6, 10};
constexpr double worth = 2;  // gain in log likelihood for which the extra variance is accepted

/// Covariance of the correlated part for pairs of points; `squares`: of their differences, pairs x axes.
Eigen::VectorXd shared_variance(const EmulatorCovariance& covariance, const Eigen::MatrixXd& squares) {
    const Eigen::VectorXd per_square = covariance.lengths.array().square().inverse();
    const Eigen::ArrayXd apart = (5 * (squares * per_square)).array().sqrt();
    return covariance.variance * (1 + apart + apart.square() / 3) * (-apart).exp();
}

/// The restricted likelihood of parameters: logarithms of the lengths, of the variance and, if there, of the extra one.
class Likelihood {
  public:
    explicit Likelihood(const EmulatorData& data)
        : data_(data),
          trend_(plane_or_constant(data.at)),
          terms_(trend_terms(trend_, data.at)),
          squares_(data.at.rows() * (data.at.rows() - 1) / 2, data.at.cols()) {
        Eigen::Index pair = 0;
        for (Eigen::Index a = 0; a < data.at.rows(); ++a)
            for (Eigen::Index b = a + 1; b < data.at.rows(); ++b)
                squares_.row(pair++) = (data.at.row(a) - data.at.row(b)).array().square();
    }

    EmulatorForm::Part part(std::span<const double> logs) const {
        EmulatorCovariance covariance{Eigen::VectorXd(axes()), variance.cut(logs[axes()]), 0};
        for (std::size_t axis = 0; axis < axes(); ++axis) covariance.lengths[axis] = length.cut(logs[axis]);
        if (logs.size() > axes() + 1) covariance.extra = extra_prior.cut(logs[axes() + 1]);
        const Eigen::VectorXd shared = shared_variance(covariance, squares_);
        Eigen::MatrixXd matrix(data_.at.rows(), data_.at.rows());
        Eigen::Index pair = 0;
        for (Eigen::Index a = 0; a < matrix.rows(); ++a) {
            const Eigen::Index below = matrix.rows() - 1 - a;
            matrix(a, a) = covariance.variance * (1 + solvable) + covariance.extra + data_.noise(a);
            matrix.col(a).tail(below) = shared.segment(pair, below);
            pair += below;
        }
        return {covariance, Kriging(matrix, terms_, data_.values)};
    }

    double cost(std::span<const double> logs) const {
        const EmulatorForm::Part found = part(logs);
        if (!found.kriging.valid()) return std::numeric_limits<double>::infinity();
        double sum = -found.kriging.log_likelihood() + variance.cost(logs[axes()]);
        for (std::size_t axis = 0; axis < axes(); ++axis) sum += length.cost(logs[axis]);
        if (logs.size() > axes() + 1) sum += extra_prior.cost(logs[axes() + 1]);
        return sum;
    }

    EmulatorKind trend() const { return trend_; }
    std::size_t axes() const { return static_cast<std::size_t>(data_.at.cols()); }

  private:
    const EmulatorData& data_;
    EmulatorKind trend_;
    Eigen::MatrixXd terms_;
    Eigen::MatrixXd squares_;  // of coordinate differences: pairs of points x axes
};

/// Steps along one parameter at a time: finds which axes matter before a simplex walks along all of them.
Minimum sweep(const Cost& cost, std::vector<double> start) {
    Minimum best{std::move(start), 0};
    best.cost = cost(best.at);
    for (const double step : {1.5, 1.0, 0.5}) {
        for (std::size_t k = 0; k < best.at.size(); ++k) {
            for (const double way : {-step, step}) {
                std::vector<double> at = best.at;
                at[k] += way;
                if (const double found = cost(at); found < best.cost) best = {std::move(at), found};
            }
        }
    }
    return best;
}

/// From short, middle and long lengths.
Minimum likeliest(const Cost& cost, std::size_t axes) {
    Minimum best{{}, std::numeric_limits<double>::infinity()};
    for (const double first : {0.7, 2.0, 6.0}) {
        std::vector<double> start(axes, std::log(first));
        start.push_back(std::log(first * first));
        const Minimum swept = sweep(cost, std::move(start));
        const Minimum found = walk_simplex(cost, swept.at, {0.5, 0.1});
        if (best.at.empty() || found.cost < best.cost) best = found;
    }
    return walk_simplex(cost, best.at, {0.2, 1e-3});
}

EmulatorForm fit_gaussian_process(const EmulatorData& data) {
    const Likelihood likelihood(data);
    const Cost cost = [&](std::span<const double> logs) { return likelihood.cost(logs); };
    const Minimum smooth = likeliest(cost, likelihood.axes());
    std::vector<double> start = smooth.at;
    start.push_back(std::log(extra_prior.centre));
    const Minimum rough = walk_simplex(cost, sweep(cost, std::move(start)).at, {0.3, 1e-3});
    EmulatorForm form{EmulatorKind::gaussian_process, likelihood.trend(), {}};
    for (const std::vector<double>& logs : spread(cost, rough.cost < smooth.cost - worth ? rough : smooth))
        form.parts.push_back(likelihood.part(logs));
    return form;
}

// Polynomials of few terms as emulators.

constexpr Eigen::Index fewest_spare = 3;  // points more than terms, so that forms can be compared

Kriging solve(const EmulatorData& data, const Eigen::MatrixXd& terms, double extra) {
    return {Eigen::MatrixXd((data.noise.array() + extra).matrix().asDiagonal()), terms, data.values};
}

/// The variance beside the noise: none if the deviations are no larger than expected. Else it is where they are that of
/// ν - 2 degrees of freedom instead of ν (R. C. Paule and J. Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377-385), so
/// that an SD from few deviations has the variance of Student's t; at most three times the variance.
double extra_variance(const EmulatorData& data, const Eigen::MatrixXd& terms) {
    const double freedom = freedom_of(terms);
    if (solve(data, terms, 0).misfit() <= freedom) return 0;
    const double aim = std::max(freedom - 2, freedom / 3);
    const auto excess = [&](double log_extra) {
        return std::log(solve(data, terms, std::exp(log_extra)).misfit() / aim);
    };
    const double low = std::log(solvable) - 10;
    double high = 0;
    while (excess(high) > 0) high += 2;
    std::uintmax_t steps = 100;
    const auto bracket =
        boost::math::tools::toms748_solve(excess, low, high, boost::math::tools::eps_tolerance<double>(40), steps);
    return std::exp(0.5 * (bracket.first + bracket.second));
}

/// Sum of the log densities of the values, each predicted without itself; without the constant.
double predictive_score(const EmulatorForm& form, const Eigen::VectorXd& values) {
    double sum = 0;
    for (const LeftOut& point : predict_left_out(form, values))
        sum -= std::log(point.sd) + 0.5 * point.standardised() * point.standardised();
    return sum;
}

EmulatorForm fit_trend(const EmulatorData& data, EmulatorKind trend) {
    const Eigen::MatrixXd terms = trend_terms(trend, data.at);
    const double extra = extra_variance(data, terms);
    EmulatorCovariance covariance;
    covariance.extra = extra;
    return {trend, trend, {EmulatorForm::Part{covariance, solve(data, terms, extra)}}};
}

EmulatorForm fit_polynomial(const EmulatorData& data) {
    EmulatorForm best = fit_trend(data, EmulatorKind::constant);
    double score = predictive_score(best, data.values);
    for (const EmulatorKind trend : {EmulatorKind::linear, EmulatorKind::quadratic}) {
        if (trend_terms(trend, data.at.topRows(1)).cols() + fewest_spare > data.at.rows()) continue;
        if (!determines(data.at, trend)) continue;
        EmulatorForm form = fit_trend(data, trend);
        const double found = predictive_score(form, data.values);
        if (!(found > score)) continue;
        best = std::move(form);
        score = found;
    }
    return best;
}

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
    const Eigen::MatrixXd terms = trend_terms(plane_or_constant(data.at), data.at);
    const Eigen::VectorXd rest = data.values - terms * least_squares(terms, data.values);
    const double from_plane = rest.squaredNorm() / freedom_of(terms);
    const double from_mean = (data.values.array() - data.values.mean()).square().mean();
    if (from_plane > 1e-12 * from_mean && from_mean > 1e-24 * data.values.squaredNorm()) return std::sqrt(from_plane);
    const double size = std::max({1e-12 * from_mean, data.noise.mean(), 1e-24 * data.values.squaredNorm()});
    return size > 0 ? std::sqrt(size) : 1;
}

EmulatorForm fitted(const EmulatorData& data) {
    return data.at.rows() >= points_for_gaussian_process(static_cast<int>(data.at.cols())) ? fit_gaussian_process(data)
                                                                                           : fit_polynomial(data);
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

const char* name_of(EmulatorKind kind) {
    constexpr std::array names{"constant", "linear", "quadratic", "Gaussian process"};
    return names.at(static_cast<std::size_t>(kind));
}

std::string Emulator::simpler() const {
    if (kind() == EmulatorKind::gaussian_process) return {};
    const char* what = kind() == EmulatorKind::constant ? "a constant, the same at all inputs,"
                       : kind() == EmulatorKind::linear ? "a plane"
                                                        : "a quadratic";
    return fmt::format("is {} because it has {} points; {} or more make it a Gaussian process, which follows them",
                       what, scaled_.data.at.rows(),
                       points_for_gaussian_process(static_cast<int>(scaled_.data.at.cols())));
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
