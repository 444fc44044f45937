#pragma once
// A campaign on one screen: what is wrong with it, a row for each case, and what comes next. The whole is in the other
// findings.

#include <string>

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// Warnings and the table: of structures that give way that of page one, which reads the file; of others the loads.
/// Differences are to the evidence's reference, otherwise to the first case; a design has none.
Section overview_section(Evidence& evidence);

/// The file and the commands for it, `program` as people call it.
Section next_commands(const Evidence& evidence, const std::string& program);

}  // namespace floes
