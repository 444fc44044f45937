#include "match/matching.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

#include "campaign/design.hpp"
#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "findings/summary.hpp"
#include "keys/read.hpp"
#include "scenario/keys.hpp"
#include "statistics/distributions.hpp"

namespace floes {

DividedRows rows_of(std::span<const DividedRun> runs, Measured measured) {
    DividedRows made{{}, measured};
    made.measured.mean = 0;
    for (const DividedRun& run : runs) {
        made.rows.push_back(run.row);
        made.measured.mean += run.mean / static_cast<double>(runs.size());
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
        for (std::size_t member = 0; member < wave.table.members.size(); ++member) {
            const MemberRow& row = wave.table.members[member];
            const auto number = static_cast<std::size_t>(row.case_index);
            const Case& about = wave.campaign.cases[number];
            if (about.point != point.number || about.base != mean_maximum.target().case_name) continue;
            const AveragedLoad* averaged = row.averaged_over(time);
            if (averaged == nullptr) continue;
            if (!(index > 0))
                throw InputError(fmt::format(
                    "{}: the emulated mean maximum at point {} of the design is {:.3g} N, which is no load; run more "
                    "points, or loads that differ less",
                    wave.file, point.number, index));
            DividedRun run{member, index, left[k], row.load.mean / index, {averaged->peaks, averaged->segment_maximum}};
            for (double& peak : run.row.peaks) peak /= index;
            for (double& maximum : run.row.segment_maxima) maximum /= index;
            made.runs.push_back(std::move(run));
            // Of windows that differ the mean, so that with all runs it is the time that they had.
            const Analysis& analysis = wave.table.cases[number].analysis;
            const auto count = static_cast<double>(made.runs.size());
            made.measured.window += (analysis.window - made.measured.window) / count;
            made.measured.segment += (analysis.window / analysis.segments - made.measured.segment) / count;
            made.measured.separation = std::max(made.measured.separation, analysis.peak_separation);
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
std::shared_ptr<const Emulator> scatter_emulator(const MatchData& data, const TargetData& target,
                                                 std::string& why_not) {
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
    why_not = "fewer than two points have runs that differ";
    if (points.size() < 2) return nullptr;
    auto made = std::make_shared<const Emulator>(data_of(data, points, logs, noise));
    why_not = made->fault();
    return why_not.empty() ? made : nullptr;
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
        const RangedAxis& axis = data.axes[i];
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
    : target_(target.target), log_scatter_(scatter_emulator(data, target, no_scatter_)) {
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

std::vector<std::string> EmulatedTarget::simplifications() const {
    std::vector<std::string> made;
    if (!emulated()) return made;
    if (const std::string simpler = mean_->simpler(); !simpler.empty())
        made.push_back(fmt::format("{}: its emulator {}.", target_.name(), simpler));
    if (!log_scatter_)
        made.push_back(
            fmt::format("{}: the scatter of single runs is taken as the same at all inputs: {}; run more "
                        "arrangements.",
                        target_.name(), no_scatter_.substr(0, no_scatter_.find_last_not_of('.') + 1)));
    return made;
}

EmulatedTarget::ScatterAt EmulatedTarget::scatter_at(const Eigen::VectorXd& x) const {
    constexpr double least_share = 0.1;
    if (!log_scatter_) return pooled_scatter_;
    const Emulated log = log_scatter_->at(x);
    return {std::max(std::exp(log.mean + 0.5 * log.variance), least_share * pooled_scatter_.variance),
            freedom_of(log.variance)};
}

Comparison EmulatedTarget::compared(const Eigen::VectorXd& x) const {
    const Emulated mean = mean_->at(x);
    const ScatterAt scatter = scatter_at(x);
    const double by_scatter = scatter.variance * (common_part_ + 1.0 / target_.runs);
    const double difference = std::sqrt(mean.variance + by_scatter + target_.uncertainty * target_.uncertainty +
                                        target_.discrepancy * target_.discrepancy);
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
    }
    if (left.empty()) {
        found.conflicts = conflicts(targets, implausible);
    } else {
        describe_left(data, found);
    }
    return found;
}

namespace {

/// As an axis takes it: a whole number, or one of six digits.
double taken(bool whole, double number) {
    return whole ? std::round(number) : std::stod(fmt::format("{:.6g}", number));
}

Value value_of(const DesignAxis& axis, double number) {
    Value value;
    const double given = taken(axis.whole, number);
    if (axis.whole) {
        value.data = static_cast<std::int64_t>(given);
    } else {
        value.data = given;
    }
    return value;
}

/// The points as the next wave has them, of which some may be the same.
Eigen::MatrixXd taken(const std::vector<RangedAxis>& axes, Eigen::MatrixXd points) {
    for (std::size_t k = 0; k < axes.size(); ++k)
        for (double& x : points.col(static_cast<Eigen::Index>(k)))
            x = axes[k].coordinate(taken(axes[k].whole, axes[k].value(x)));
    return points;
}

}  // namespace

Eigen::MatrixXd next_points(const Matching& matching, const MatchData& data, int count) {
    if (matching.points_left.rows() == 0) return matching.points_left;
    const Eigen::MatrixXd candidates = taken(data.axes, matching.points_left);
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

Campaign next_wave(const MatchWave& wave, const std::vector<RangedAxis>& axes, const Eigen::MatrixXd& coordinates,
                   const std::string& name, std::uint64_t seed) {
    Campaign next = wave.campaign;
    next.name = name;
    next.seed = seed;
    next.cases.clear();
    next.run.base_case.clear();  // a point of this wave
    const auto names_a_point = [](const std::string& word) { return word != "all" && word != "none"; };
    if (names_a_point(next.stop.case_name) || names_a_point(next.stop.contrast)) next.stop = {};
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

namespace {

/// Logarithms of the weights, up to a constant.
std::vector<double> log_likelihoods(const Eigen::MatrixXd& points, const std::vector<EmulatedTarget>& targets) {
    std::vector<double> logs(static_cast<std::size_t>(points.rows()), 0.0);
    for (const EmulatedTarget& target : targets) {
        if (!target.unused().empty()) continue;
        for (std::size_t k = 0; k < logs.size(); ++k) {
            const Comparison here = target.compared(points.row(static_cast<Eigen::Index>(k)).transpose());
            const double off = here.implausibility();
            logs[k] -= off * off / 2 + std::log(here.expected);
        }
    }
    return logs;
}

/// For the mixture of normal distributions.
Estimate range_of(const AtPoints& at, const std::vector<double>& weights, double least, double most) {
    const auto roots = [](const std::vector<double>& variances) {
        std::vector<double> sd;
        for (const double variance : variances) sd.push_back(std::sqrt(std::max(variance, 1e-300)));
        return sd;
    };
    const std::vector<double> sd = roots(at.variance);
    const std::vector<double> sd_above = at.variance_above.empty() ? sd : roots(at.variance_above);
    const auto below = [&](double x) {
        double share = 0;
        for (std::size_t k = 0; k < sd.size(); ++k) {
            const double off = x - at.mean[k];
            share += weights[k] * normal_below(off / (off > 0 ? sd_above[k] : sd[k]));
        }
        return share;
    };
    const auto quantile = [&](double share) {
        const double widest = 10 * std::max(std::ranges::max(sd), std::ranges::max(sd_above));
        const auto lies_above = [&](double x) { return below(x) < share; };  // the distribution is continuous and rises
        return std::clamp(
            halved(std::ranges::min(at.mean) - widest, std::ranges::max(at.mean) + widest, 60, lies_above), least,
            most);
    };
    double mean = 0;
    for (std::size_t k = 0; k < sd.size(); ++k) mean += weights[k] * at.mean[k];
    return {std::clamp(mean, least, most), quantile(0.025), quantile(0.975)};
}

}  // namespace

OverLeft::OverLeft(const Matching& found, const std::vector<EmulatedTarget>& targets) : points_(found.points_left) {
    if (found.left == 0) throw InputError("Nothing can be predicted: nothing is left.");
    weights_ = log_likelihoods(points_, targets);
    const double largest = std::ranges::max(weights_);
    double sum = 0;
    for (double& weight : weights_) sum += weight = std::exp(weight - largest);
    for (double& weight : weights_) weight /= sum;
}

std::string unpredictable(const EmulatedTarget& quantity) {
    const std::string name = quantity.target().name();
    if (!quantity.emulated()) throw InputError(fmt::format("{} cannot be predicted: no wave has it.", name));
    const std::string fault = quantity.mean().fault();
    return fault.empty() ? "" : fmt::format("{} cannot be predicted: {}", name, fault);
}

AtPoints OverLeft::emulated(const EmulatedTarget& quantity) const {
    FLOES_EXPECTS(unpredictable(quantity).empty());
    AtPoints at;
    for (Eigen::Index k = 0; k < points_.rows(); ++k) {
        const Eigen::VectorXd x = points_.row(k).transpose();
        const Emulated there = quantity.mean().at(x);
        at.mean.push_back(there.mean);
        at.variance.push_back(there.variance + quantity.common_variance(x));
    }
    return at;
}

Estimate OverLeft::even(const AtPoints& at, double least, double most) const {
    return range_of(at, std::vector<double>(weights_.size(), 1.0 / static_cast<double>(weights_.size())), least, most);
}

Estimate OverLeft::weighed(const AtPoints& at, double least, double most) const {
    return range_of(at, weights_, least, most);
}

double OverLeft::effective() const {
    double squares = 0;
    for (const double weight : weights_) squares += weight * weight;
    return 1 / squares;
}

Target to_predict(const std::string& quantity, const std::string& case_name) {
    const std::optional<Quantity> known = any_quantity(quantity);
    if (!known)
        throw InputError(fmt::format(
            "--predict {} is no quantity of a member; floes summarize --format json names them.", quantity));
    Target target;
    target.quantity = *known;
    target.case_name = case_name;
    target.value = std::numeric_limits<double>::quiet_NaN();
    target.held_out = true;
    return target;
}

Predicted predict(const OverLeft& left, const EmulatedTarget& quantity) {
    if (std::string unknown = unpredictable(quantity); !unknown.empty())
        return {quantity.target().quantity, quantity.target().case_name, {}, {}, {}, 0, std::move(unknown), {}};
    const AtPoints mean = left.emulated(quantity);
    AtPoints run = mean;
    for (std::size_t k = 0; k < run.variance.size(); ++k)
        run.variance[k] += quantity.scatter(left.points().row(static_cast<Eigen::Index>(k)).transpose());
    const Quantity& about = quantity.target().quantity;
    return {about,
            quantity.target().case_name,
            left.even(mean, about.least, about.most),
            left.weighed(mean, about.least, about.most),
            left.weighed(run, about.least, about.most),
            left.effective(),
            {},
            quantity.simplifications()};
}

Section predicted_section(const std::vector<Predicted>& predicted) {
    Results rows{.place = "match/predicted", .columns = {{"case", "quantity"}, {"quantity"}}};
    for (const auto& [key, words] :
         {std::pair{"mean", "mean of runs"}, std::pair{"weighted", "weighed"}, std::pair{"run", "a single run"}}) {
        rows.columns.push_back(estimates(key, words, ""));
        rows.columns.back().digits = 4;
    }
    rows.columns.push_back({"effective_points"});
    Section section{.title = "Predicted over what is not ruled out"};
    for (const Predicted& one : predicted) {
        if (!one.unknown.empty()) {
            section.notes.push_back(one.unknown);
            continue;
        }
        section.notes.insert(section.notes.end(), one.notes.begin(), one.notes.end());
        rows.add_heading(std::string{one.quantity.label.view()}, Results::For::people, unit_of(one.quantity));
        rows.add({Named{one.case_name, one.case_name.empty() ? "all" : one.case_name},
                  std::string{one.quantity.key.view()}, one.mean, one.weighted, one.run, one.effective});
    }
    if (std::ranges::none_of(predicted, [](const Predicted& one) { return one.unknown.empty(); })) return section;
    section.results = {std::move(rows)};
    section.after =
        "\nIn brackets 95 %. Mean of runs: every combination of inputs that is left counts the same; weighed: by the "
        "likelihood of the targets, normal and independent of each other. A single run adds the scatter.\n";
    return section;
}

namespace {

/// For each point, whether no target rules it out.
std::vector<bool> points_left(const MatchData& data, const std::vector<EmulatedTarget>& targets) {
    std::vector<bool> left;
    for (const MatchPoint& point : data.points)
        left.push_back(std::ranges::none_of(
            targets, [x = coordinates_of(point)](const EmulatedTarget& target) { return target.rules_out(x); }));
    return left;
}

/// Growth of the quantile, of runs in order of their mean maxima.
double growth_of(std::span<const DividedRun> runs, const Measured& measured, const Exposure& exposure) {
    const DividedRows divided = rows_of(runs, measured);
    return over_thresholds(divided.rows, divided.measured, exposure, {exposure.share}).front().front();
}

/// The growth, with its own uncertainty, times the mean maximum at each point.
AtPoints grown(const AtPoints& mean_maximum, const LoadFigure& growth, double factor) {
    constexpr double half_width = 1.96;
    const double sd = (growth.value - growth.interval.low) / half_width;
    const double sd_above = (growth.interval.high - growth.value) / half_width;
    AtPoints made;
    for (std::size_t k = 0; k < mean_maximum.mean.size(); ++k) {
        const double mean = mean_maximum.mean[k];
        const double of_mean = growth.value * growth.value * mean_maximum.variance[k];
        made.mean.push_back(factor * growth.value * mean);
        made.variance.push_back(factor * factor * (of_mean + mean * mean * sd * sd));
        made.variance_above.push_back(factor * factor * (of_mean + mean * mean * sd_above * sd_above));
    }
    return made;
}

PredictedDesignLoad of_case(CaseRuns all, const AtPoints& mean_maximum, const OverLeft& left,
                            const std::string& case_name, const DesignLoadRequest& request) {
    PredictedDesignLoad made;
    made.case_name = case_name;
    const auto at_left = static_cast<std::size_t>(std::ranges::count(all.runs, true, &DividedRun::left));
    made.only_left = at_left >= fewest_growth_runs;
    if (made.only_left) std::erase_if(all.runs, [](const DividedRun& run) { return !run.left; });
    std::ranges::stable_sort(all.runs, {}, &DividedRun::mean_maximum);
    made.runs = all.runs.size();
    const DividedRows divided = rows_of(all.runs, all.measured);
    const Exposure exposure{request.model_exposure(), {request.quantiles.front()}, request.share};
    const DesignLoad load = design_load(divided.rows, divided.measured, exposure);
    if (!load.valid()) {
        made.unknown =
            fmt::format("{}too few peaks ({}; it takes {}) for a design load; run more points or arrangements.",
                        case_name.empty() ? "There are " : case_name + ": ", load.peaks, fewest_peaks);
        return made;
    }
    made.growth_expected = load.estimates.front().expected;
    made.growth_quantile = load.estimates.front().quantiles.front();
    const std::span<const DividedRun> runs = all.runs;
    made.growth_lower_half = growth_of(runs.first(runs.size() / 2), all.measured, exposure);
    made.growth_upper_half = growth_of(runs.subspan(runs.size() / 2), all.measured, exposure);
    const AtPoints expected = grown(mean_maximum, made.growth_expected, request.factor());
    const AtPoints quantile = grown(mean_maximum, made.growth_quantile, request.factor());
    made.expected = left.even(expected, 0);
    made.expected_weighed = left.weighed(expected, 0);
    made.quantile = left.even(quantile, 0);
    made.quantile_weighed = left.weighed(quantile, 0);
    return made;
}

}  // namespace

std::vector<PredictedDesignLoad> predict_design_load(std::span<const MatchWave> waves, const MatchData& data,
                                                     const std::vector<EmulatedTarget>& targets, const OverLeft& left,
                                                     const DesignLoadRequest& request) {
    const double time = averaging_time(waves.front().table, request);
    std::vector<Target> indices;
    for (const std::string& name : match_cases(waves))
        indices.push_back(to_predict(fmt::format("mean_maximum_{:g}s", time), name));
    const std::vector<bool> at_left = points_left(data, targets);
    std::vector<PredictedDesignLoad> designs;
    for (const EmulatedTarget& index : emulate(match_data(waves, indices))) {
        if (!index.emulated()) continue;
        const std::string& name = index.target().case_name;
        if (std::string unknown = unpredictable(index); !unknown.empty()) {
            PredictedDesignLoad& made = designs.emplace_back();
            made.case_name = name;
            made.unknown = std::move(unknown);
            continue;
        }
        const AtPoints mean_maximum = left.emulated(index);
        designs.push_back(of_case(runs_of(waves, data, at_left, index, request), mean_maximum, left, name, request));
        designs.back().notes = index.simplifications();
    }
    return designs;
}

}  // namespace floes
