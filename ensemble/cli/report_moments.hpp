#pragma once
// Pictures of the worst moments of a campaign for its report: members computed again, side by side on all cores.

#include <filesystem>

#include "page/page.hpp"

namespace floes {

/// Fills data.moments; `all`: of each case, else of the campaign. Costs as much as the members did.
void add_moments(const std::filesystem::path& file, bool all, ReportData& data);

}  // namespace floes
