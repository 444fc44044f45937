#pragma once
// What of an output's variance its inputs explain: the axes of a design, the arrangements, and what is known of them.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "inference/interval.hpp"

namespace floes {

// A plane through the points of a design: how much an output changes along each axis.

/// Coordinates of the points: a row for each point, a number for each axis, from -1 to 1, so that a slope is the change
/// of the output over half an axis.
using PointCoordinates = std::vector<std::vector<double>>;

/// A slope with its 95 % interval, in the unit of the output; NaN where undefined.
struct Slope {
    double estimate;
    double low;
    double high;
};

struct LinearFit {
    double centre = 0;          ///< of the plane at coordinates 0
    std::vector<Slope> slopes;  ///< one for each axis
    double r_squared = 0;       ///< of the means over repetitions; NaN if these are all equal
    int repetitions = 0;        ///< used for the intervals; 0: they come from the residuals
};

/// Whether the slopes can be determined: more points than axes + 1, and no axis that is a combination of the others and
/// a constant.
bool can_fit(const PointCoordinates& points);

/// Least squares over the points (Householder QR with column pivoting), for each repetition separately. Slopes are
/// means over repetitions with Student's t interval, which treats repetitions as independent and points as fixed:
/// deviations from a plane, such as interaction or curvature, do not widen it. `repetitions`: at least 2, each with one
/// value for each point. Throws InputError unless can_fit() and all values are finite.
LinearFit fit_repetitions(const PointCoordinates& points, std::span<const std::vector<double>> repetitions);

/// The same for one value for each point, with intervals from the residuals: t with points - axes - 1 degrees of
/// freedom, which treats all deviations from the plane as noise.
LinearFit fit_points(const PointCoordinates& points, std::span<const double> values);

// A mean corrected by what is known of the arrangements before they are run: control variates, or the regression
// estimator of survey sampling (W. G. Cochran, Sampling Techniques, Wiley 1977, chapter 7).
//
// If the load depends on a covariate, such as the order of the floes, and the arrangements that were run have more of
// it than the average arrangement, the mean is biased by the slope times the difference. The average of the covariate
// costs no simulation.

/// Covariates: a row for each arrangement.
using Covariates = std::vector<std::vector<double>>;

/// Fewest values that are corrected: with fewer the choice whether to correct is itself by chance, and intervals of
/// values that do not depend on the covariates held in 79 to 86 % of trials where they were corrected.
inline constexpr std::size_t fewest_controlled = 20;

struct ControlledMean {
    Interval plain;      ///< mean and its 95 % interval without correction
    Interval corrected;  ///< with it; predictions as plain
    /// R²: share of the variance that a fit to the other arrangements predicts; below 0: none; NaN: not looked at.
    double left_out = std::numeric_limits<double>::quiet_NaN();
    bool used = false;  ///< whether it shortens the interval; if not, `corrected` is `plain`
    double saved = 0;   ///< further arrangements that would have shortened the interval as much; 0 unless used
};

/// `values`: one of each arrangement; `known`: its covariates; `population`: those of arrangements that were not run,
/// at least 2. The correction is used if it predicts arrangements that the fit has not seen and shortens the interval.
/// The interval is Student's t, with one degree of freedom less for each covariate; it includes the uncertainty of the
/// slopes and of the population's mean. Covariates that do not vary are left out.
ControlledMean controlled_mean(std::span<const double> values, const Covariates& known, const Covariates& population);

// Sobol indices from Saltelli's points: the share of an output's variance due to each input.

/// The output at Saltelli's points, over n base points j: at A_j, at B_j, and at A_j with input i taken from B_j.
struct SaltelliValues {
    std::vector<double> a;                ///< n
    std::vector<double> b;                ///< n
    std::vector<std::vector<double>> ab;  ///< inputs x n
};

/// An index with its BCa bootstrap interval over base points; NaN where undefined.
struct SobolIndex {
    double estimate;
    Limits interval;
};

struct SobolIndices {
    std::vector<SobolIndex> first;  ///< share of the variance that an input explains by itself, one for each input
    std::vector<SobolIndex> total;  ///< … including interactions with the others
};

/// With y - mean in place of y, and V the population variance of all y_A and y_B:
///   first  S_i = mean(y_B (y_ABi - y_A)) / V    A. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259-270, (b)
///   total  T_i = mean((y_A - y_ABi)²) / (2 V)   M. J. W. Jansen, Comput. Phys. Commun. 117 (1999) 35-43
/// as in scipy.stats.sobol_indices. All NaN if V is 0 or there is no base point. Intervals are those of bca_interval(),
/// of so many `resamples`, which treats base points as independent; for a Sobol sequence, which fills space more
/// evenly, they are too wide. Throws InputError if the sizes differ or a value is not finite.
SobolIndices sobol_indices(const SaltelliValues& values, int resamples = 0);

// What of the scatter of single runs belongs to their arrangement: cases over the same arrangements, in a table of two
// ways without repetition, value = case + arrangement + rest. The share of the arrangement is the intraclass
// correlation: P. E. Shrout and J. L. Fleiss, Psychological Bulletin 86 (1979) 420-428, their ICC(3,1), with the
// interval of F that stands there.

struct ArrangementShare {
    std::size_t cases = 0;
    std::size_t arrangements = 0;
    double sd = 0;      ///< of one run about the mean of its case, unit of the values
    double share = 0;   ///< of that variance, of arrangements; below 0 by chance where they explain nothing
    Limits interval{};  ///< 95 %
};

/// `values`: a list for each case, with one value for each arrangement, in the same order. Everything is NaN for fewer
/// than two cases or three arrangements, or where nothing scatters. Throws InputError if lists differ in length.
ArrangementShare arrangement_share(std::span<const std::vector<double>> values);

}  // namespace floes
