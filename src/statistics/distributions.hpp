#pragma once
// Intervals, and the distributions that tests and intervals need.

namespace floes {

/// The limits of an interval, in the unit of what it is of; NaN where undefined.
struct Limits {
    double low;
    double high;
    friend bool operator==(const Limits&, const Limits&) = default;
};

// Tails and quantiles of the distributions that tests and intervals need, by Boost.Math, which takes seconds to
// compile. `tail`, `share`: probabilities in (0, 1). Throw std::domain_error outside these ranges.

double normal_below(double z);              ///< Φ(z)
double normal_above(double z);              ///< 1 - Φ(z), without its rounding
double normal_quantile(double share);       ///< z with that share below it
double normal_quantile_above(double tail);  ///< z with that share above it

double student_above(double t, double freedom);
/// What t of so many degrees of freedom exceeds with this probability.
double student_t(double freedom, double tail);

double chi_squared_above(double value, double freedom);
double chi_squared_quantile_above(double tail, double freedom);

/// For the ratio of two variances of so many degrees of freedom.
double fisher_quantile_above(double tail, double freedom_above, double freedom_below);

}  // namespace floes
