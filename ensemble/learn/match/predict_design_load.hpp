#pragma once
// The design load with the uncertainty of its inputs: the largest averaged load in an exposure, over the inputs that
// are left.
//
// A point of a design has a few runs, too few for a tail of its own. So, as in regional frequency analysis (the index
// method; J. R. M. Hosking and J. R. Wallis, Regional Frequency Analysis, Cambridge 1997), the load of every run is
// divided by the emulated mean maximum at its point, and one tail is fitted to all of them. It gives the growth from
// the mean maximum to the largest load in the exposure; the emulated mean maximum times the growth is the design load
// at any inputs. This assumes the same growth at all inputs; to check it, the growth is also computed for the lower and
// the upper half of the mean maxima.

#include <span>
#include <string>
#include <vector>

#include "findings/design_load.hpp"
#include "match/over_left.hpp"
#include "tables/section.hpp"

namespace floes {

/// Of one case. Loads are in N, at the scale that was asked for.
struct PredictedDesignLoad {
    std::string case_name;
    std::size_t runs = 0;              ///< behind the growth
    bool only_left = true;             ///< whether they are those at points that are left; else all
    DesignLoadFigure growth_expected;  ///< expected largest load over the mean maximum
    DesignLoadFigure growth_quantile;  ///< the quantile over it; both of both tails
    double growth_lower_half = 0;      ///< of the quantile, from the runs with the smaller mean maxima; NaN: too few
    double growth_upper_half = 0;      ///< from the others
    PredictedRange expected;           ///< with equal weights
    PredictedRange expected_weighed;   ///< with the likelihood of the targets as weights
    PredictedRange quantile;           ///< that the largest load stays below with the probability asked for
    PredictedRange quantile_weighed;
};

/// Fewest runs at points that are left from which the growth is taken; with fewer, from all points.
inline constexpr std::size_t fewest_growth_runs = 20;

/// One for each case with runs, of the first quantile asked for. Throws InputError as OverLeft::emulated() and
/// averaging_time() do, and where a case has too few peaks to fit.
std::vector<PredictedDesignLoad> predict_design_load(std::span<const MatchWave> waves, const MatchData& data,
                                                     const std::vector<EmulatedTarget>& targets, const OverLeft& left,
                                                     const DesignLoadRequest& request);

Section design_section(const std::vector<PredictedDesignLoad>& designs, const DesignLoadRequest& request);

}  // namespace floes
