#include "inference/numerics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nlopt.h>
#include <Eigen/Dense>

#include "core/contract.hpp"
#include "core/random.hpp"

namespace floes {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using PivotedQr = Eigen::ColPivHouseholderQR<MatrixXd>;

struct Cholesky::Factor {
    Eigen::LLT<MatrixXd> root;
};

Cholesky::Cholesky(const MatrixXd& matrix)
    : factor_(std::make_shared<Factor>(Eigen::LLT<MatrixXd>(matrix))),
      exists_(factor_->root.info() == Eigen::Success) {}

double Cholesky::log_determinant() const {
    FLOES_EXPECTS(exists_);
    return 2 * factor_->root.matrixLLT().diagonal().array().log().sum();
}

VectorXd Cholesky::solve(const VectorXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.solve(right);
}

VectorXd Cholesky::solve_lower(const VectorXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixL().solve(right);
}

MatrixXd Cholesky::solve_lower(const MatrixXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixL().solve(right);
}

VectorXd Cholesky::solve_upper(const VectorXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixU().solve(right);
}

MatrixXd Cholesky::solve_upper(const MatrixXd& right) const {
    FLOES_EXPECTS(exists_);
    return factor_->root.matrixU().solve(right);
}

Eigen::Index rank_of(const MatrixXd& matrix) {
    return PivotedQr(matrix).rank();
}

VectorXd least_squares(const MatrixXd& matrix, const VectorXd& values) {
    FLOES_EXPECTS(matrix.rows() == values.size());
    return PivotedQr(matrix).solve(values);
}

MatrixXd least_squares(const MatrixXd& matrix, const MatrixXd& values) {
    FLOES_EXPECTS(matrix.rows() == values.rows());
    return PivotedQr(matrix).solve(values);
}

VectorXd inverse_norms(const MatrixXd& matrix) {
    // (XᵀX)⁻¹ = P R⁻¹ R⁻ᵀ Pᵀ, so its diagonal is the squared norms of the rows of P R⁻¹.
    const PivotedQr decomposition(matrix);
    const Eigen::Index columns = matrix.cols();
    const MatrixXd inverse = decomposition.matrixR().topRows(columns).triangularView<Eigen::Upper>().solve(
        MatrixXd::Identity(columns, columns));
    return (decomposition.colsPermutation() * inverse).rowwise().norm();
}

std::optional<VectorXd> leverages(const MatrixXd& matrix) {
    const PivotedQr decomposition(matrix);
    if (decomposition.rank() < matrix.cols()) return {};
    const MatrixXd basis = decomposition.householderQ() * MatrixXd::Identity(matrix.rows(), matrix.cols());
    return basis.rowwise().squaredNorm();
}

MatrixXd inverse_of(const MatrixXd& matrix) {
    FLOES_EXPECTS(matrix.rows() == matrix.cols());
    return matrix.inverse();
}

double halved(double low, double high, int times, const std::function<bool(double)>& lies_above) {
    for (int k = 0; k < times; ++k) {
        const double middle = 0.5 * (low + high);
        (lies_above(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double halved_from(double low, int times, const std::function<bool(double)>& lies_above) {
    double high = 2 * low;
    for (int k = 0; k < 60 && lies_above(high); ++k) {
        low = high;
        high *= 2;
    }
    return halved(low, high, times, lies_above);
}

namespace {

struct OptimizerDeleter {
    void operator()(nlopt_opt_s* optimizer) const { nlopt_destroy(optimizer); }
};

constexpr int most_costs = 4000;  // of a walk

double cost_at(unsigned count, const double* point, double*, void* cost) {
    const double found = (*static_cast<const Cost*>(cost))({point, count});
    return std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
}

}  // namespace

Minimum walk_simplex(const Cost& cost, std::span<const double> start, const SimplexOptions& options) {
    Minimum found{{start.begin(), start.end()}, std::numeric_limits<double>::infinity()};
    const std::unique_ptr<nlopt_opt_s, OptimizerDeleter> simplex(
        nlopt_create(NLOPT_LN_NELDERMEAD, static_cast<unsigned>(start.size())));
    nlopt_set_min_objective(simplex.get(), cost_at, const_cast<Cost*>(&cost));
    nlopt_set_initial_step1(simplex.get(), options.size);
    nlopt_set_xtol_abs1(simplex.get(), options.small_enough);
    nlopt_set_maxeval(simplex.get(), most_costs);
    // Any status will do: the least cost so far stands in `found`.
    nlopt_optimize(simplex.get(), found.at.data(), &found.cost);
    return found;
}

namespace {

constexpr std::uint64_t walks = 32;  // of all streams of the bootstrap those that walk
constexpr int between_adaptions = 100;

double normal(RandomStream& random) {
    return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

using Matrix = std::vector<std::vector<double>>;

/// Lower triangle L with L L^T = matrix; a small diagonal keeps it positive.
Matrix root_of(const Matrix& matrix) {
    const std::size_t size = matrix.size();
    Matrix root(size, std::vector<double>(size));
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = matrix[i][j];
            for (std::size_t k = 0; k < j; ++k) sum -= root[i][k] * root[j][k];
            root[i][j] = i == j ? std::sqrt(std::max(sum, 1e-10)) : sum / root[j][j];
        }
    return root;
}

Matrix covariance_of(const std::vector<std::vector<double>>& draws, std::size_t first) {
    const std::size_t size = draws.front().size();
    const double count = static_cast<double>(draws.size() - first);
    std::vector<double> mean(size);
    Matrix covariance(size, std::vector<double>(size));
    for (std::size_t k = first; k < draws.size(); ++k)
        for (std::size_t i = 0; i < size; ++i) mean[i] += draws[k][i] / count;
    for (std::size_t k = first; k < draws.size(); ++k)
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                covariance[i][j] += (draws[k][i] - mean[i]) * (draws[k][j] - mean[j]) / count;
    return covariance;
}

/// A walker at its place.
class Walker {
  public:
    Walker(const LogDensity& density, std::span<const double> start, std::span<const double> sizes, std::uint32_t draw)
        : density_(density), random_(walks, draw, StreamId::bootstrap, 0), at_(start.begin(), start.end()) {
        here_ = density_(at_);
        best_ = here_;
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            root_.emplace_back(sizes.size());
            root_[i][i] = sizes[i];
        }
    }

    void step() {
        std::vector<double> normals(at_.size());
        for (double& one : normals) one = normal(random_);
        std::vector<double> proposed = at_;
        for (std::size_t i = 0; i < at_.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j) proposed[i] += length_ * root_[i][j] * normals[j];
        const double there = density_(proposed);
        ++tried_;
        if (!(std::log(1 - random_.uniform()) < there - here_)) return;
        ++taken_;
        at_ = std::move(proposed);
        here_ = there;
        best_ = std::max(best_, here_);
    }

    /// Steps of the shape of what was met, and of such a length that about a quarter are taken.
    void adapt(const std::vector<std::vector<double>>& met) {
        if (met.size() > 2 * between_adaptions) root_ = root_of(covariance_of(met, met.size() / 2));
        length_ *= std::exp(2 * (static_cast<double>(taken_) / tried_ - 0.27));
        taken_ = tried_ = 0;
    }

    const std::vector<double>& at() const { return at_; }
    bool lost() const { return !std::isfinite(here_); }
    double best() const { return best_; }

  private:
    const LogDensity& density_;
    RandomStream random_;
    std::vector<double> at_;
    Matrix root_;
    double here_ = 0;
    double best_ = 0;
    double length_ = 1;
    int taken_ = 0;
    int tried_ = 0;
};

}  // namespace

Walk walk_at_random(const LogDensity& density, std::span<const double> start, std::span<const double> sizes,
                    const WalkOptions& options) {
    Walk walk;
    Walker walker(density, start, sizes, options.draw);
    if (walker.lost()) return walk;
    std::vector<std::vector<double>> met;
    for (int step = 0; step < options.steps / 3; ++step) {
        walker.step();
        met.push_back(walker.at());
        if ((step + 1) % between_adaptions == 0) walker.adapt(met);
    }
    met.clear();
    for (int step = 0; step < options.steps; ++step) {
        walker.step();
        met.push_back(walker.at());
        if ((step + 1) % std::max(options.steps / options.kept, 1) == 0) walk.draws.push_back(walker.at());
    }
    const Matrix root = root_of(covariance_of(met, 0));
    walk.log_evidence = walker.best();
    for (std::size_t i = 0; i < root.size(); ++i)
        walk.log_evidence += std::log(root[i][i]) + 0.5 * std::log(2 * std::numbers::pi);
    return walk;
}

namespace {

constexpr double nudge = 0.1;            // of a parameter, for second differences
constexpr double least_curvature = 0.1;  // the prior of each parameter has more

std::vector<double> moved(const std::vector<double>& from, const Eigen::VectorXd& by) {
    std::vector<double> to = from;
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += by(static_cast<Eigen::Index>(k));
    return to;
}

Eigen::MatrixXd curvature(const Cost& cost, const Minimum& least) {
    const auto count = static_cast<Eigen::Index>(least.at.size());
    const Eigen::MatrixXd steps = nudge * Eigen::MatrixXd::Identity(count, count);
    Eigen::MatrixXd found(count, count);
    for (Eigen::Index a = 0; a < count; ++a) {
        for (Eigen::Index b = 0; b <= a; ++b) {
            const auto at = [&](double along_a, double along_b) {
                return cost(moved(least.at, along_a * steps.col(a) + along_b * steps.col(b)));
            };
            found(a, b) = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * nudge * nudge);
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
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solved(curvature(cost, least));
    const Eigen::VectorXd sds = solved.eigenvalues().array().max(least_curvature).rsqrt();
    const Eigen::MatrixXd ways = solved.eigenvectors() * sds.asDiagonal() * corners(sds.size());
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
