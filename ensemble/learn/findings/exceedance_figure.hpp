#pragma once
// The maxima of the segments and the distributions fitted to them. For this room only.

#include <vector>

#include "findings/extremes.hpp"
#include "tables/figure.hpp"

namespace floes {

Figure exceedance_figure(const Summary& summary, const std::vector<CaseExtremes>& extremes);

}  // namespace floes
