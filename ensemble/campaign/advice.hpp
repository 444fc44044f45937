#pragma once
// What laws of sizes and of the ice come to once floes are whole elements and whole numbers.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// A sentence or two for each case whose floes differ: how many, their sizes, shares of the area, elements and field,
/// and mean and standard deviation of what is drawn in arrangement 0. A case with the words of an earlier one has none.
std::vector<std::string> floe_words(const Campaign& campaign);

// What is allowed but odd.

/// A sentence for each oddity, which names the first case that has it and counts the others:
/// elements no smaller than the characteristic length l_c = (E T³ / (12 (1 - ν²) ρ_w g))^(1/4) of the ice, within which
/// it bends and breaks (the paper's advice, with ν = 0.3); elements thicker than wide; hardly any ice; a strength that
/// no ice has; ice that crushes more easily than it bends; few sweeps; long steps; a gap between structure and bank of
/// less than two floes; and a structure that is hardly heavier than a floe.
std::vector<std::string> advice(const Campaign& campaign);

}  // namespace floes
