#pragma once
// How sure a fit of maxima is. Segments of one member are not independent, so arrangements are resampled, each with all
// its segments, and the distribution is fitted again.

#include <span>
#include <vector>

#include "inference/extremes.hpp"

namespace floes {

struct ReturnLevel {
    double segments = 0;  ///< one segment in so many exceeds it on average
    double level = 0;     ///< unit of the maxima
    Limits interval{};    ///< 95 %, percentile bootstrap over arrangements
};

/// A fit with its 95 % intervals.
struct FittedExtreme {
    ExtremeKind kind = ExtremeKind::gumbel;
    ExtremeFit fit;
    Limits location{};
    Limits scale{};
    Limits shape{};  ///< of a Gumbel [0, 0]
    GoodnessOfFit goodness{};
    std::vector<ReturnLevel> levels;
};

/// Fits the maxima of all arrangements together. `maxima`: of each arrangement the maxima of its segments; `segments`:
/// for which return levels are wanted, each above 1. Everything is NaN where there are too few to fit.
FittedExtreme fit_extremes(std::span<const std::vector<double>> maxima, ExtremeKind kind,
                           std::span<const double> segments);

}  // namespace floes
