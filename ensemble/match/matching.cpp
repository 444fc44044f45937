#include "match/matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

#include "campaign/design.hpp"
#include "core/undefined.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"
#include "statistics/distributions.hpp"

namespace floes {

DividedRows rows_of(std::span<const DividedRun> runs) {
    DividedRows made;
    for (const DividedRun& run : runs) {
        made.rows.push_back(run.row);
        made.mean += run.mean / static_cast<double>(runs.size());
    }
    return made;
}

CaseRuns runs_of(std::span<const MatchWave> waves, const MatchData& data, const std::vector<bool>& left,
                 const EmulatedTarget& mean_maximum, const DesignLoadRequest& request) {
    CaseRuns made;
    for (std::size_t k = 0; k < data.points.size(); ++k) {
        const MatchPoint& point = data.points[k];
        const MatchWave& wave = waves[static_cast<std::size_t>(point.wave)];
        const double time = averaging_time(wave.table, request);
        const double index = mean_maximum.mean().at(coordinates_of(point)).mean;
        for (const MemberRow& row : wave.table.members) {
            const auto number = static_cast<std::size_t>(row.case_index);
            const Case& about = wave.campaign.cases[number];
            if (about.point != point.number || about.base != mean_maximum.target().case_name) continue;
            const AveragedLoad* averaged = row.averaged_over(time);
            if (averaged == nullptr) continue;
            DividedRun run{index, left[k], row.load.mean / index, {averaged->peaks, averaged->segment_maximum}};
            for (double& peak : run.row.peaks) peak /= index;
            for (double& maximum : run.row.segment_maxima) maximum /= index;
            made.runs.push_back(std::move(run));
            const Analysis& analysis = wave.table.cases[number].analysis;
            made.measured = {analysis.window, analysis.window / analysis.segments, analysis.peak_separation, 0};
        }
    }
    return made;
}

namespace {

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

/// Emulates the logarithm of the variance of single runs. With f degrees of freedom that of a sample variance lies
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

/// Degrees of freedom of a sample variance whose logarithm has this variance. Newton's method on 1/ψ', which is convex
/// and nearly a straight line.
double freedom_of(double variance_of_log) {
    constexpr double as_good_as_known = 1e-6;
    if (variance_of_log < as_good_as_known) return 2 / as_good_as_known;
    double half = 0.5 + 1 / variance_of_log;
    for (int k = 0; k < 50; ++k) {
        const double value = boost::math::trigamma(half);
        const double step = value * (1 - value / variance_of_log) / boost::math::polygamma(2, half);
        half += step;
        if (std::abs(step) < 1e-10 * half) break;
    }
    return 2 * half;
}

/// Three, or Student's quantile that 1 % exceed where that is more.
double bound_of(double freedom) {
    constexpr double tail = 0.005;
    return std::max(ruled_out_above, student_t(std::max(1.0, freedom), tail));
}

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// A row each point, a column each target; NaN where a target is not emulated.
Eigen::MatrixXd implausibilities(const std::vector<EmulatedTarget>& targets, const Eigen::MatrixXd& points) {
    Eigen::MatrixXd implausible(points.rows(), static_cast<Eigen::Index>(targets.size()));
    for (Eigen::Index t = 0; t < implausible.cols(); ++t) {
        const EmulatedTarget& target = targets[static_cast<std::size_t>(t)];
        for (Eigen::Index k = 0; k < points.rows(); ++k)
            implausible(k, t) = target.emulated() ? target.implausibility(points.row(k).transpose()) : undefined;
    }
    return implausible;
}

/// Finds the largest implausibility of each point, the best point, and what each used target rules out. Gives the rows
/// of the points that no target rules out.
std::vector<Eigen::Index> judge(const std::vector<EmulatedTarget>& targets, const Eigen::MatrixXd& implausible,
                                Matching& found) {
    const double share = 1.0 / static_cast<double>(implausible.rows());  // of one point
    found.best_implausibility = std::numeric_limits<double>::infinity();
    found.verdicts.resize(targets.size());
    found.implausibility.resize(implausible.rows());
    std::vector<Eigen::Index> left;
    for (Eigen::Index k = 0; k < implausible.rows(); ++k) {
        double largest = 0;
        std::vector<std::size_t> against;
        for (std::size_t t = 0; t < targets.size(); ++t) {
            if (!targets[t].unused().empty()) continue;
            const double found_here = implausible(k, static_cast<Eigen::Index>(t));
            largest = std::max(largest, found_here);
            if (found_here > ruled_out_above) against.push_back(t);
        }
        for (const std::size_t t : against) found.verdicts[t].rules_out += share;
        if (against.size() == 1) found.verdicts[against.front()].alone += share;
        if (against.empty()) left.push_back(k);
        found.implausibility[k] = largest;
        if (largest >= found.best_implausibility) continue;
        found.best_implausibility = largest;
        found.best = found.points.row(k).transpose();
    }
    return left;
}

/// Pairs of used targets that no point meets both of.
std::vector<std::pair<int, int>> conflicts(const std::vector<EmulatedTarget>& targets,
                                           const Eigen::MatrixXd& implausible) {
    std::vector<std::pair<int, int>> pairs;
    for (int a = 0; a < std::ssize(targets); ++a) {
        for (int b = a + 1; b < std::ssize(targets); ++b) {
            if (!targets[static_cast<std::size_t>(a)].unused().empty() ||
                !targets[static_cast<std::size_t>(b)].unused().empty())
                continue;
            const double together = implausible.col(a).cwiseMax(implausible.col(b)).minCoeff();
            if (together > ruled_out_above) pairs.emplace_back(a, b);
        }
    }
    return pairs;
}

/// The range of each input and their correlations in points_left, which has rows.
void describe_left(const MatchData& data, Matching& found) {
    for (std::size_t i = 0; i < data.axes.size(); ++i) {
        const Eigen::VectorXd column = found.points_left.col(static_cast<Eigen::Index>(i));
        const MatchAxis& axis = data.axes[i];
        found.axes.push_back({axis.value(column.minCoeff()), axis.value(column.maxCoeff()),
                              axis.value(quantile({column.begin(), column.end()}, 0.5))});
    }
    const Eigen::MatrixXd centred = found.points_left.rowwise() - found.points_left.colwise().mean();
    const Eigen::MatrixXd covariance = centred.transpose() * centred;
    const Eigen::VectorXd lengths = covariance.diagonal().cwiseSqrt().cwiseMax(1e-300);
    found.correlations = lengths.cwiseInverse().asDiagonal() * covariance * lengths.cwiseInverse().asDiagonal();
}

}  // namespace

Eigen::VectorXd coordinates_of(const MatchPoint& point) {
    return Eigen::Map<const Eigen::VectorXd>(point.coordinates.data(),
                                             static_cast<Eigen::Index>(point.coordinates.size()));
}

EmulatedTarget::EmulatedTarget(const MatchData& data, const TargetData& target)
    : target_(target.target), log_scatter_(scatter_emulator(data, target)) {
    double weight = 0;
    for (std::size_t k = 0; k < target.point.size(); ++k) {
        pooled_scatter_.variance += target.variance[k] * target.runs[k];
        pooled_scatter_.freedom += target.runs[k] - 1;
        weight += target.runs[k];
    }
    if (weight > 0) pooled_scatter_.variance /= weight;
    std::vector<double> noise;
    for (std::size_t k = 0; k < target.point.size(); ++k) {
        const double variance = log_scatter_
                                    ? scatter(coordinates_of(data.points[static_cast<std::size_t>(target.point[k])]))
                                    : target.variance[k];
        noise.push_back((1 - target.shared) * variance / target.runs[k]);
    }
    if (target.point.empty()) {
        unused_ = "no wave has it";
        return;
    }
    common_part_ = target.shared * static_cast<double>(target.point.size()) / weight;
    mean_ = std::make_shared<const Emulator>(data_of(data, target.point, target.mean, noise));
    unused_ = target_.held_out ? "held out" : mean_->fault();
}

EmulatedTarget::ScatterAt EmulatedTarget::scatter_at(const Eigen::VectorXd& x) const {
    constexpr double least_share = 0.1;
    if (!log_scatter_) return pooled_scatter_;
    const Emulated log = log_scatter_->at(x);
    return {std::max(std::exp(log.mean + 0.5 * log.variance), least_share * pooled_scatter_.variance),
            freedom_of(log.variance)};
}

double EmulatedTarget::expected_difference(const Eigen::VectorXd& x) const {
    return difference_of(mean_->at(x).variance, scatter(x));
}

double EmulatedTarget::difference_of(double mean_variance, double scatter) const {
    return std::sqrt(mean_variance + scatter * (common_part_ + 1.0 / target_.runs) +
                     target_.uncertainty * target_.uncertainty + target_.discrepancy * target_.discrepancy);
}

Comparison EmulatedTarget::compared(const Eigen::VectorXd& x) const {
    const Emulated mean = mean_->at(x);
    const ScatterAt scatter = scatter_at(x);
    const double difference = difference_of(mean.variance, scatter.variance);
    const double by_scatter = scatter.variance * (common_part_ + 1.0 / target_.runs);
    const double share = by_scatter / (difference * difference);
    const double bound = share > 0 ? bound_of(scatter.freedom / (share * share)) : ruled_out_above;
    return {mean.mean, difference, std::abs(target_.value - mean.mean) / difference, bound};
}

std::vector<EmulatedTarget> emulate(const MatchData& data) {
    std::vector<EmulatedTarget> targets;
    for (const TargetData& one : data.targets) targets.emplace_back(data, one);
    return targets;
}

Matching match(const MatchData& data, const std::vector<EmulatedTarget>& targets, int samples, std::uint64_t seed) {
    Matching found;
    found.points = sample_of(data.axes.size(), samples, seed);
    found.sampled = static_cast<int>(found.points.rows());
    const Eigen::MatrixXd implausible = implausibilities(targets, found.points);
    const std::vector<Eigen::Index> left = judge(targets, implausible, found);
    found.left = static_cast<int>(left.size());
    found.points_left = found.points(left, Eigen::all);
    for (std::size_t t = 0; t < targets.size(); ++t) {
        TargetVerdict& verdict = found.verdicts[t];
        const auto column = static_cast<Eigen::Index>(t);
        const bool emulated = targets[t].emulated();
        Eigen::Index nearest = 0;
        verdict.least = emulated ? implausible.col(column).minCoeff(&nearest) : undefined;
        verdict.bound = emulated ? targets[t].compared(found.points.row(nearest).transpose()).bound : undefined;
        verdict.least_of_left = emulated && !left.empty() ? implausible(left, column).minCoeff() : undefined;
    }
    if (left.empty()) {
        found.conflicts = conflicts(targets, implausible);
    } else {
        describe_left(data, found);
    }
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

namespace {

/// A number of six digits, as an axis takes it.
Value value_of(const DesignAxis& axis, double number) {
    Value value;
    if (axis.whole) {
        value.data = static_cast<std::int64_t>(std::llround(number));
    } else {
        value.data = std::stod(fmt::format("{:.6g}", number));
    }
    return value;
}

}  // namespace

Campaign next_wave(const MatchWave& wave, const std::vector<MatchAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name, std::uint64_t seed) {
    Campaign next = wave.campaign;
    next.name = name;
    next.seed = seed;
    next.cases.clear();
    next.design.method = DesignMethod::list;
    next.design.points = 0;
    next.design.indices = false;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        DesignAxis& axis = next.design.axes[k];
        axis.values.clear();
        for (Eigen::Index row = 0; row < coordinates.rows(); ++row)
            axis.values.push_back(value_of(axis, axes[k].value(coordinates(row, static_cast<Eigen::Index>(k)))));
    }
    std::set<std::string> bases;
    for (const Case& one : wave.campaign.cases) {
        if (!bases.insert(one.base).second) continue;
        for (Eigen::Index row = 0; row < coordinates.rows(); ++row) {
            Case& made = next.cases.emplace_back(one);
            made.point = static_cast<int>(row);
            made.name = fmt::format("{}{}p{:03}", one.base, one.base.empty() ? "" : "+", row);
            const Keys keys = describe(made.scenario);
            for (const DesignAxis& axis : next.design.axes)
                assign(*find_key(keys, axis.key), {axis.key, axis.values[static_cast<std::size_t>(row)], "next wave"});
        }
    }
    return next;
}

}  // namespace floes
