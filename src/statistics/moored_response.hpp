#pragma once
// How a moored structure moved in the window and what its moorings bore, as single numbers.

#include <limits>
#include <span>

#include "statistics/swing.hpp"

namespace floes {

/// Signs as in simulation/motion_history.hpp. All NaN without moorings.
struct MooredResponse {
    Swing surge_offset;                                                 ///< m
    Swing sway_offset;                                                  ///< m
    Swing yaw;                                                          ///< rad
    Swing surge_mooring;                                                ///< N
    Swing sway_mooring;                                                 ///< N
    Swing surge_thrust{};                                               ///< N; NaN without thrusters
    Swing sway_thrust{};                                                ///< N
    Swing yaw_thrust{};                                                 ///< N m
    double thrust_at_limit = std::numeric_limits<double>::quiet_NaN();  ///< share of the window in any direction
    double mean_maximum = std::numeric_limits<double>::quiet_NaN();  ///< of the surge mooring force, over segments, N
    double rms_velocity = std::numeric_limits<double>::quiet_NaN();  ///< in surge, relative to the anchors, m/s
    double line_tension = std::numeric_limits<double>::quiet_NaN();  ///< the largest of any line over the run, N
    double broken_lines = std::numeric_limits<double>::quiet_NaN();  ///< at the end of the run
};

/// Root of the mean square of the changes between values over `step` s; at least two values.
double rms_rate(std::span<const double> values, double step);

}  // namespace floes
