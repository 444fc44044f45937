#include "match/over_left.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
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

/// Of the mixture of normal distributions.
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

AtPoints OverLeft::emulated(const EmulatedTarget& quantity) const {
    const std::string name = quantity.target().name();
    if (!quantity.emulated()) throw InputError(fmt::format("{} cannot be predicted: no wave has it.", name));
    if (const std::string fault = quantity.mean().fault(); !fault.empty())
        throw InputError(fmt::format("{} cannot be predicted: {}", name, fault));
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

}  // namespace floes
