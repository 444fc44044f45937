#pragma once
// Failed joints over time, by mode.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// "bending", "in-plane bending"; `mode` as in BreakRow.
std::string mode_name(int mode);

/// Mean over arrangements of each case; only modes in which some joint failed.
Section failures_section(Evidence& evidence);

}  // namespace floes
