#pragma once
// Differences over arrangements and their tests: of two cases over the same arrangements, which excludes the effect
// that an arrangement has on both, and of the load through the measured window.

#include <span>
#include <string>
#include <string_view>
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
    double t = 0;           ///< difference / (sd / √n)
    double t_p = 1;         ///< two-sided
    double rank_sum = 0;    ///< Wilcoxon's W: the smaller of the rank sums of positive and negative differences
    double wilcoxon_p = 1;  ///< two-sided
    bool wilcoxon_exact = true;
    double variance_saved = 0;  ///< 1 - var(second - first) / (var first + var second): equal to 0 for unrelated cases
};

/// `first` and `second`: one finite value for each arrangement, in the same order. Figures that need more pairs or some
/// scatter are NaN. Throws InputError if the sizes differ or a value is not finite.
PairedComparison compare_paired(std::span<const double> first, std::span<const double> second);

/// Two samples that have nothing in common.
struct MeanDifference {
    double difference = 0;      ///< mean of second less mean of first
    double standard_error = 0;  ///< NaN where a sample has fewer than two values
    Limits interval{};          ///< Welch's t; NaN where nothing varies or a sample has fewer than two values
};

/// By B. L. Welch, Biometrika 34 (1947) 28-35. Values finite, at least one in each.
MeanDifference difference_of_means(std::span<const double> first, std::span<const double> second);

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

/// Smallest number of pairs with which a two-sided t test at 5 % finds a true mean `difference` with probability
/// `power`, if differences are normal with the given `sd`, by the noncentral t distribution; at least 2, and at most
/// 1e6, also for a difference of 0. NaN gives 0.
int arrangements_to_resolve(double difference, double sd, double power = 0.8);

/// The power of that test with `pairs` pairs (at least 2).
double power_of_paired_test(int pairs, double difference, double sd);

// Whether the load of a case rises or falls through the measured window, over all its members: a single member's load
// wanders too slowly to tell. Each member gives one slope, and one difference of segment maxima. Their mean is judged
// by its size, and every case by itself, so that a campaign of many cases sees in each what it would see in that one
// alone.

/// A smaller change through the window, relative to the load, counts as steady. A load that goes from its mean less
/// half a change to its mean and half of it ends that half above its mean: by 5 % at most, which is what a mean is
/// usually wanted to (stop.half_width_percent) and less than intervals of design loads say. A long exposure passes
/// through one arrangement after another (docs/design_load.md), so a rise does not go on for longer than a passage.
inline constexpr double steady_change = 0.1;

/// By the 95 % interval of the change: seen to rise or fall where it has no smaller one than steady_change, steady
/// where it has no larger one, else not known.
enum class Steadiness { not_known, steady, falls, rises };
/// "not known", "steady", "falls", "rises".
std::string_view name_of(Steadiness steadiness);

/// Of a mean change with its interval, of a load of that size; both in one unit.
Steadiness steadiness_of(const Interval& change, double load);

/// The mean of these changes, one of each member, by Student's t. Fewer than three say nothing: limits NaN.
Interval mean_change(std::span<const double> changes);

/// What a member says of it.
struct MemberTrend {
    double mean = 0;     ///< load, N
    double rise = 0;     ///< slope of the load times the window, N
    double growth = 0;   ///< largest load of the last segment less that of the first, N; NaN of one segment
    double largest = 0;  ///< mean of the segment maxima, N
};

/// `rise`: slope times the window; `maxima`: of the segments.
MemberTrend member_trend(double mean, double rise, std::span<const double> maxima);

/// Maxima of the load averaged over the shortest time where members have them, else of single steps. `window`: s.
MemberTrend member_trend(const MemberOutputs& outputs, double window);

/// Of a response, in its unit.
MemberTrend member_trend(const Response& response);

struct JointTrend {
    std::string_view noun = "load";  ///< what rises or falls; what follows is in its unit
    int members = 0;
    double mean = 0;          ///< load, N
    double largest = 0;       ///< mean of the segment maxima, N
    Interval load{};          ///< slope of the load times the window, N
    Interval maxima{};        ///< largest load of the last segment less that of the first, N
    Steadiness steadiness{};  ///< of the load; of the maxima where these alone are seen to rise or fall
    bool by_load = true;      ///< whether it is that of the load

    bool rises() const { return steadiness == Steadiness::rises; }
    bool seen() const { return rises() || steadiness == Steadiness::falls; }
    const Interval& judged() const { return by_load ? load : maxima; }  ///< the change that the steadiness is of, N
    double whole() const { return by_load ? mean : largest; }           ///< what that is compared with, N
};

/// Of a case, from its members. `noun`: what they are trends of.
JointTrend joint_trend(std::span<const MemberTrend> members, std::string_view noun = "load");

/// "rises"; "falls (segment maxima)" where not the load itself is judged.
std::string judged_words(const JointTrend& trend);

/// "+51 % [+33, +70]": what is judged, relative to the mean.
std::string change_words(const JointTrend& trend);

/// "the load rises, +51 % [+33, +70] of its mean over the measured window (4 members)", "not known whether the load is
/// steady, …", without a full stop.
std::string trend_text(const JointTrend& trend);

}  // namespace floes
