#pragma once
// When a load became steady, and how much of it is independent.

#include <cstddef>
#include <optional>
#include <span>

namespace floes {

/// Equal batches, at most, that a load is cut into to see where it becomes steady.
inline constexpr std::size_t steady_batches = 50;

/// First sample of the steady part, by MSER on batch means: those of the beginning are left out whose loss makes the
/// standard error of the mean of the others, squares / count², smallest; at most half of them. None when the best is to
/// leave out that half, which means that no steady part is to be seen, and for fewer than 4 samples. `load` finite.
/// K. P. White, M. J. Cobb and S. C. Spratt, "A comparison of five steady-state truncation heuristics for simulation",
/// Proc. Winter Simulation Conf. 2000, 755-760. Their batches of 5 samples suit samples that hardly depend on each
/// other. Loads come in bursts of many steps: there a quiet beginning lowers the scatter and would be kept, so the
/// batches are as long as they can be.
std::optional<std::size_t> steady_start(std::span<const double> load);

/// Samples whose means autocorrelation() looks at; of a load that is of means over some steps itself, fewer do.
inline constexpr std::size_t correlation_batch = 5;

struct Autocorrelation {
    double time = 0;               ///< s of load that count as one independent value; NaN for a load that never changes
    double effective_samples = 0;  ///< length of the load / time
};

/// From the means of `batch` successive samples: the variance of the overall mean is σ² τ / n with τ = 1 + 2 Σ ρ(lag),
/// summed up to the first lag that is at least 5 τ (A. D. Sokal, "Monte Carlo methods in statistical mechanics", in
/// Functional Integration, Plenum 1997, 131-192); n over the effective samples is that variance over the variance of
/// single samples. `load` finite, at least 4 batches, else NaN; `step`: s from each to the next. `variance`: of the
/// load itself, where `load` is of means of it, whose own spread is smaller.
Autocorrelation autocorrelation(std::span<const double> load, double step, std::size_t batch = correlation_batch,
                                std::optional<double> variance = {});

}  // namespace floes
