#include "match/matching.hpp"

#include <algorithm>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <limits>

#include "campaign/design.hpp"

namespace floes {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Points of [-1, 1]^d, a row each.
Eigen::MatrixXd sample_of(std::size_t axes, int samples, std::uint64_t seed) {
    Design design;
    design.method = DesignMethod::sobol;
    design.points = samples;
    design.axes.assign(axes, DesignAxis{.key = "coordinate", .values = {}, .from = -1, .to = 1});
    const std::vector<DesignPoint> points = design_points(design, seed);
    Eigen::MatrixXd sample(static_cast<Eigen::Index>(points.size()), static_cast<Eigen::Index>(axes));
    for (std::size_t k = 0; k < points.size(); ++k)
        for (std::size_t i = 0; i < axes; ++i)
            sample(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
                std::get<double>(points[k].values[i].data);
    return sample;
}

/// Rows of the points that have data of the target, and the data.
EmulatorData data_of(const MatchData& data, const std::vector<int>& points, std::vector<double> values,
                     std::vector<double> noise) {
    const auto count = static_cast<Eigen::Index>(points.size());
    EmulatorData made;
    made.at.resize(count, static_cast<Eigen::Index>(data.axes.size()));
    for (Eigen::Index k = 0; k < count; ++k)
        made.at.row(k) =
            coordinates_of(data.points[static_cast<std::size_t>(points[static_cast<std::size_t>(k)])]).transpose();
    made.values = Eigen::Map<const Eigen::VectorXd>(values.data(), count);
    made.noise = Eigen::Map<const Eigen::VectorXd>(noise.data(), count);
    return made;
}

/// Of the logarithm of the variance of single runs. With f degrees of freedom the logarithm of a sample variance lies
/// ψ(f/2) + ln(2/f) off on average, and has the variance ψ'(f/2), if single runs are normal.
std::shared_ptr<const Emulator> scatter_emulator(const MatchData& data, const TargetData& target) {
    std::vector<int> points;
    std::vector<double> logs;
    std::vector<double> noise;
    for (std::size_t k = 0; k < target.point.size(); ++k) {
        if (target.runs[k] < 2 || !(target.sample_variance[k] > 0)) continue;
        const double freedom = target.runs[k] - 1;
        const double off = boost::math::digamma(freedom / 2) + std::log(2 / freedom);
        points.push_back(target.point[k]);
        logs.push_back(std::log(target.sample_variance[k]) - off);
        noise.push_back(boost::math::trigamma(freedom / 2));
    }
    if (points.size() < 2) return nullptr;
    auto made = std::make_shared<const Emulator>(data_of(data, points, logs, noise));
    return made->fault().empty() ? made : nullptr;
}

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

Eigen::VectorXd coordinates_of(const MatchPoint& point) {
    return Eigen::Map<const Eigen::VectorXd>(point.coordinates.data(),
                                             static_cast<Eigen::Index>(point.coordinates.size()));
}

EmulatedTarget::EmulatedTarget(const MatchData& data, const TargetData& target)
    : target_(target.target), log_scatter_(scatter_emulator(data, target)) {
    double sum = 0;
    double weight = 0;
    std::vector<double> noise;
    for (std::size_t k = 0; k < target.point.size(); ++k) {
        sum += target.variance[k] * target.runs[k];
        weight += target.runs[k];
        const double variance = log_scatter_
                                    ? scatter(coordinates_of(data.points[static_cast<std::size_t>(target.point[k])]))
                                    : target.variance[k];
        noise.push_back((1 - target.shared) * variance / target.runs[k]);
    }
    pooled_scatter_ = weight > 0 ? sum / weight : 0;
    if (target.point.empty()) {
        unused_ = "no wave has it";
        return;
    }
    common_part_ = target.shared * static_cast<double>(target.point.size()) / weight;
    mean_ = std::make_shared<const Emulator>(data_of(data, target.point, target.mean, noise));
    unused_ = target_.held_out ? "held out" : mean_->fault();
}

double EmulatedTarget::scatter(const Eigen::VectorXd& x) const {
    return log_scatter_ ? std::exp(log_scatter_->at(x).mean) : pooled_scatter_;
}

double EmulatedTarget::expected_difference(const Eigen::VectorXd& x) const {
    return std::sqrt(mean_->at(x).variance + scatter(x) * (common_part_ + 1.0 / target_.runs) +
                     target_.uncertainty * target_.uncertainty + target_.discrepancy * target_.discrepancy);
}

double EmulatedTarget::implausibility(const Eigen::VectorXd& x) const {
    return std::abs(target_.value - mean_->at(x).mean) / expected_difference(x);
}

std::vector<EmulatedTarget> emulate(const MatchData& data) {
    std::vector<EmulatedTarget> targets;
    for (const TargetData& one : data.targets) targets.emplace_back(data, one);
    return targets;
}

Matching match(const MatchData& data, const std::vector<EmulatedTarget>& targets, int samples, std::uint64_t seed) {
    const Eigen::MatrixXd sample = sample_of(data.axes.size(), samples, seed);
    const Eigen::Index rows = sample.rows();
    const auto count = static_cast<Eigen::Index>(targets.size());
    Eigen::MatrixXd implausible(rows, count);
    std::vector<bool> used;
    for (Eigen::Index t = 0; t < count; ++t) {
        const EmulatedTarget& target = targets[static_cast<std::size_t>(t)];
        used.push_back(target.unused().empty());
        for (Eigen::Index k = 0; k < rows; ++k)
            implausible(k, t) = target.emulated() ? target.implausibility(sample.row(k).transpose()) : nan;
    }
    Matching found;
    found.sampled = static_cast<int>(rows);
    found.best_implausibility = std::numeric_limits<double>::infinity();
    found.verdicts.resize(targets.size());
    for (TargetVerdict& verdict : found.verdicts) verdict.least_of_left = nan;
    found.points = sample;
    found.implausibility.resize(rows);
    std::vector<Eigen::Index> left;
    for (Eigen::Index k = 0; k < rows; ++k) {
        double largest = 0;
        int against = 0;
        Eigen::Index last = 0;
        for (Eigen::Index t = 0; t < count; ++t) {
            if (!used[static_cast<std::size_t>(t)]) continue;
            largest = std::max(largest, implausible(k, t));
            if (implausible(k, t) <= ruled_out_above) continue;
            ++against;
            last = t;
            found.verdicts[static_cast<std::size_t>(t)].rules_out += 1.0 / static_cast<double>(rows);
        }
        if (against == 1) found.verdicts[static_cast<std::size_t>(last)].alone += 1.0 / static_cast<double>(rows);
        if (against == 0) left.push_back(k);
        found.implausibility[k] = largest;
        if (largest >= found.best_implausibility) continue;
        found.best_implausibility = largest;
        found.best = sample.row(k).transpose();
    }
    found.left = static_cast<int>(left.size());
    found.points_left = sample(left, Eigen::all);
    for (Eigen::Index t = 0; t < count; ++t) {
        TargetVerdict& verdict = found.verdicts[static_cast<std::size_t>(t)];
        verdict.least = targets[static_cast<std::size_t>(t)].emulated() ? implausible.col(t).minCoeff() : nan;
        if (!left.empty() && targets[static_cast<std::size_t>(t)].emulated())
            verdict.least_of_left = implausible(left, t).minCoeff();
    }
    if (left.empty()) {
        for (Eigen::Index a = 0; a < count; ++a) {
            for (Eigen::Index b = a + 1; b < count; ++b) {
                if (!used[static_cast<std::size_t>(a)] || !used[static_cast<std::size_t>(b)]) continue;
                const double together = implausible.col(a).cwiseMax(implausible.col(b)).minCoeff();
                if (together > ruled_out_above) found.conflicts.emplace_back(static_cast<int>(a), static_cast<int>(b));
            }
        }
        return found;
    }
    for (std::size_t i = 0; i < data.axes.size(); ++i) {
        const Eigen::VectorXd column = found.points_left.col(static_cast<Eigen::Index>(i));
        const std::vector<double> values(column.begin(), column.end());
        const MatchAxis& axis = data.axes[i];
        found.axes.push_back(
            {axis.value(column.minCoeff()), axis.value(column.maxCoeff()), axis.value(quantile(values, 0.5))});
    }
    const Eigen::MatrixXd centred = found.points_left.rowwise() - found.points_left.colwise().mean();
    const Eigen::MatrixXd covariance = centred.transpose() * centred;
    const Eigen::VectorXd lengths = covariance.diagonal().cwiseSqrt().cwiseMax(1e-300);
    found.correlations = lengths.cwiseInverse().asDiagonal() * covariance * lengths.cwiseInverse().asDiagonal();
    return found;
}

Eigen::MatrixXd next_points(const Matching& matching, const MatchData& data, int count) {
    const Eigen::MatrixXd& candidates = matching.points_left;
    if (candidates.rows() == 0) return candidates;
    Eigen::VectorXd nearest = Eigen::VectorXd::Constant(candidates.rows(), std::numeric_limits<double>::infinity());
    const auto keep_away_from = [&](const Eigen::RowVectorXd& point) {
        nearest = nearest.cwiseMin((candidates.rowwise() - point).rowwise().squaredNorm());
    };
    for (const MatchPoint& point : data.points) keep_away_from(coordinates_of(point).transpose());
    std::vector<Eigen::Index> chosen;
    while (static_cast<int>(chosen.size()) < count) {
        Eigen::Index farthest = 0;
        if (chosen.empty()) {
            (candidates.rowwise() - candidates.colwise().mean()).rowwise().squaredNorm().minCoeff(&farthest);
        } else if (!(nearest.maxCoeff(&farthest) > 0)) {
            break;  // no further point differs
        }
        chosen.push_back(farthest);
        keep_away_from(candidates.row(farthest));
    }
    return candidates(chosen, Eigen::all);
}

}  // namespace floes
