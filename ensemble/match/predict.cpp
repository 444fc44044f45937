#include "match/predict.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "tables/number_text.hpp"

namespace floes {
namespace {

/// Normal distributions, each with a weight.
struct Mixture {
    std::vector<double> mean;
    std::vector<double> sd;
    std::vector<double> weight;  ///< sum 1

    double below(double x) const {
        const boost::math::normal standard;
        double share = 0;
        for (std::size_t k = 0; k < mean.size(); ++k)
            share += weight[k] * boost::math::cdf(standard, (x - mean[k]) / sd[k]);
        return share;
    }

    /// By halving: the distribution is continuous and rises.
    double quantile(double share) const {
        const double widest = 10 * *std::ranges::max_element(sd);
        double low = *std::ranges::min_element(mean) - widest;
        double high = *std::ranges::max_element(mean) + widest;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (below(middle) < share ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    PredictedRange range(const Quantity& quantity) const {
        double sum = 0;
        for (std::size_t k = 0; k < mean.size(); ++k) sum += weight[k] * mean[k];
        const auto possible = [&](double value) { return std::clamp(value, quantity.least, quantity.most); };
        return {sum, possible(quantile(0.025)), possible(quantile(0.975))};
    }
};

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

}  // namespace

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

Predicted predict(const Matching& found, const std::vector<EmulatedTarget>& targets, const EmulatedTarget& quantity) {
    const std::string name = quantity.target().name();
    if (!quantity.emulated()) throw InputError(fmt::format("{} cannot be predicted: no wave has it.", name));
    if (const std::string fault = quantity.mean().fault(); !fault.empty())
        throw InputError(fmt::format("{} cannot be predicted: {}", name, fault));
    if (found.left == 0) throw InputError("Nothing can be predicted: nothing is left.");
    std::vector<double> weights = log_likelihoods(found.points_left, targets);
    const double largest = std::ranges::max(weights);
    double sum = 0;
    for (double& weight : weights) {
        weight = std::exp(weight - largest);
        sum += weight;
    }
    double squares = 0;
    for (double& weight : weights) {
        weight /= sum;
        squares += weight * weight;
    }
    Mixture mean;
    Mixture run;
    for (Eigen::Index k = 0; k < found.points_left.rows(); ++k) {
        const Eigen::VectorXd x = found.points_left.row(k).transpose();
        const Emulated there = quantity.mean().at(x);
        const double variance = there.variance + quantity.common_variance(x);
        mean.mean.push_back(there.mean);
        mean.sd.push_back(std::sqrt(std::max(variance, 1e-300)));
        run.sd.push_back(std::sqrt(std::max(variance + quantity.scatter(x), 1e-300)));
    }
    run.mean = mean.mean;
    run.weight = weights;
    Mixture even = mean;
    even.weight.assign(weights.size(), 1.0 / static_cast<double>(weights.size()));
    mean.weight = std::move(weights);
    const Quantity& about = quantity.target().quantity;
    return {about, quantity.target().case_name, even.range(about), mean.range(about), run.range(about), 1.0 / squares};
}

Section predicted_section(const std::vector<Predicted>& predicted) {
    Section section{.before = "Predicted over what is not ruled out\n\n"};
    section.table = {{"quantity", "mean of runs", "weighed", "a single run"}};
    for (const Predicted& one : predicted) {
        const auto cell = [&](const PredictedRange& range) {
            const double factor = one.quantity.factor();
            return Cell{fmt::format("{:.4g}", factor * range.mean),
                        fmt::format("[{:.4g}, {:.4g}]", factor * range.low, factor * range.high)};
        };
        section.table.push_back(
            {fmt::format("{}{}{}", one.case_name, one.case_name.empty() ? "" : " ", one.quantity.label), cell(one.mean),
             cell(one.weighted), cell(one.run)});
    }
    section.after =
        "\nIn brackets 95 %. Mean of runs: every combination of inputs that is left counts the same; weighed: by the\n"
        "likelihood of the targets, normal and independent of each other. A single run adds the scatter.\n";
    const auto of = [](PredictedRange Predicted::*range, double PredictedRange::*field) {
        return [range, field](const Predicted& one) { return one.*range.*field; };
    };
    section.records = {make_records<Predicted>(
        "match/predicted", predicted,
        {{"quantity", [](const Predicted& one) { return std::string(one.quantity.key.view()); }},
         {"case", &Predicted::case_name},
         {"mean", of(&Predicted::mean, &PredictedRange::mean)},
         {"mean_low", of(&Predicted::mean, &PredictedRange::low)},
         {"mean_high", of(&Predicted::mean, &PredictedRange::high)},
         {"weighted", of(&Predicted::weighted, &PredictedRange::mean)},
         {"weighted_low", of(&Predicted::weighted, &PredictedRange::low)},
         {"weighted_high", of(&Predicted::weighted, &PredictedRange::high)},
         {"run_low", of(&Predicted::run, &PredictedRange::low)},
         {"run_high", of(&Predicted::run, &PredictedRange::high)},
         {"effective_points", &Predicted::effective}})};
    return section;
}

}  // namespace floes
