#pragma once
// Means and scatter over arrangements at the points of a design. For this room only.

#include <span>
#include <vector>

namespace floes {

/// The runs at one point. Runs of two points of one wave with equal arrangements began from the same floes.
struct PointRuns {
    int wave = 0;
    std::vector<int> arrangements;
    std::vector<double> values;  ///< one an arrangement, at least one
};

/// The lists have an element for each point.
struct Scatter {
    std::vector<double> mean;
    std::vector<double> sample_variance;  ///< n - 1; NaN for one run
    std::vector<double> variance;         ///< weighted with the pooled one
    double pooled;                        ///< variance of single runs over all points; NaN where each has one run
    double shared;                        ///< part of it that is common to the points of an arrangement, 0-1
};

/// As match_data() says, with `pooled_runs` as the weight of the pooled variance.
Scatter scatter_of(std::span<const PointRuns> points, double pooled_runs);

}  // namespace floes
