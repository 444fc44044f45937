#pragma once
// Load levels as text.

#include <string>
#include <vector>

#include "findings/levels.hpp"
#include "findings/summary.hpp"

namespace floes {

/// A heading, a line a level, and what the columns mean.
std::string levels_table(const Summary& summary, const std::vector<LevelRow>& rows, int width);
/// A header line and one line a level.
std::string levels_csv(const Summary& summary, const std::vector<LevelRow>& rows);

}  // namespace floes
