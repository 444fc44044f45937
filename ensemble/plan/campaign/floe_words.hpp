#pragma once
// What laws of sizes and of the ice come to once floes are whole elements and whole numbers.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// A sentence or two for each case whose floes differ: how many, their sizes, shares of the area, elements and field,
/// and mean and standard deviation of what is drawn in arrangement 0. A case with the words of an earlier one has none.
std::vector<std::string> floe_words(const Campaign& campaign);

}  // namespace floes
