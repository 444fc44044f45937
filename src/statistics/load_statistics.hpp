#pragma once
// Means of values, of all of them and of successive batches, and their spread.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace floes {

/// Sum over count, added in order; NaN of none.
double mean_of(std::span<const double> values);

/// Root of the mean square difference from `mean`; NaN if there is none.
double population_sd(std::span<const double> values, double mean);

/// Index at which part `index` of `parts` equal parts of `count` values begins; they differ by one value where `parts`
/// does not divide `count`.
std::size_t part_begin(std::size_t count, std::size_t index, std::size_t parts);

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

}  // namespace floes
