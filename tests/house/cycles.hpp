#pragma once
// Cycles between files. The .hpp and the .cpp of one stem are one unit: "driver/master".

#include <set>
#include <string>
#include <vector>

#include "house/includes.hpp"

namespace floes::house {

/// A sentence for each cycle of units that include each other, the units in order: the shortest cycles through each
/// unit, each once.
std::vector<std::string> cycles_of(const std::vector<Source>& sources);

}  // namespace floes::house
