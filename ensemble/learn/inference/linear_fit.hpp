#pragma once
// A plane through the points of a design: how much an output changes along each axis.

#include <span>
#include <vector>

#include "inference/interval.hpp"

namespace floes {

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

}  // namespace floes
