#pragma once
// Members of known distributions, for trials of how often intervals hold. What is tuned (the share of the draws between
// the limits of both tails, posterior_load.cpp) is tuned with `tuning()`; tests and tables are of `verification()`.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "inference/known_processes.hpp"
#include "statistics/distributions.hpp"

namespace floes::known {

/// Loads of s (10 + 20 w), in N, w of a distribution, s the member's scale: one that stands for the mean load of each
/// member, and peaks in windows of 150 s, where s rises.
struct Set {
    std::string name;
    std::function<double(double)> hazard;  ///< -log of the probability that w is larger
    double scatter = 0;                    ///< SD of the logarithm of a member's scale
    double share = 0;                      ///< of members of another kind
    double times = 1;                      ///< their load
    double rise = 0;                       ///< of the scale through the window, of its mean
    double often = 20;                     ///< peaks a window, on average

    double w(double hazard_above) const {
        double low = -20, high = 1;
        while (hazard(high) < hazard_above && high < 1e9) high *= 2;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (hazard(middle) < hazard_above ? low : high) = middle;
        }
        return (low + high) / 2;
    }
    /// Mean over a member's scale, of both kinds, of `value(scale)`.
    template <class Value>
    double over_scales(const Value& value) const {
        double sum = 0, all = 0;
        for (double z = -5; z <= 5; z += 0.05) {
            const double weight = std::exp(-z * z / 2), own = std::exp(scatter * z);
            sum += weight * ((1 - share) * value(own) + share * value(times * own));
            all += weight;
        }
        return sum / all;
    }
    double mean_load() const {
        double mean = 0;
        for (double at = -15; at < 1000; at += at < 20 ? 0.01 : 1) {
            const double step = at < 20 ? 0.01 : 1, larger = std::exp(-hazard(at + step / 2));
            mean += step * (at < 0 ? larger - 1 : larger);
        }
        return (10 + 20 * mean) * over_scales([](double s) { return s; });
    }
    /// Expected peaks above x in a window of a member of this scale.
    double above(double x, double scale) const {
        constexpr int parts = 8;
        double sum = 0;
        for (int k = 0; k < parts; ++k)
            sum += std::exp(-hazard((x / (scale * (1 + rise * ((k + 0.5) / parts - 0.5))) - 10) / 20)) / parts;
        return often * sum;
    }
    /// The load that the largest in `members` windows, each of its own member, exceeds with probability 1 - p.
    double largest(double members, double p) const {
        double low = 1, high = 1e7;
        for (int k = 0; k < 70; ++k) {
            const double middle = std::sqrt(low * high);
            const double below = 1 - over_scales([&](double s) { return -std::expm1(-above(middle, s)); });
            (members * std::log(below) < std::log(p) ? low : high) = middle;
        }
        return low;
    }
};

struct SetMembers {
    std::vector<std::vector<double>> peaks;  ///< of each, falling
    std::vector<double> loads;               ///< mean load of each
    double least = 0;                        ///< mean of the least peaks: the origin of the Weibull tail
    bool other = false;                      ///< whether one is of another kind
};

inline SetMembers draw(const Set& set, std::size_t count, RandomStream& random, bool with_peaks = true) {
    SetMembers made;
    for (std::size_t row = 0; row < count; ++row) {
        const bool other = random.uniform() < set.share;
        const double scale = std::exp(set.scatter * normal(random)) * (other ? set.times : 1);
        made.other = made.other || other;
        made.least += 10 * scale / static_cast<double>(count);
        made.loads.push_back(scale * (10 + 20 * set.w(exponential(random))));
        if (!with_peaks) continue;
        std::vector<double>& peaks = made.peaks.emplace_back();
        for (double at = exponential(random); at < set.often; at += exponential(random))
            peaks.push_back(scale * (1 + set.rise * (at / set.often - 0.5)) * (10 + 20 * set.w(exponential(random))));
        std::ranges::sort(peaks, std::ranges::greater{});
    }
    return made;
}

/// A hazard from the probability that w is larger.
inline std::function<double(double)> hazard_of(std::function<double(double)> larger) {
    return [=](double w) { return w <= -15 ? 0.0 : -std::log(std::max(larger(w), 1e-300)); };
}

inline std::function<double(double)> weibull_hazard(double shape) {
    return [=](double w) { return w <= 0 ? 0.0 : std::pow(w, shape); };
}

inline std::function<double(double)> pareto_hazard(double shape) {
    return [=](double w) { return w <= 0 ? 0.0 : 1 + shape * w > 0 ? std::log1p(shape * w) / shape : 1e300; };
}

inline std::vector<Set> tuning() {
    std::vector<Set> sets;
    for (const double shape : {1.0, 1.5, 2.0}) sets.push_back({"Weibull", weibull_hazard(shape)});
    for (const double shape : {-0.4, -0.2, 0.15, 0.3}) sets.push_back({"Pareto", pareto_hazard(shape)});
    sets.push_back({.name = "scales of 15 %", .hazard = weibull_hazard(1.5), .scatter = 0.15});
    sets.push_back({.name = "scales of 30 %", .hazard = weibull_hazard(1.5), .scatter = 0.3});
    sets.push_back({.name = "exponential, scales of 20 %", .hazard = weibull_hazard(1), .scatter = 0.2});
    sets.push_back({.name = "5 % at 5 times", .hazard = weibull_hazard(1.5), .share = 0.05, .times = 5});
    sets.push_back({.name = "few peaks", .hazard = weibull_hazard(1.5), .often = 8});
    return sets;
}

inline std::vector<Set> verification() {
    const auto gumbel = hazard_of([](double w) { return -std::expm1(-std::exp(-(w - 0.5) / 0.4)); });
    return {{"log-normal, SD of the logarithm 0.5",
             hazard_of([](double w) { return w <= 0 ? 1.0 : normal_below(-std::log(w / 0.8) / 0.5); })},
            {"gamma, shape 2", [](double w) { return w <= 0 ? 0.0 : 2 * w - std::log1p(2 * w); }},
            {"Gumbel", gumbel},
            {"heavy: Burr, ξ 0.2", [](double w) { return w <= 0 ? 0.0 : 2.5 * std::log1p(w * w); }},
            {.name = "Gumbel, SD of members' scales 0.25", .hazard = gumbel, .scatter = 0.25},
            {.name = "Gumbel, 8 % of members at 4 times the load", .hazard = gumbel, .share = 0.08, .times = 4},
            {.name = "gamma, rising by 8 % through the window",
             .hazard = [](double w) { return w <= 0 ? 0.0 : 2 * w - std::log1p(2 * w); },
             .rise = 0.08}};
}

}  // namespace floes::known
