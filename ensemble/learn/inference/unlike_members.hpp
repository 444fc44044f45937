#pragma once
// Whether the members of a case differ: whether some stand out, and whether the others scatter more than their peaks
// explain.

#include <cstddef>
#include <span>
#include <vector>

namespace floes {

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

/// Rows of finite values that are too high for a normal distribution of the others, by that test; rising.
std::vector<std::size_t> rows_standing_out(std::span<const double> values);

/// The same to either side: rows of values too far from a normal distribution of the others, at 1 % for both together.
std::vector<std::size_t> rows_standing_apart(std::span<const double> values);

/// The largest share of members of a kind that is not among `members` in one of twenty samples.
double unseen_share(std::size_t members);

/// Fewest members of which a kind of that share is missing in at most one of twenty samples; 0 < share < 1.
int members_to_see(double share);

}  // namespace floes
