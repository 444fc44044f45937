#pragma once
// Two cases over the same arrangements: the difference within each arrangement, which is free of what the arrangements
// alone do to the load. The rank test is in wilcoxon.cpp.

#include <span>
#include <vector>

#include "inference/bootstrap.hpp"

namespace floes {

struct PairedComparison {
    int arrangements = 0;   ///< pairs
    double difference = 0;  ///< mean of second - first, unit of the values
    double sd = 0;          ///< sample SD of the differences
    Limits t_interval{};    ///< of the mean difference, Student's t
    Limits bca{};           ///< of the mean difference, BCa bootstrap over arrangements
    double t = 0;           ///< difference / (sd / √n)
    double t_p = 1;         ///< two-sided
    double rank_sum = 0;    ///< Wilcoxon's W: the smaller of the rank sums of positive and negative differences
    double wilcoxon_p = 1;  ///< two-sided
    bool wilcoxon_exact = true;
    double variance_saved = 0;  ///< 1 - var(second - first) / (var first + var second): equal to 0 for unrelated cases
};

/// `first` and `second`: one value an arrangement, in the same order, finite. Figures that want more pairs than there
/// are, or any spread, are NaN. Throws InputError when the sizes differ or a value is not finite.
PairedComparison compare_paired(std::span<const double> first, std::span<const double> second,
                                double confidence = 0.95);

/// Wilcoxon's signed-rank test of differences, two-sided. Zeros are left out, ties share the mean of their ranks. Up to
/// 50 differences p is exact given the ranks, also with ties (all 2^n signs are counted); beyond, normal with the
/// variance corrected for ties, without continuity correction: scipy.stats.wilcoxon is the same but for ties and zeros
/// in small samples. NaN without a difference.
struct SignedRank {
    double rank_sum;
    double p;
    bool exact;
};
SignedRank wilcoxon_signed_rank(std::span<const double> differences);

/// Holm's adjustment: p times (m - rank), made monotone and cut at 1, in the order given. Comparing the adjusted p with
/// 0.05 keeps the chance of any false alarm among all below 0.05. NaN stay NaN and do not count. S. Holm, Scand. J.
/// Stat. 6 (1979) 65-70.
std::vector<double> holm(std::span<const double> p);

/// Smallest number of pairs with which a two-sided t test at level 1 - confidence finds a true mean `difference` with
/// probability `power`, when differences are normal with the given `sd`; at least 2, by the noncentral t distribution.
/// Beyond 1e6, and for a difference of 0, the most that can be said is 1e6. NaN in, 0 out.
int arrangements_to_resolve(double difference, double sd, double confidence = 0.95, double power = 0.8);

/// The probability meant there, for `pairs` pairs (at least 2).
double power_of_paired_test(int pairs, double difference, double sd, double confidence = 0.95);

}  // namespace floes
