#pragma once
// Bootstrap over arrangements: how far an estimate would move had other arrangements been drawn. No shape of the
// distribution is assumed. The same values give the same limits on every machine: the draws are counter-based.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace floes {

/// A confidence interval, in the unit of the estimate; NaN where undefined.
struct Limits {
    double low;
    double high;
    friend bool operator==(const Limits&, const Limits&) = default;
};

/// A statistic of a sample given as rows of the data, with repetitions. A row is one arrangement with all that belongs
/// to it, so that what depends on each other is drawn together.
using RowStatistic = std::function<double(std::span<const std::uint32_t> rows)>;

struct BootstrapOptions {
    double confidence = 0.95;
    int resamples = 0;       ///< 0: default_resamples()
    std::uint32_t draw = 0;  ///< another number is another, independent set of resamples
};

/// 9999, fewer where the rows are so many that this would draw more than 20 million: never below 999.
int default_resamples(std::size_t rows);

/// The statistic of `resamples` samples of `rows` rows drawn with replacement from `rows` rows, in order of drawing.
std::vector<double> bootstrap(std::size_t rows, const RowStatistic& statistic, const BootstrapOptions& options = {});

/// Bias-corrected and accelerated interval: B. Efron, "Better bootstrap confidence intervals", J. Am. Stat. Assoc. 82
/// (1987) 171-185; acceleration from the jackknife over rows, as scipy.stats.bootstrap has it. NaN with fewer than 3
/// rows or when all resamples give one value. Throws InputError when the confidence is not between 0 and 1.
Limits bca_interval(std::size_t rows, const RowStatistic& statistic, const BootstrapOptions& options = {});

/// The same for the mean of `values`.
Limits bca_mean_interval(std::span<const double> values, const BootstrapOptions& options = {});

/// Percentile interval of values, sorted or not; those that are not finite are left out.
Limits percentile_interval(std::vector<double> values, double confidence = 0.95);

/// Quantile of sorted values, linear between them (type 7 of Hyndman and Fan, numpy's default); 0 <= p <= 1.
double quantile_of_sorted(std::span<const double> sorted, double p);

}  // namespace floes
