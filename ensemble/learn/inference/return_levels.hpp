#pragma once
// Uncertainty of a fit of maxima. Segments of one member are not independent, so arrangements are resampled, each with
// all its segments, and the distribution is refitted.

#include <span>
#include <vector>

#include "inference/extremes.hpp"

namespace floes {

struct ReturnLevel {
    double segments = 0;  ///< on average one segment in this many exceeds the level
    double level = 0;     ///< unit of the maxima
    Limits interval{};    ///< 95 %, percentile bootstrap over arrangements
};

/// A fit with its 95 % intervals.
struct FittedExtreme {
    ExtremeKind kind = ExtremeKind::gumbel;
    ExtremeFit fit;
    Limits location{};
    Limits scale{};
    Limits shape{};  ///< [0, 0] for Gumbel
    GoodnessOfFit goodness{};
    std::vector<ReturnLevel> levels;
};

/// Fits the maxima of all arrangements together. `maxima`: for each arrangement the maxima of its segments; `segments`:
/// the return periods of the levels, each above 1. Everything is NaN if there are too few maxima.
FittedExtreme fit_extremes(std::span<const std::vector<double>> maxima, ExtremeKind kind,
                           std::span<const double> segments);

}  // namespace floes
