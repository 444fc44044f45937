#pragma once
// How a moored structure moved in the window and what its moorings bore, as single numbers.

#include <limits>
#include <span>

namespace floes {

/// Not measured: NaN.
struct Swing {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();
    double largest = std::numeric_limits<double>::quiet_NaN();  ///< amount, at either side
};

/// Signs as in simulation/motion_history.hpp. All NaN without moorings.
struct MooredResponse {
    Swing surge_offset;                                              ///< m
    Swing sway_offset;                                               ///< m
    Swing yaw;                                                       ///< rad
    Swing surge_mooring;                                             ///< N
    Swing sway_mooring;                                              ///< N
    double mean_maximum = std::numeric_limits<double>::quiet_NaN();  ///< of the surge mooring force, over segments, N
    double rms_velocity = std::numeric_limits<double>::quiet_NaN();  ///< in surge, relative to the anchors, m/s
    double line_tension = std::numeric_limits<double>::quiet_NaN();  ///< the largest of any line over the run, N
    double broken_lines = std::numeric_limits<double>::quiet_NaN();  ///< at the end of the run
};

/// Of values at the ends of steps, at least one.
Swing swing_of(std::span<const double> values);

/// Root of the mean square of the changes between values over `step` s; at least two values.
double rms_rate(std::span<const double> values, double step);

}  // namespace floes
