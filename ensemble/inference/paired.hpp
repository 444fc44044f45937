#pragma once
// Two cases over the same arrangements. The difference within each arrangement excludes the effect that the arrangement
// has on both. The rank test is in wilcoxon.cpp.

#include <span>
#include <vector>

#include "inference/bootstrap.hpp"
#include "inference/interval.hpp"

namespace floes {

struct PairedComparison {
    int arrangements = 0;   ///< pairs
    double difference = 0;  ///< mean of second - first, unit of the values
    double sd = 0;          ///< sample SD of the differences
    Limits t_interval{};    ///< of the mean difference, Student's t
    Apart apart{};          ///< pairs whose difference is far from the others' (mixed_mean.hpp)
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

}  // namespace floes
