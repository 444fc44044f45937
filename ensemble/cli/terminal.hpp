#pragma once
// Standard output: how much room it has, and what is written there.

#include <string>
#include <vector>

#include "tables/section.hpp"

namespace floes {

/// Characters on a line of standard output: the terminal's; elsewhere of the environment's COLUMNS, or 100. Never
/// below 40.
int terminal_width();

/// The sections in that format: "table", "json" or "csv".
std::string written(const std::vector<Section>& sections, const std::string& format);

}  // namespace floes
