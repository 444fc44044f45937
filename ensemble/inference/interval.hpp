#pragma once
// Inference from a sample of arrangements to all arrangements that could have been drawn. Every interval is of 95 %.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "statistics/distributions.hpp"

namespace floes {

/// The probability beyond each limit of an interval.
inline constexpr double beyond_limit = (1 - 0.95) / 2;

/// An estimate with two ranges, both in the unit of the values; NaN where undefined.
struct Interval {
    double estimate;  ///< mean over arrangements
    double low;       ///< confidence interval of the mean over all arrangements
    double high;
    double prediction_low;  ///< prediction interval of the value of one further arrangement
    double prediction_high;
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// A load with its 95 % limits; NaN where there is none.
struct LoadFigure {
    double value = 0;  ///< N; of posterior draws their median
    Limits interval{};
};

/// Mean of `values`, one value an arrangement, with Student's t: mean ± t s / √n for the mean and mean ± t s √(1 + 1/n)
/// for one further run, where s is the sample SD (n - 1). Both treat the values as independent and nearly normal; with
/// large n the first tolerates a skewed distribution, the second does not. A single value gives only an estimate; no
/// values give NaN. Throws InputError unless all `values` are finite.
Interval mean_interval(std::span<const double> values);

/// The same for values above 0, such as maxima: the prediction interval is that of their logarithms, so it cannot reach
/// below 0, and allows for a longer tail above. Where a value is 0 or below it is mean_interval().
Interval positive_interval(std::span<const double> values);

/// The interval cut to [least, most], for quantities that cannot lie outside (a ratio: 0 to 1). The coverage stays.
Interval clipped(const Interval& interval, double least, double most);

// Whether the members of a case differ: whether some stand out, and whether the others scatter more than their peaks
// explain.

/// The peaks of each member, falling, N.
using MemberPeakSpans = std::span<const std::span<const double>>;

struct UnlikeMembers {
    std::vector<std::size_t> out;  ///< rows that stand out, rising
    std::size_t carried = 0;       ///< the highest peaks of all that are theirs, before the first of another member
    double dispersion = 1;         ///< variance over mean of the peaks above the threshold, a member; of the others
    double dispersion_p = 1;       ///< the probability of that or more, if members are alike
};

/// Fewest members among which one can stand out.
inline constexpr std::size_t fewest_to_stand_out = 5;

/// `share` of the others' peaks, the highest, is counted for the dispersion. A
/// member stands out upwards by the mean logarithm of its highest third: Rosner's generalised ESD test (Technometrics
/// 25 (1983) 165-172), one-sided at 1 %, of at most a quarter of the members.
UnlikeMembers unlike_members(MemberPeakSpans peaks, double share);

/// All peaks of the rows that stand out, or of the others, rising.
std::vector<double> pooled_peaks(MemberPeakSpans peaks, std::span<const std::size_t> out, bool of_out);

/// The largest share of members of a kind that is not among `members` in one of twenty samples.
double unseen_share(std::size_t members);

/// Fewest members that show a kind of that share in at least 19 of 20 samples; 0 < share < 1.
int members_to_see(double share);

// The mean of members of which some are of another kind, as where ice jams in one of twenty arrangements. Student's t
// takes the scatter for normal: below, its interval then reaches beyond the mean of the members that do not stand out,
// and above it ends too early, because the sample says little of how many members are of that kind.
//
//   mean over all arrangements = μ + (p₊ - p₋) δ
//
// μ: mean of the members that do not stand out, with Student's t; p₊, p₋: shares of members above and below them, which
// have Dirichlet's distribution with Jeffreys' prior (1/2 each); δ: distance of such members from μ, of both sides,
// log-normal about the geometric mean of those seen, the variance of the logarithm by its own scatter and that of two
// members of 30 % (a scaled inverse χ² prior), since of one member nothing says how much its kind varies.
//
// What no member shows is in no interval: unseen_share() bounds it. docs/statistics.md has how
// often these intervals hold.

/// On which side members may stand out: above, of loads, by their logarithm; on both, of differences.
enum class Sides { above, both };

/// Rows of a sample, rising.
struct Apart {
    std::vector<std::size_t> above;
    std::vector<std::size_t> below;

    std::size_t count() const { return above.size() + below.size(); }
};

/// More values are not tested: of so many Student's interval holds whatever kinds there are, and the test takes long.
inline constexpr std::size_t most_tested = 2000;

/// The values that are too far from the others for a normal distribution, of their logarithms for Sides::above: then
/// none unless all values are above 0. Rosner's test, at 1 %, of at most a quarter of the values.
Apart apart(std::span<const double> values, Sides sides);

/// `plain`, the interval of the mean of `values`, unless some are apart: then with the limits of the mixture, which
/// include the estimate, and for Sides::above with the prediction of one further run, of either kind. Draws come from a
/// counter-based stream: the same values give the same limits.
Interval mixed_interval(std::span<const double> values, const Interval& plain, const Apart& apart, Sides sides);

// Bootstrap over arrangements: how much an estimate would vary with other arrangements. No distribution is assumed. The
// same values give the same limits on every machine: the draws are counter-based.

/// A statistic of a sample given as rows of the data, with repetitions. A row is one arrangement with all its values,
/// so that dependent values are drawn together.
using RowStatistic = std::function<double(std::span<const std::uint32_t> rows)>;

/// 0, 1, …, rows - 1.
std::vector<std::uint32_t> all_rows(std::size_t rows);

/// The statistic of `resamples` samples of `rows` rows drawn with replacement from `rows` rows, in order of drawing. 0:
/// of 9999 samples; fewer if that would draw more than 20 million rows, but at least 999.
std::vector<double> bootstrap(std::size_t rows, const RowStatistic& statistic, int resamples = 0);

/// Bias-corrected and accelerated interval: B. Efron, "Better bootstrap confidence intervals", J. Am. Stat. Assoc. 82
/// (1987) 171-185; acceleration from the jackknife over rows, as in scipy.stats.bootstrap. NaN with fewer than 3 rows
/// or if all resamples give the same value.
Limits bca_interval(std::size_t rows, const RowStatistic& statistic, int resamples = 0);

/// Percentile interval of values in any order; those that are not finite are left out.
Limits percentile_interval(std::vector<double> values);

/// Quantile of sorted values, linear between them (type 7 of Hyndman and Fan, numpy's default); 0 <= p <= 1.
double quantile_of_sorted(std::span<const double> sorted, double p);

}  // namespace floes
