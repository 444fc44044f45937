#pragma once
// The width of standard output, and results as text for it.

#include <string>
#include <vector>

#include "tables/section.hpp"

namespace floes {

/// Characters on a line of standard output: of the terminal, otherwise the environment's COLUMNS, otherwise 100; at
/// least 40.
int terminal_width();

/// The sections in that format: "table", "json" or "csv".
std::string written(const std::vector<Section>& sections, const std::string& format);

}  // namespace floes
