#pragma once
// Pairs of cases, as they are told.

#include <string>
#include <vector>

#include "findings/pairs.hpp"

namespace floes {

/// A sentence on the pairs that could not be compared; empty when there are none.
std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows);

/// What a campaign of many cases says in place of its pairs and extremes: how many, and what to type.
std::string unasked_text(const Summary& summary);

/// The quantities of the headlines in the table, all in the records.
Section pairs_section(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options);

/// A line for each quantity and pair, for a page, which has room for all.
Table pairs_page_table(const Summary& summary, const std::vector<PairRow>& rows);

}  // namespace floes
