#pragma once
// A mean corrected by what is known of the arrangements before they are run: control variates, or the regression
// estimator of survey sampling (W. G. Cochran, Sampling Techniques, Wiley 1977, chapter 7).
//
// If the load depends on a covariate, such as the order of the floes, and the arrangements that were run have more of
// it than the average arrangement, the mean is biased by the slope times the difference. The average of the covariate
// costs no simulation.

#include <cstddef>
#include <span>
#include <vector>

#include "inference/interval.hpp"

namespace floes {

/// Covariates: a row for each arrangement.
using Covariates = std::vector<std::vector<double>>;

/// Fewest values that are corrected: with fewer the choice whether to correct is itself by chance, and intervals of
/// values that do not depend on the covariates held in 79 to 86 % of trials where they were corrected.
inline constexpr std::size_t fewest_controlled = 20;

struct ControlledMean {
    Interval plain;       ///< mean and its 95 % interval without correction
    Interval corrected;   ///< with it; predictions as plain
    double left_out = 0;  ///< R²: share of the variance that a fit to the other arrangements predicts; below 0: none
    bool used = false;    ///< whether it shortens the interval; if not, `corrected` is `plain`
    double saved = 0;     ///< further arrangements that would have shortened the interval as much; 0 unless used
};

/// `values`: one of each arrangement; `known`: its covariates; `population`: those of arrangements that were not run,
/// at least 2. The correction is used if it predicts arrangements that the fit has not seen and shortens the interval.
/// The interval is Student's t, with one degree of freedom less for each covariate; it includes the uncertainty of the
/// slopes and of the population's mean. Covariates that do not vary are left out.
ControlledMean controlled_mean(std::span<const double> values, const Covariates& known, const Covariates& population);

}  // namespace floes
