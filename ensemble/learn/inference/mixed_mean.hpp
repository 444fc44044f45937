#pragma once
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
// What no member shows is in no interval: unseen_share() of unlike_members.hpp bounds it. docs/statistics.md has how
// often these intervals hold.

#include <span>
#include <vector>

#include "inference/interval.hpp"

namespace floes {

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
/// none unless all values are above 0. Rosner's test, at 1 %, of at most a quarter of the values (unlike_members.hpp).
Apart apart(std::span<const double> values, Sides sides);

/// `plain`, the interval of the mean of `values`, unless some are apart: then with the limits of the mixture, which
/// include the estimate, and for Sides::above with the prediction of one further run, of either kind. Draws come from a
/// counter-based stream: the same values give the same limits.
Interval mixed_interval(std::span<const double> values, const Interval& plain, const Apart& apart, Sides sides,
                        double confidence = 0.95);

}  // namespace floes
