#pragma once
// Steady states as text.

#include <string>

#include "findings/steady.hpp"
#include "findings/summary.hpp"

namespace floes {

/// What is said in place of steady states where a file has no histories.
inline constexpr const char* no_histories =
    "Steady state: the file has no load histories (/history/surge_load), so nothing is known of it.\n";

/// A heading, a line a case, and what the columns mean.
std::string steady_table(const Summary& summary, const SteadyReport& steady, int width);
/// A header line and one line a member.
std::string steady_csv(const Summary& summary, const CampaignTable& table, const SteadyReport& steady);

}  // namespace floes
