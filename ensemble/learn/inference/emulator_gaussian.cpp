// Gaussian processes as emulators: the likeliest lengths and variances.

#include <algorithm>
#include <cmath>
#include <limits>

#include "inference/emulator_forms.hpp"
#include "inference/posterior_spread.hpp"
#include "inference/simplex.hpp"

namespace floes {

namespace {

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
constexpr Prior extra{0.1, 3, 1e-6, 10};
constexpr double worth = 2;  // gain in log likelihood for which the extra variance is accepted

/// The restricted likelihood of parameters: logarithms of the lengths, of the variance and, if there, of the extra one.
class Likelihood {
  public:
    explicit Likelihood(const EmulatorData& data)
        : data_(data),
          trend_(determines(data.at, EmulatorKind::linear) ? EmulatorKind::linear : EmulatorKind::constant),
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
        if (logs.size() > axes() + 1) covariance.extra = extra.cut(logs[axes() + 1]);
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
        if (logs.size() > axes() + 1) sum += extra.cost(logs[axes() + 1]);
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

}  // namespace

Eigen::VectorXd shared_variance(const EmulatorCovariance& covariance, const Eigen::MatrixXd& squares) {
    const Eigen::VectorXd per_square = covariance.lengths.array().square().inverse();
    const Eigen::ArrayXd apart = (5 * (squares * per_square)).array().sqrt();
    return covariance.variance * (1 + apart + apart.square() / 3) * (-apart).exp();
}

EmulatorForm fit_gaussian_process(const EmulatorData& data) {
    const Likelihood likelihood(data);
    const Cost cost = [&](std::span<const double> logs) { return likelihood.cost(logs); };
    const Minimum smooth = likeliest(cost, likelihood.axes());
    std::vector<double> start = smooth.at;
    start.push_back(std::log(extra.centre));
    const Minimum rough = walk_simplex(cost, sweep(cost, std::move(start)).at, {0.3, 1e-3});
    EmulatorForm form{EmulatorKind::gaussian_process, likelihood.trend(), {}};
    for (const std::vector<double>& logs : spread(cost, rough.cost < smooth.cost - worth ? rough : smooth))
        form.parts.push_back(likelihood.part(logs));
    return form;
}

}  // namespace floes
