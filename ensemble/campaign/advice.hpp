#pragma once
// What is allowed but odd.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// A sentence for each oddity, which names the first case that has it and counts the others:
/// elements no smaller than the characteristic length l_c = (E T³ / (12 (1 - ν²) ρ_w g))^(1/4) of the ice, within which
/// it bends and breaks (the paper's advice, with ν = 0.3); elements thicker than wide; hardly any ice; a strength that
/// no ice has; ice that crushes more easily than it bends; few sweeps; long steps; a gap between structure and bank of
/// less than two floes; a structure that is hardly heavier than a floe; and one that weighs more or less than the water
/// that it displaces.
std::vector<std::string> advice(const Campaign& campaign);

}  // namespace floes
