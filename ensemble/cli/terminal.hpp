#pragma once
// Standard output: how much room it has, and what is written there.

#include <string>
#include <vector>

#include "tables/section.hpp"

namespace floes {

/// Characters on a line of standard output: those of the terminal; elsewhere COLUMNS of the environment, or 100. At
/// least 40.
int terminal_width();

/// The sections in that format: "table", "json" or "csv".
std::string written(const std::vector<Section>& sections, const std::string& format);

}  // namespace floes
