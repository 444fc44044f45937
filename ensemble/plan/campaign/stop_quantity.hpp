#pragma once
// Whether every case measures what the stop rule looks at.

#include <optional>
#include <string>

#include "campaign/campaign.hpp"

namespace floes {

/// What is wrong with stop.of in a sentence's words; none where a stop rule may look at it in every case.
std::optional<std::string> stop_quantity_fault(const Campaign& campaign);

}  // namespace floes
