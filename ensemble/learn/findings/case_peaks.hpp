#pragma once
// The averaged loads of a case's members, as tails are fitted to them.

#include <cstddef>
#include <vector>

#include "campaign_file/campaign_table.hpp"
#include "inference/design_load.hpp"

namespace floes {

struct CasePeaks {
    std::vector<PeakRow> rows;
    std::vector<int> arrangements;  ///< of the rows, in their order
    std::vector<int> members;       ///< the same
    Measured measured;
};

/// Of the done members that averaged their load over `time`, s.
CasePeaks case_peaks(const CampaignTable& table, std::size_t of_case, double time);

}  // namespace floes
