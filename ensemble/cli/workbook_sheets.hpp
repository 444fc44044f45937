#pragma once
// The sheets of a workbook that floes summarize makes of a campaign.

#include <string>
#include <vector>

#include "findings/evidence.hpp"
#include "tables/workbook.hpp"

namespace floes {

/// `parts`: names of findings; empty: cases, members, pairs, and the points of a design. The first sheet says what the
/// others hold.
std::vector<Sheet> workbook_sheets(Evidence& evidence, const std::vector<std::string>& parts);

}  // namespace floes
