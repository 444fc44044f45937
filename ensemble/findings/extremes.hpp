#pragma once
// Segment maxima of each case: fits, return levels, exceedance.

#include <cstddef>
#include <vector>

#include "findings/summary.hpp"
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

Section extremes_section(const Summary& summary, const std::vector<CaseExtremes>& extremes);

/// The empirical curve of the maxima beside both fits: CSV of its own, in JSON a part of the extremes. No table: it is
/// too long for people.
Section exceedance_section(const Summary& summary, const std::vector<CaseExtremes>& extremes);

/// A line for each case and fit, for a page; without lines where nothing could be fitted.
Table extremes_page_table(const Summary& summary, const std::vector<CaseExtremes>& extremes);

/// "Gumbel" or "GEV".
const char* name_of(ExtremeKind kind);

}  // namespace floes
