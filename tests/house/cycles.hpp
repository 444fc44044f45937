#pragma once
// Cycles between files. The .hpp and the .cpp of one stem are one unit: "driver/master".

#include <set>
#include <string>
#include <vector>

#include "house/includes.hpp"

namespace floes::house {

/// Units that are known to include each other.
using Knot = std::set<std::string>;

/// A sentence for each cycle of units that include each other, the units in order: the shortest cycles through each
/// unit, each once. Includes between two units of a known knot do not count.
std::vector<std::string> cycles_of(const std::vector<Source>& sources, const std::vector<Knot>& known);

}  // namespace floes::house
