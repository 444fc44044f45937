#pragma once
// The design loads of a campaign as output.

#include <vector>

#include "findings/design_load.hpp"
#include "tables/section.hpp"

namespace floes {

/// The loads, what they rest on, and the differences between cases with the same arrangements.
std::vector<Section> design_load_sections(const Summary& summary, const std::vector<CaseDesignLoad>& designs,
                                          const DesignLoadRequest& request);

}  // namespace floes
