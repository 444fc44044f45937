#pragma once
// Differences over arrangements and their tests: of two cases over the same arrangements, which excludes the effect
// that an arrangement has on both, and of the load through the measured window.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "inference/interval.hpp"
#include "member/member_outputs.hpp"

namespace floes {

struct PairedComparison {
    int arrangements = 0;   ///< pairs
    double difference = 0;  ///< mean of second - first, unit of the values
    double sd = 0;          ///< sample SD of the differences
    Limits t_interval{};    ///< of the mean difference, Student's t
    Apart apart{};          ///< pairs whose difference is far from the others' (interval.hpp)
    Limits interval{};      ///< of the mean difference: Student's t, or of the mixture where some are apart
    Limits bca{};           ///< of the mean difference, BCa bootstrap over arrangements
    double t = 0;           ///< difference / (sd / √n)
    double t_p = 1;         ///< two-sided
    double rank_sum = 0;    ///< Wilcoxon's W: the smaller of the rank sums of positive and negative differences
    double wilcoxon_p = 1;  ///< two-sided
    bool wilcoxon_exact = true;
    double variance_saved = 0;  ///< 1 - var(second - first) / (var first + var second): equal to 0 for unrelated cases
};

/// `first` and `second`: one finite value for each arrangement, in the same order. Figures that need more pairs or some
/// scatter are NaN. Throws InputError if the sizes differ or a value is not finite.
PairedComparison compare_paired(std::span<const double> first, std::span<const double> second,
                                double confidence = 0.95);

/// Two samples that have nothing in common.
struct MeanDifference {
    double difference = 0;      ///< mean of second less mean of first
    double standard_error = 0;  ///< NaN where a sample has fewer than two values
    Limits interval{};          ///< Welch's t; NaN where nothing varies or a sample has fewer than two values
};

/// By B. L. Welch, Biometrika 34 (1947) 28-35. Values finite, at least one in each.
MeanDifference difference_of_means(std::span<const double> first, std::span<const double> second,
                                   double confidence = 0.95);

/// Wilcoxon's signed-rank test of differences, two-sided. Zeros are left out, ties share the mean of their ranks. Up to
/// 50 differences p is exact given the ranks, also with ties (all 2^n signs are counted); above that, normal with the
/// variance corrected for ties, without continuity correction. scipy.stats.wilcoxon agrees except for ties and zeros in
/// small samples. NaN if all differences are zero.
struct SignedRank {
    double rank_sum;
    double p;
    bool exact;
};
SignedRank wilcoxon_signed_rank(std::span<const double> differences);

/// Holm's adjustment: p times (m - rank), made monotone and cut at 1, in the order given. Comparing the adjusted p with
/// 0.05 keeps the probability of any false positive among all below 0.05. NaN values stay NaN and do not count. S.
/// Holm, Scand. J. Stat. 6 (1979) 65-70.
std::vector<double> holm(std::span<const double> p);

/// Smallest number of pairs with which a two-sided t test at level 1 - confidence finds a true mean `difference` with
/// probability `power`, if differences are normal with the given `sd`, by the noncentral t distribution; at least 2,
/// and at most 1e6, also for a difference of 0. NaN gives 0.
int arrangements_to_resolve(double difference, double sd, double confidence = 0.95, double power = 0.8);

/// The power of that test with `pairs` pairs (at least 2).
double power_of_paired_test(int pairs, double difference, double sd, double confidence = 0.95);

// Whether the load of a case rises or falls through the measured window, over all its members: a single member's load
// wanders too slowly to tell. Each member gives one slope, and one difference of segment maxima, and these are tested.

/// What a member says of it.
struct MemberTrend {
    double mean = 0;     ///< load, N
    double rise = 0;     ///< slope of the load times the window, N
    double growth = 0;   ///< largest load of the last segment less that of the first, N; NaN of one segment
    double largest = 0;  ///< mean of the segment maxima, N
};

/// Maxima of the load averaged over the shortest time where members have them, else of single steps. `window`: s.
MemberTrend member_trend(const MemberOutputs& outputs, double window);

/// The change over the measured window, N, mean over members with Student's interval, and its two-sided p; NaN for
/// fewer than 3 members or if all are equal.
struct Change {
    Interval over_window{};
    double p = 1;
};

struct JointTrend {
    std::size_t case_index = 0;
    int members = 0;
    double mean = 0;     ///< load, N
    double largest = 0;  ///< mean of the segment maxima that are tested, N
    Change load;         ///< slope of the load times the window
    Change maxima;       ///< largest load of the last segment less that of the first, averaged over the shortest time
    bool significant = false;  ///< of either, by Holm's adjustment over all cases at 1 %
    bool seen = false;         ///< significant, and not sure to be negligible

    bool by_load = true;  ///< whether the load tells more of it than the maxima

    bool rises() const { return seen && (by_load ? load : maxima).over_window.estimate > 0; }
    bool negligible() const { return significant && !seen; }
};

/// A change that is surely smaller, relative to the mean load or to the mean of the maxima, is negligible. A long
/// exposure passes through one arrangement after another (docs/design_load.md), so a rise does not go on for longer
/// than a passage: it lifts the load of the window's end above that of its middle by half of this, which is less than
/// intervals of design loads say.
inline constexpr double negligible_change = 0.02;

/// The mean of these changes, one of each member, with its interval and p.
Change change_of(const std::vector<double>& values);

/// Whether the interval has a change that matters to a figure of that size.
bool matters(const Change& change, double figure);

/// For each case, in their order, from its members.
std::vector<JointTrend> joint_trends(const std::vector<std::vector<MemberTrend>>& cases);

/// "the load rises by 14 N of 24 N over the measured window (24 members, p = 2e-07)", without a full stop.
std::string trend_text(const JointTrend& trend);

}  // namespace floes
