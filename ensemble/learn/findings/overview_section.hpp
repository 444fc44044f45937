#pragma once
// A campaign on one screen: what is wrong with it, a row for each case, and what comes next. The whole is in the other
// findings.

#include <string>
#include <vector>

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// Cases that are shown one by one; of a design with more of them, its axes and its extreme points are.
inline constexpr std::size_t most_overview_rows = 12;

/// Warnings and the table. Differences are to the evidence's reference, otherwise to the first case; a design has none.
Section overview_section(const Evidence& evidence, const Sensitivity& sensitivity);

/// The file and the commands for it, `program` as people call it.
Section next_commands(const Evidence& evidence, const std::string& program);

}  // namespace floes
