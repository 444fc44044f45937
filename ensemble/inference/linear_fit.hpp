#pragma once
// A plane through the points of a design: how much an output changes along each axis.

#include <span>
#include <vector>

#include "inference/interval.hpp"

namespace floes {

/// Coordinates of the points: one row a point, one number an axis. From -1 to 1, so that a slope is the change of the
/// output over half an axis.
using PointCoordinates = std::vector<std::vector<double>>;

/// A slope with its 95 % interval, in the unit of the output; NaN where undefined.
struct Slope {
    double estimate;
    double low;
    double high;
};

struct LinearFit {
    double centre = 0;          ///< of the plane at coordinates 0
    std::vector<Slope> slopes;  ///< one an axis
    double r_squared = 0;       ///< of the means over repetitions; NaN where they do not differ
    int repetitions = 0;        ///< that the intervals come from; 0: from the residuals
};

/// Whether the points tell the axes apart: more points than axes + 1, and no axis that the others (or a constant) make.
bool can_fit(const PointCoordinates& points);

/// Least squares over the points (Householder QR with column pivoting), each repetition on its own; slopes are means
/// over repetitions with Student's t interval, which takes repetitions as independent and points as they are: what a
/// plane does not follow, an interaction or a curve, widens nothing. `repetitions`: at least 2, each one value a point.
/// Throws InputError unless can_fit() and all is finite.
LinearFit fit_repetitions(const PointCoordinates& points, std::span<const std::vector<double>> repetitions);

/// The same for one value a point, with intervals from the residuals: t with points - axes - 1 degrees of freedom,
/// which takes all that the plane does not follow as noise.
LinearFit fit_points(const PointCoordinates& points, std::span<const double> values);

}  // namespace floes
