// Polynomials of few terms as emulators, and the terms of mean functions.

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <optional>

#include "inference/emulator_forms.hpp"

namespace floes {

namespace {

constexpr Eigen::Index fewest_spare = 3;  // points more than terms, so that forms can be compared

double freedom_of(const Eigen::MatrixXd& terms) {
    return static_cast<double>(terms.rows() - terms.cols());
}

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

}  // namespace

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

bool determines(const Eigen::MatrixXd& at, EmulatorKind trend) {
    const Eigen::MatrixXd terms = trend_terms(trend, at);
    if (terms.rows() <= terms.cols()) return false;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(terms);
    if (decomposition.rank() < terms.cols()) return false;
    // A point of leverage 1 determines a term alone.
    const Eigen::MatrixXd basis = decomposition.householderQ() * Eigen::MatrixXd::Identity(terms.rows(), terms.cols());
    return basis.rowwise().squaredNorm().maxCoeff() < 1 - 1e-6;
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

}  // namespace floes
