#pragma once
// Whether the load of a case is stationary, in words: what an extrapolation beyond the run rests on.

#include <string>

#include "findings/summary.hpp"
#include "inference/joint_trend.hpp"

namespace floes {

/// Changes over the window that the test cannot rule out, relative to the mean load, above which it says little.
inline constexpr double much_left_open = 0.25;

/// Of a load without a significant trend: by which test, what change the members leave open, and what the ice ahead
/// lets one conclude. Empty where nobody can tell, and where a trend is significant.
std::string stationary_text(const std::string& name, const JointTrend& trend, const CaseRow& about);

/// Of a load that rises in a field with an end: what would end it. Empty in a field without end.
std::string end_text(const CaseRow& about);

}  // namespace floes
