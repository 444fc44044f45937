#pragma once
// A value that goes up and down, as single numbers: an offset, a mooring force, a moment.

#include <limits>
#include <span>

namespace floes {

/// In the unit of the values. Not measured: NaN.
struct Swing {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();       ///< population standard deviation
    double largest = std::numeric_limits<double>::quiet_NaN();  ///< amount, at either side
};

/// Of values at the ends of steps, at least one.
Swing swing_of(std::span<const double> values);

}  // namespace floes
