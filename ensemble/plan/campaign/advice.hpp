#pragma once
// What is allowed but not advisable.

#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// Sentences, one for each case, up to a dozen, that goes against the paper's advice: elements no smaller than the
/// characteristic length l_c = (E T³ / (12 (1 - ν²) ρ_w g))^(1/4) of the ice, within which it bends and breaks, with ν
/// = 0.3.
std::vector<std::string> advice(const Campaign& campaign);

}  // namespace floes
