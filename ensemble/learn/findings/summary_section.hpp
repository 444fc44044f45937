#pragma once
// The section on the cases of a campaign.

#include "findings/summary.hpp"

namespace floes {

/// Conditions, counts, every quantity with its intervals, failures by mode, members set aside; one column for each
/// case. CSV: an interval takes the columns NAME, NAME_low, NAME_high, NAME_bca_low, NAME_bca_high,
/// NAME_prediction_low, NAME_prediction_high. JSON: {"campaign", "complete", "cases": [{"name", "cfm", …}]}.
Section summary_section(const Summary& summary, Reference reference = {});

}  // namespace floes
