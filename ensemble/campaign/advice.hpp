#pragma once
// What is allowed but odd.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// Fewest natural periods of a hull that gives way in a window: with fewer, its largest offset is one swing, and it has
/// no design value.
inline constexpr double fewest_periods = 3;

/// A sentence for each oddity, which quotes the case that has it most and names or counts the others:
/// elements no smaller than the characteristic length l_c = (E T³ / (12 (1 - ν²) ρ_w g))^(1/4) of the ice, within which
/// it bends and breaks (the paper's advice, with ν = 0.3); elements thicker than wide; hardly any ice; a strength that
/// no ice has; ice that crushes more easily than it bends; few sweeps; long steps; a gap between structure and bank of
/// less than two floes; a structure that is hardly heavier than a floe; one that weighs more or less than the water
/// that it displaces; a window that begins before the hull meets the ice; and one of less than `fewest_periods`.
std::vector<std::string> advice(const Campaign& campaign);

}  // namespace floes
