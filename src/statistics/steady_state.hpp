#pragma once
// When a load became steady, and how much of it is independent.

#include <cstddef>
#include <optional>
#include <span>

namespace floes {

/// First sample of the steady part, by MSER-5: of the means of 5 successive samples those of the beginning are left out
/// whose loss makes the standard error of the mean of the others, squares / count², smallest; at most half of them.
/// None when the best is to leave out that half, which means that no steady part is to be seen, and for fewer than 20
/// samples. `load` finite. K. P. White, M. J. Cobb and S. C. Spratt, "A comparison of five steady-state truncation
/// heuristics for simulation", Proc. Winter Simulation Conf. 2000, 755-760.
std::optional<std::size_t> steady_start(std::span<const double> load);

struct Autocorrelation {
    double time = 0;               ///< s of load that count as one independent value; NaN for a load that never changes
    double effective_samples = 0;  ///< length of the load / time
};

/// From the means of 5 successive samples: the variance of the overall mean is σ² τ / n with τ = 1 + 2 Σ ρ(lag), summed
/// up to the first lag that is at least 5 τ (A. D. Sokal, "Monte Carlo methods in statistical mechanics", in Functional
/// Integration, Plenum 1997, 131-192); n over the effective samples is that variance over the variance of single
/// samples. `load` finite, at least 20 samples, else NaN.
Autocorrelation autocorrelation(std::span<const double> load, double time_step);

}  // namespace floes
