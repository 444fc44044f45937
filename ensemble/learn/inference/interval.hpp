#pragma once
// Inference from a sample of arrangements to all arrangements that could have been drawn.

#include <span>

namespace floes {

/// An estimate with two ranges, both in the unit of the values; NaN where undefined.
struct Interval {
    double estimate;  ///< mean over arrangements
    double low;       ///< confidence interval of the mean over all arrangements
    double high;
    double prediction_low;  ///< prediction interval of the value of one further arrangement
    double prediction_high;
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// Mean of `values`, one value an arrangement, with Student's t: mean ± t s / √n for the mean and mean ± t s √(1 + 1/n)
/// for one further run, where s is the sample SD (n - 1). Both treat the values as independent and nearly normal; with
/// large n the first tolerates a skewed distribution, the second does not. A single value gives only an estimate; no
/// values give NaN. `values` finite; `confidence` between 0 and 1. Throws InputError otherwise.
Interval mean_interval(std::span<const double> values, double confidence = 0.95);

/// The same for values above 0, such as maxima: the prediction interval is that of their logarithms, so it cannot reach
/// below 0, and allows for a longer tail above. Where a value is 0 or below it is mean_interval().
Interval positive_interval(std::span<const double> values, double confidence = 0.95);

/// The interval cut to [least, most], for quantities that cannot lie outside (a ratio: 0 to 1). The coverage stays.
Interval clipped(const Interval& interval, double least, double most);

}  // namespace floes
