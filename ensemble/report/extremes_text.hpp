#pragma once
// Extremes and steady states as text.

#include <string>
#include <vector>

#include "report/extremes.hpp"
#include "report/steady.hpp"
#include "report/summary.hpp"

namespace floes {

/// A heading, a line a case and distribution, and what the columns mean.
std::string extremes_table(const Summary& summary, const std::vector<CaseExtremes>& extremes, int width);
/// A header line and one line a case and distribution.
std::string extremes_csv(const Summary& summary, const std::vector<CaseExtremes>& extremes);
/// A header line and one line a maximum: its load and the probabilities that a segment exceeds it.
std::string exceedance_csv(const Summary& summary, const std::vector<CaseExtremes>& extremes);

/// A heading, a line a case, and what the columns mean.
std::string steady_table(const Summary& summary, const SteadyReport& steady, int width);
/// A header line and one line a member.
std::string steady_csv(const Summary& summary, const CampaignTable& table, const SteadyReport& steady);

}  // namespace floes
