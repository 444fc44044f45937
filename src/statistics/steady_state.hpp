#pragma once
// When a load became steady, and its number of independent samples.

#include <cstddef>
#include <optional>
#include <span>

namespace floes {

/// Largest number of equal batches for finding the steady part.
inline constexpr std::size_t steady_batches = 50;

/// First sample of the steady part, by MSER on batch means: the initial batches to discard, at most half, are those
/// that minimise the standard error of the mean of the rest, squares / count². Empty if discarding the full half is
/// best, which means that no steady part was found, and for fewer than 4 samples. `load` finite. K. P. White, M. J.
/// Cobb and S. C. Spratt, "A comparison of five steady-state truncation heuristics for simulation", Proc. Winter
/// Simulation Conf. 2000, 755-760. Their batches of 5 samples suit samples that are nearly independent. Loads come in
/// bursts of many steps: a quiet beginning would lower the scatter and be kept, so the batches are as long as possible.
std::optional<std::size_t> steady_start(std::span<const double> load);

/// Samples in each mean that autocorrelation() uses; fewer are enough if the load consists of means over steps.
inline constexpr std::size_t correlation_batch = 5;

struct Autocorrelation {
    double time = 0;               ///< s of load that count as one independent value; NaN for a constant load
    double effective_samples = 0;  ///< length of the load / time
};

/// From the means of `batch` successive samples: the variance of the overall mean is σ² τ / n with τ = 1 + 2 Σ ρ(lag),
/// summed up to the first lag that is at least 5 τ (A. D. Sokal, "Monte Carlo methods in statistical mechanics", in
/// Functional Integration, Plenum 1997, 131-192); n over the effective samples is that variance over the variance of
/// single samples. `load`: finite, at least 4 batches, otherwise NaN; `step`: time between samples, s. `variance`: that
/// of the load itself if `load` consists of means of it, whose scatter is smaller.
Autocorrelation autocorrelation(std::span<const double> load, double step, std::size_t batch = correlation_batch,
                                std::optional<double> variance = {});

}  // namespace floes
