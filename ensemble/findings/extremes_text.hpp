#pragma once
// Extremes as text.

#include <string>
#include <vector>

#include "findings/extremes.hpp"
#include "findings/summary.hpp"

namespace floes {

/// A heading, a line a case and distribution, and what the columns mean.
std::string extremes_table(const Summary& summary, const std::vector<CaseExtremes>& extremes, int width);
/// A header line and one line a case and distribution.
std::string extremes_csv(const Summary& summary, const std::vector<CaseExtremes>& extremes);
/// A header line and one line a maximum: its load and the probabilities that a segment exceeds it.
std::string exceedance_csv(const Summary& summary, const std::vector<CaseExtremes>& extremes);

}  // namespace floes
