#pragma once
// Segment maxima of each case: fits, return levels, exceedance.

#include <cstddef>
#include <vector>

#include "campaign_file/campaign_file.hpp"
#include "inference/return_levels.hpp"

namespace floes {

/// One case over the segment maxima of all its done members.
struct CaseExtremes {
    std::size_t case_index = 0;
    double segment = 0;  ///< length of a segment, s
    std::size_t maxima = 0;
    FittedExtreme gumbel;
    FittedExtreme gev;
    std::vector<ExceedancePoint> exceedance;
};

/// One segment in so many exceeds the return levels that are told.
inline constexpr double return_periods[]{10, 100, 1000};

/// Every case in the order of the file; fits invalid where there are fewer than `fewest_maxima`.
std::vector<CaseExtremes> find_extremes(const CampaignTable& table);

}  // namespace floes
