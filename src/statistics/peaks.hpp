#pragma once
// Peaks of a load that count once each, however ragged they are.

#include <cstddef>
#include <span>
#include <vector>

namespace floes {

/// Declustered peaks, falling: the highest local maximum, then the highest of those at least `apart` places from it,
/// and so on, down to those above `least`. So the peaks above any higher level are the declustered peaks of that level.
/// The ends count as local maxima where the values rise towards them. `apart`: at least 1.
std::vector<double> declustered_peaks(std::span<const double> values, std::size_t apart, double least);

}  // namespace floes
