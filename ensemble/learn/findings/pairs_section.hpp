#pragma once
// The section on pairs of cases.

#include <string>
#include <vector>

#include "findings/pairs.hpp"

namespace floes {

/// A sentence on the pairs that could not be compared; empty when there are none.
std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options = {});

/// What a campaign of many cases shows instead of its pairs and extremes: how many pairs, and the command that shows
/// them.
std::string unasked_text(const Summary& summary);

/// The table has the headline quantities; a page and the records have all.
Section pairs_section(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options);

}  // namespace floes
