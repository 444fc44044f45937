#pragma once
// Statistics of a load in the analysis window: its level, trend and spread, and whether it was steady.

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace floes {

// Means of values, of all of them and of successive batches, and their spread.

/// Sum over count, added in order; NaN of none.
double mean_of(std::span<const double> values);

/// Sum of squared differences from `mean`, added in order.
double squares_about(std::span<const double> values, double mean);

/// Root of the mean square difference from `mean`; NaN if there is none.
double population_sd(std::span<const double> values, double mean);

/// Index at which part `index` of `parts` equal parts of `count` values begins; they differ by one value where `parts`
/// does not divide `count`.
std::size_t part_begin(std::size_t count, std::size_t index, std::size_t parts);

/// Largest value of each of `parts` equal parts of the values, of which each part has at least one.
std::vector<double> part_maxima(std::span<const double> values, std::size_t parts);

/// Value k is the mean of values[k * batch] … values[(k + 1) * batch - 1]; an incomplete batch at the end is dropped.
/// `batch` at least 1.
std::vector<double> batch_means(std::span<const double> values, std::size_t batch);

/// Mean of each of `parts` equal parts of the values, of which there is at least one. A value across an edge counts on
/// both sides by its share there, so the mean of the parts is the mean of all.
std::vector<double> part_means(std::span<const double> values, std::size_t parts);

// A value that goes up and down, as single numbers: an offset, a mooring force, a moment.

/// In the unit of the values. Not measured: NaN.
struct Swing {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();       ///< population standard deviation
    double largest = std::numeric_limits<double>::quiet_NaN();  ///< amount, at either side
};

/// `values`: at the ends of steps, at least one.
Swing swing_of(std::span<const double> values);

// One row of Table 3 from the load in the analysis window, and whether that load was steady.
//
// Trend: slope of least squares over all samples. Its p comes from batch means, because successive loads are
// correlated, and tested sample by sample any slow wave looks like a trend: the window is cut into 15 equal batches (10
// s of the paper's 150 s; half as many as samples if those are fewer than 30), a line is fitted to their means, and
// slope / standard error is compared with Student's t with (batches - 2) degrees of freedom. Fewer than 3 batches: p =
// 1.

struct LoadStatistics {
    double mean = 0;                      ///< N
    double sd = 0;                        ///< population standard deviation over the window, N
    double maximum = 0;                   ///< N
    std::vector<double> segment_maximum;  ///< maximum of each equal part of the window, N
    double mean_maximum = 0;              ///< mean of the segment maxima, N
    double sd_maximum = 0;                ///< population SD of the segment maxima, N
    double trend = 0;                     ///< slope of the load over the window, N/s
    double trend_p = 1;                   ///< two-sided p of slope = 0, from batch means (the load is autocorrelated)
    bool steady = true;                   ///< trend_p >= 0.05
    double skewness = 0;                  ///< third central moment over SD³, over the window; NaN for a constant load
    double excess_kurtosis = 0;           ///< fourth central moment over SD⁴, less the 3 of a normal load; likewise
};

/// `window`: load at every step of the analysis window, N, at least 2 samples for each segment, all finite.
LoadStatistics load_statistics(std::span<const double> window, double time_step, int segments);

// How long and how often a load exceeds given levels: a summary for members whose load history is not kept.

struct LevelCount {
    int steps_above = 0;  ///< steps with a load above the level
    int upcrossings = 0;  ///< steps above it whose predecessor in the window is not: the load rises through the level
    friend bool operator==(const LevelCount&, const LevelCount&) = default;
};

/// One count for each of `levels`, in their order and unit, by one pass over the load of every step of the window.
std::vector<LevelCount> count_levels(std::span<const double> window, std::span<const double> levels);

// When a load became steady, and its number of independent samples.

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
