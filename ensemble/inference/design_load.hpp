#pragma once
// The largest load in a long exposure, from short runs over many arrangements. docs/design_load.md has the method,
// and the coverage of its intervals where the truth is known.
//
// A member is one row: its peaks and its segment maxima are resampled together.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "inference/extremes.hpp"
#include "inference/interval.hpp"
#include "inference/posterior_load.hpp"
#include "inference/tails.hpp"

namespace floes {

/// The averaged load of one arrangement.
struct PeakRow {
    std::vector<double> peaks;           ///< declustered, falling, N
    std::vector<double> segment_maxima;  ///< N
};

/// The peaks of each row, which must outlive this.
std::vector<std::span<const double>> peaks_of(const std::vector<PeakRow>& rows);

struct Exposure {
    double time = 0;                    ///< s
    std::vector<double> probabilities;  ///< of not being exceeded, each in (0, 1)
    double share = 0.25;                ///< of the peaks, the highest, that the tails are fitted to
    bool quick = false;                 ///< both tails above one threshold; else averaged over 2, 1 and 0.4 times share
    bool expected = true;  ///< also the expected largest by both tails, which takes longest; else it is NaN
};

/// More cases than these have `quick` thresholds.
inline constexpr std::size_t most_averaged_cases = 12;

/// How the largest load is extrapolated.
enum class LargestBy {
    both_tails,  ///< Pareto and Weibull of members that differ, by what the peaks say of each (posterior_load.hpp)
    pareto,      ///< peaks over a threshold
    weibull,     ///< average exceedance rates
    gumbel,      ///< segment maxima
    gev
};
std::string_view name_of(LargestBy method);

/// Limits of both tails are from their posterior. The others have none: their estimate can be far off where a tail is
/// not of that form, and resampled members do not tell.
struct DesignLoadEstimate {
    LargestBy method = LargestBy::both_tails;
    LoadFigure expected;                ///< mean of the largest load in the exposure; NaN where it does not exist
    std::vector<LoadFigure> quantiles;  ///< in the order of Exposure::probabilities
};

struct DesignLoad {
    std::size_t arrangements = 0;
    double time_run = 0;                        ///< s, over all arrangements
    std::size_t peaks = 0;                      ///< above the threshold
    double threshold = 0;                       ///< N
    Tail pareto;                                ///< shape below 0: the load has an upper bound; above 0: a heavy tail
    Tail weibull;                               ///< shape 1: exponential; 2: Gaussian
    double weibull_weight = 0;                  ///< of the Weibull tail in both_tails, 0-1
    UnlikeMembers unlike;                       ///< rows that stand out, and how the others differ
    double scatter = 0;                         ///< SD of the logarithm of the members' scales; not of those
    double alike = 0;                           ///< probability that this is 0
    std::size_t dropped = 0;                    ///< of the draws, without a fit
    std::vector<DesignLoadEstimate> estimates;  ///< in the order of LargestBy; empty if there are too few peaks
    /// Bootstrap draws of the quantiles of both tails as if members were alike, a row each; NaN where the fit failed.
    /// Two cases with the same arrangements have the same draws in the same rows, as far as both have them.
    std::vector<std::vector<double>> draws;

    bool valid() const { return !estimates.empty(); }
};

/// Fewest members of which a design load says anything.
inline constexpr std::size_t fewest_members = 4;

DesignLoad design_load(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure);

/// The same with the estimate by both tails alone, and without draws.
DesignLoad load_by_both_tails(const std::vector<PeakRow>& rows, const Measured& measured, const Exposure& exposure);

/// The quantiles of both_tails fitted to the highest `shares` of the peaks: their sensitivity to the threshold.
std::vector<std::vector<double>> over_thresholds(const std::vector<PeakRow>& rows, const Measured& measured,
                                                 const Exposure& exposure, const std::vector<double>& shares);

}  // namespace floes
