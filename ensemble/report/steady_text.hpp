#pragma once
// Steady states as text.

#include <string>

#include "report/steady.hpp"
#include "report/summary.hpp"

namespace floes {

/// A heading, a line a case, and what the columns mean.
std::string steady_table(const Summary& summary, const SteadyReport& steady, int width);
/// A header line and one line a member.
std::string steady_csv(const Summary& summary, const CampaignTable& table, const SteadyReport& steady);

}  // namespace floes
