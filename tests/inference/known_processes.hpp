#pragma once
// Loads whose largest value in any exposure is known, for checking design loads: windows of them, and the rate at which
// they exceed a level.

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace floes::known {

inline constexpr double step = 0.1;      // s
inline constexpr double window = 150;    // s
inline constexpr double segment = 50;    // s
inline constexpr double separation = 5;  // s

struct Process {
    std::string name;
    std::function<std::vector<double>(RandomStream&)> load;  ///< a window of it
    std::function<double(double)> rate;                      ///< λ(x), per s, for high x
    double from;                                             ///< N, where the rate is high
    double to;                                               ///< N, where it is very low
};

/// Of each list.
inline std::vector<std::span<const double>> spans(const std::vector<std::vector<double>>& lists) {
    return {lists.begin(), lists.end()};
}

inline double exponential(RandomStream& random) {
    return -std::log(random.uniform(1e-300, 1));
}

/// Standard normal, by Box and Muller.
inline double normal(RandomStream& random) {
    return std::sqrt(2 * exponential(random)) * std::cos(2 * M_PI * random.uniform(0, 1));
}

inline std::size_t samples(double time) {
    return static_cast<std::size_t>(std::lround(time / step));
}

/// Two relaxations of 1 s each behind white noise: mean 30, SD 10. Rice's rate for samples: the probability that one is
/// below the level and the next one above it.
inline Process gaussian() {
    const double a = std::exp(-step);
    const double sd = std::sqrt((1 + a * a) / std::pow(1 - a * a, 3));
    const double correlation = 2 * a / (1 + a * a);
    const auto load = [=](RandomStream& random) {
        std::vector<double> values;
        double now = 0, before = 0;
        for (std::size_t k = 0; k < samples(window + 30); ++k) {
            const double next = 2 * a * now - a * a * before + normal(random);
            before = now;
            now = next;
            if (k >= samples(30)) values.push_back(30 + 10 * now / sd);
        }
        return values;
    };
    const auto rate = [=](double x) {
        const double z = (x - 30) / 10;
        double sum = 0;
        for (double y = z - 9; y < z; y += 1e-3)
            sum += 1e-3 * std::exp(-y * y / 2) / std::sqrt(2 * M_PI) * 0.5 *
                   std::erfc(-(correlation * y - z) / std::sqrt(2 * (1 - correlation * correlation)));
        return sum / step;
    };
    return {"Gaussian", load, rate, 45, 120};
}

/// Pulses that come at `often` per s, each `size(random)` high on top of what is there, which fades within `fade` s.
inline std::vector<double> pulses(RandomStream& random, double often, double fade,
                                  const std::function<double(RandomStream&)>& size) {
    std::vector<double> values;
    double now = 0;
    for (std::size_t k = 0; k < samples(window + 20); ++k) {
        now *= std::exp(-step / fade);
        if (random.uniform(0, 1) < often * step) now += size(random);
        if (k >= samples(20)) values.push_back(now);
    }
    return values;
}

/// Exponential pulses: the load between them is gamma distributed, so the rate is known in closed form. They fade fast,
/// so that hardly one stands on another: where they do, up-crossings come in clusters, and the largest load is not what
/// their rate says.
inline Process filtered_poisson() {
    const double often = 0.15, fade = 0.1, k = often * fade;
    return {"filtered Poisson, exponential pulses",
            [=](RandomStream& random) {
                std::vector<double> load =
                    pulses(random, often, fade, [](RandomStream& r) { return 20 * exponential(r); });
                for (double& value : load) value += 5;
                return load;
            },
            [=](double x) {
                const double z = (x - 5) / 20;
                return often * std::exp(-z) * std::pow(z, k) / std::tgamma(k + 1);
            },
            30, 2000};
}

/// The same behind a limit that loads only approach: 50 (1 - e^(-x/50)).
inline Process limited() {
    const Process free = filtered_poisson();
    return {"filtered Poisson, below a limit",
            [=](RandomStream& random) {
                std::vector<double> load = free.load(random);
                for (double& value : load) value = 50 * -std::expm1(-value / 50);
                return load;
            },
            [=](double x) { return free.rate(-50 * std::log1p(-x / 50)); }, 25, 49.9999999};
}

/// Pulses with a Pareto tail of shape 0.2 that fade before the next one comes.
inline Process heavy() {
    return {"filtered Poisson, heavy tail",
            [](RandomStream& random) {
                std::vector<double> load = pulses(
                    random, 0.15, 0.1, [](RandomStream& r) { return 20 * std::expm1(0.2 * exponential(r)) / 0.2; });
                for (double& value : load) value += 5;
                return load;
            },
            [](double x) { return 0.15 * std::pow(1 + 0.2 * (x - 5) / 20, -5); }, 30, 20000};
}

/// Bursts: within 3 s, each brings several peaks below its own highest, which is exponential.
inline Process clustered() {
    return {"clusters of peaks",
            [](RandomStream& random) {
                std::vector<double> load(samples(window), 10);
                double at = -3;
                while ((at += exponential(random) / 0.05) < window) {
                    const double highest = 20 * exponential(random);
                    const int peaks = 2 + static_cast<int>(random.below(6));
                    for (int k = 0; k < peaks; ++k) {
                        const double time = at + (k == 0 ? 1.5 : random.uniform(0, 3));
                        if (time < 0 || samples(time) >= load.size()) continue;
                        double& value = load[samples(time)];
                        value = std::max(value, 10 + highest * (k == 0 ? 1 : random.uniform(0.3, 0.95)));
                    }
                }
                return load;
            },
            [](double x) { return 0.05 * std::exp(-(x - 10) / 20); }, 30, 2000};
}

inline std::vector<Process> all() {
    return {gaussian(), filtered_poisson(), limited(), heavy(), clustered()};
}

/// The level that the load stays below with probability p in `exposure`, s: by bisection of the rate.
inline double largest(const Process& process, double exposure, double p) {
    double low = process.from, high = process.to;
    for (int k = 0; k < 200; ++k) {
        const double middle = (low + high) / 2;
        (process.rate(middle) > -std::log(p) / exposure ? low : high) = middle;
    }
    return low;
}

}  // namespace floes::known
