#pragma once
// Whether every case measures the quantity of the stop rule.

#include <optional>
#include <string>

#include "campaign/campaign.hpp"

namespace floes {

/// The sentence that says what is wrong with stop.of; none if every case measures that quantity.
std::optional<std::string> stop_quantity_fault(const Campaign& campaign);

}  // namespace floes
