#pragma once
// Keeps E and Σ of joints that follow Σ together: measures the E of a stated Σ, and whether a stated pair agrees.

#include "campaign/campaign.hpp"
#include "driver/progress.hpp"

namespace floes {

/// Gives cases of Pairing::find_modulus the E that a plate test shows, to three figures, and compares it with the E of
/// cases of Pairing::check; both are settled then. One test, of a second or so, for each distinct ice, `threads` at a
/// time. Deterministic. Throws InputError naming the case if E and Σ differ by more than 5 %, or if the E of a stated Σ
/// cannot be measured.
void settle_moduli(Campaign& campaign, int threads, Progress& progress);

}  // namespace floes
