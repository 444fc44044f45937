#pragma once
// Means corrected for what is known of the arrangements before they are run: their local order and the coverage ahead.

#include "findings/evidence.hpp"

namespace floes {

/// Arrangements that are drawn, not run, for the means of the covariates.
inline constexpr int control_draws = 200;

/// The quantities of the headlines for each case: the mean, the share of its variance that the covariates explain of
/// arrangements left out (r_squared_left_out), and the corrected mean, which is the mean itself unless `used`.
/// Arrangements of a geometry are drawn once, those after the campaign's last; cases with poses from a file have no
/// rows.
Results find_control(const Evidence& evidence);

Section control_section(Evidence& evidence);

}  // namespace floes
