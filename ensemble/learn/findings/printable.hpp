#pragma once
// Which intervals say something. One that says nothing is not printed as numbers: people quote what they see.

#include "findings/summary.hpp"

namespace floes {

/// Fewest arrangements whose interval is printed: of two, Student's t makes it 13 standard errors wide on either side.
inline constexpr int fewest_for_interval = 3;

/// Whether the 95 % limits of an estimate over `runs` arrangements say something: at least three runs, which differ,
/// and limits no further apart than four times the estimate.
bool says_something(double estimate, Limits limits, int runs);

/// The same for the limits of a quantity, which may have its sign by its nature, as a correlation has.
bool says_something(const Quantity& quantity, double estimate, Limits limits, int runs);

/// "[17.2, 29.6]", "–" where the limits say nothing, "" where there are none.
std::string printable_bracket(const Quantity& quantity, double estimate, Limits limits, int runs, int decimals);

/// About how many arrangements give the mean to ± `share` of itself, from the scatter of `runs` so far; 0: unknown.
int arrangements_for(const Interval& found, int runs, double share);

}  // namespace floes
