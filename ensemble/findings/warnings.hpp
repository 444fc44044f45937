#pragma once
// What is wrong with a campaign as a whole, said before its figures.

#include <string>
#include <vector>

#include "findings/summary.hpp"

namespace floes {

/// Sentences, the worst first; none for a campaign that nothing is wrong with. `summary`: of the table.
std::vector<std::string> warnings_of(const CampaignTable& table, const Summary& summary);

/// A line for each.
std::string warning_lines(const std::vector<std::string>& warnings);

}  // namespace floes
