#pragma once
// One row of Table 3 from the load in the analysis window, and whether that load was steady.
//
// Trend: slope of least squares over all samples. Its p comes from batch means, because successive loads are
// correlated, and tested sample by sample any slow wave looks like a trend: the window is cut into 15 equal batches (10
// s of the paper's 150 s; half as many as samples if those are fewer than 30), a line is fitted to their means, and
// slope / standard error is compared with Student's t with (batches - 2) degrees of freedom. Fewer than 3 batches: p =
// 1.

#include <span>
#include <vector>

namespace floes {

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

}  // namespace floes
