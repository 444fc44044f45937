#include "match/predict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "findings/estimates.hpp"
#include "match/matching.hpp"
#include "statistics/distributions.hpp"

namespace floes {

namespace {

/// Logarithms of the weights, up to a constant.
std::vector<double> log_likelihoods(const Eigen::MatrixXd& points, const std::vector<EmulatedTarget>& targets) {
    std::vector<double> logs(static_cast<std::size_t>(points.rows()), 0.0);
    for (const EmulatedTarget& target : targets) {
        if (!target.unused().empty()) continue;
        for (std::size_t k = 0; k < logs.size(); ++k) {
            const Eigen::VectorXd x = points.row(static_cast<Eigen::Index>(k)).transpose();
            const double off = target.implausibility(x);
            logs[k] -= off * off / 2 + std::log(target.expected_difference(x));
        }
    }
    return logs;
}

/// For the mixture of normal distributions.
PredictedRange range_of(const AtPoints& at, const std::vector<double>& weights, double least, double most) {
    std::vector<double> sd;
    for (const double variance : at.variance) sd.push_back(std::sqrt(std::max(variance, 1e-300)));
    const auto below = [&](double x) {
        double share = 0;
        for (std::size_t k = 0; k < sd.size(); ++k) share += weights[k] * normal_below((x - at.mean[k]) / sd[k]);
        return share;
    };
    // By halving: the distribution is continuous and rises.
    const auto quantile = [&](double share) {
        const double widest = 10 * *std::ranges::max_element(sd);
        double low = *std::ranges::min_element(at.mean) - widest;
        double high = *std::ranges::max_element(at.mean) + widest;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (below(middle) < share ? low : high) = middle;
        }
        return std::clamp((low + high) / 2, least, most);
    };
    double mean = 0;
    for (std::size_t k = 0; k < sd.size(); ++k) mean += weights[k] * at.mean[k];
    return {mean, quantile(0.025), quantile(0.975)};
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

PredictedRange OverLeft::even(const AtPoints& at, double least, double most) const {
    return range_of(at, std::vector<double>(weights_.size(), 1.0 / static_cast<double>(weights_.size())), least, most);
}

PredictedRange OverLeft::weighed(const AtPoints& at, double least, double most) const {
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
        return {quantity.target().quantity, quantity.target().case_name, {}, {}, {}, 0, std::move(unknown)};
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
            {}};
}

Estimate estimate(const PredictedRange& range) {
    return {range.mean, range.low, range.high};
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
        rows.add_heading(std::string{one.quantity.label.view()}, Results::For::people, unit_of(one.quantity));
        rows.add({Named{one.case_name, one.case_name.empty() ? "all" : one.case_name},
                  std::string{one.quantity.key.view()}, estimate(one.mean), estimate(one.weighted), estimate(one.run),
                  one.effective});
    }
    if (section.notes.size() == predicted.size()) return section;
    section.results = {std::move(rows)};
    section.after =
        "\nIn brackets 95 %. Mean of runs: every combination of inputs that is left counts the same; weighed: "
        "by the likelihood of the targets, normal and independent of each other. A single run adds the "
        "scatter.\n";
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
double growth_of(std::span<const DividedRun> runs, Measured measured, const Exposure& exposure) {
    const DividedRows divided = rows_of(runs);
    measured.mean = divided.mean;
    return over_thresholds(divided.rows, measured, exposure, {exposure.share}).front().front();
}

/// The growth, with its own uncertainty, times the mean maximum at each point.
AtPoints grown(const AtPoints& mean_maximum, const DesignLoadFigure& growth, double factor) {
    constexpr double half_width = 1.96;
    const double sd = (growth.interval.high - growth.interval.low) / (2 * half_width);
    AtPoints made;
    for (std::size_t k = 0; k < mean_maximum.mean.size(); ++k) {
        const double mean = mean_maximum.mean[k];
        const double variance = growth.value * growth.value * mean_maximum.variance[k] + mean * mean * sd * sd;
        made.mean.push_back(factor * growth.value * mean);
        made.variance.push_back(factor * factor * variance);
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
    const DividedRows divided = rows_of(all.runs);
    all.measured.mean = divided.mean;
    const Exposure exposure{request.model_exposure(), {request.quantiles.front()}, request.share};
    const DesignLoad load = design_load(divided.rows, all.measured, exposure);
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
    made.expected = left.even(expected);
    made.expected_weighed = left.weighed(expected);
    made.quantile = left.even(quantile);
    made.quantile_weighed = left.weighed(quantile);
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
    }
    return designs;
}

}  // namespace floes
