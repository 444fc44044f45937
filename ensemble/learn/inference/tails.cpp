#include "inference/tails.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace floes {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double lowest_pareto_shape = -0.5;
constexpr double highest_pareto_shape = 1;
constexpr double highest_weibull_shape = 8;
constexpr double lowest_weibull_shape = 0.2;
constexpr double small_shape = 1e-9;
constexpr int bits = 24;  // of a parameter's logarithm; its error by chance is far larger

/// Place of the least cost between `low` and `high`: the best of a grid, then Brent's method round it.
template <class Cost>
double least(Cost cost, double low, double high) {
    constexpr int grid = 24;
    const auto place = [&](int k) { return low + (high - low) * k / grid; };
    int best = 0;
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= grid; ++k) {
        if (const double found = cost(place(k)); found < lowest) {
            lowest = found;
            best = k;
        }
    }
    return boost::math::tools::brent_find_minima(cost, place(std::max(best - 1, 0)), place(std::min(best + 1, grid)),
                                                 bits)
        .first;
}

struct Fitted {
    double scale;
    double shape;
    double cost;  ///< - log likelihood
};

/// Peaks above the threshold.
struct Excesses {
    std::span<const double> values;
    std::span<const double> weights;
    double count = 0;  ///< sum of the weights

    /// Mean of a function of the excess.
    template <class Function>
    double mean(Function function) const {
        double sum = 0;
        for (std::size_t k = 0; k < values.size(); ++k) sum += weights[k] * function(values[k]);
        return sum / count;
    }
};

/// Where a rising function has a value: the end that is nearer, if it lies outside.
template <class Function>
double place_of(double value, Function rising, double low, double high) {
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (rising(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The likeliest scale where the shape is given, and below 0: a largest excess is possible.
Fitted fit_pareto_scale(const Excesses& excesses, double shape, double largest) {
    const auto cost = [&](double log_scale) {
        const double slope = shape / std::exp(log_scale);
        return excesses.count *
               (log_scale + (1 + 1 / shape) * excesses.mean([&](double excess) { return std::log1p(slope * excess); }));
    };
    const double least_scale = std::log(-shape * largest) + small_shape;
    const double best = least(cost, least_scale, least_scale + std::log(100));
    return {std::exp(best), shape, cost(best)};
}

/// Grimshaw's profile (Technometrics 35 (1993) 185-191): given θ = ξ/σ the likeliest ξ is the mean of log(1 + θ e),
/// which rises with θ. The search is over w with θ = (e^w - 1) / largest excess, so w = 0 is the exponential.
Fitted fit_pareto(const Excesses& excesses) {
    const double largest = std::ranges::max(excesses.values);
    const double mean = excesses.mean([](double excess) { return excess; });
    const auto theta_at = [&](double w) { return std::expm1(w) / largest; };
    const auto shape_at = [&](double w) {
        return excesses.mean([theta = theta_at(w)](double excess) { return std::log1p(theta * excess); });
    };
    const auto at = [&](double w) -> Fitted {
        const double shape = shape_at(w);
        if (std::abs(shape) < small_shape) return {mean, 0, excesses.count * (std::log(mean) + 1)};
        const double scale = shape / theta_at(w);
        return {scale, shape, excesses.count * (std::log(scale) + shape + 1)};
    };
    const double low = place_of(lowest_pareto_shape, shape_at, -30, 0);
    const double high = place_of(highest_pareto_shape, shape_at, 0, 30);
    const Fitted found = at(least([&](double w) { return at(w).cost; }, low, high));
    constexpr double near = 1e-6;
    if (found.shape > lowest_pareto_shape + near) return found;
    // On the profile ξ is the likeliest for its θ; at the bound it is not, and the scale is to be found by itself.
    return fit_pareto_scale(excesses, lowest_pareto_shape, largest);
}

/// Given c the likeliest a^c is the mean of (d + e)^c - d^c, where d = u - b.
Fitted fit_weibull(const Excesses& excesses, double above_origin) {
    const double logs = excesses.mean([&](double excess) { return std::log(above_origin + excess); });
    const auto at = [&](double log_shape) -> Fitted {
        const double shape = std::exp(log_shape);
        const double mean = excesses.mean([&](double excess) { return std::pow(above_origin + excess, shape); }) -
                            std::pow(above_origin, shape);
        return {std::pow(mean, 1 / shape), shape,
                excesses.count * (std::log(mean) - log_shape + 1 - (shape - 1) * logs)};
    };
    const double best = least([&](double log_shape) { return at(log_shape).cost; }, std::log(lowest_weibull_shape),
                              std::log(highest_weibull_shape));
    return at(best);
}

}  // namespace

Tail fit_tail(TailKind kind, std::span<const double> excesses, std::span<const double> weights, double threshold,
              double origin, double time) {
    const Excesses peaks{excesses, weights, std::accumulate(weights.begin(), weights.end(), 0.0)};
    Tail tail{.kind = kind,
              .threshold = threshold,
              .rate = peaks.count / time,
              .origin = origin,
              .scale = undefined,
              .shape = undefined,
              .log_likelihood = undefined};
    if (excesses.size() < fewest_peaks || std::ranges::min(excesses) == std::ranges::max(excesses)) return tail;
    const Fitted found = kind == TailKind::pareto ? fit_pareto(peaks) : fit_weibull(peaks, threshold - origin);
    if (!std::isfinite(found.cost)) return tail;
    tail.scale = found.scale;
    tail.shape = found.shape;
    tail.log_likelihood = -found.cost;
    return tail;
}

double rate_above(const Tail& tail, double x) {
    const double excess = x - tail.threshold;
    if (excess <= 0) return tail.rate;
    if (tail.kind == TailKind::weibull)
        return tail.rate * std::exp(std::pow((tail.threshold - tail.origin) / tail.scale, tail.shape) -
                                    std::pow((x - tail.origin) / tail.scale, tail.shape));
    if (std::abs(tail.shape) < small_shape) return tail.rate * std::exp(-excess / tail.scale);
    return tail.rate * std::pow(std::max(0.0, 1 + tail.shape * excess / tail.scale), -1 / tail.shape);
}

double level_at(const Tail& tail, double rate) {
    const double rarer = std::log(tail.rate / rate);
    if (rarer <= 0) return tail.threshold;
    if (tail.kind == TailKind::weibull)
        return tail.origin +
               tail.scale *
                   std::pow(std::pow((tail.threshold - tail.origin) / tail.scale, tail.shape) + rarer, 1 / tail.shape);
    if (std::abs(tail.shape) < small_shape) return tail.threshold + tail.scale * rarer;
    return tail.threshold + tail.scale / tail.shape * std::expm1(tail.shape * rarer);
}

double quantile_of_largest(const Tail& tail, double exposure, double p) {
    return level_at(tail, -std::log(p) / exposure);
}

// The integral of the quantile over p, with p = exp(-e^t): the trapezoid rule is exact to many digits for it.
double expected_largest(const Tail& tail, double exposure) {
    constexpr double step = 0.125;
    constexpr double first = -34;  // the largest is beyond with probability e^first
    constexpr int count = 304;     // to t = 4, where p is e^-54
    double sum = 0;
    for (int k = 0; k < count; ++k) {
        const double t = first + step * k;
        const double y = std::exp(t);
        sum += level_at(tail, y / exposure) * y * std::exp(-y) * step;
    }
    return sum;
}

}  // namespace floes
