#pragma once
// Paired comparisons as text.

#include <string>
#include <vector>

#include "findings/pairs.hpp"

namespace floes {

/// A heading, the pairs by quantity, and what the columns mean.
std::string pairs_table(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options,
                        int width);

/// A sentence on the pairs of cases that are not compared, and why; empty where all are.
std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows);

/// The sentence in the place of pairs and extremes that are not shown unasked (in_detail()).
std::string unasked_text(const Summary& summary);

/// A header line and one line a quantity and pair; empty where undefined.
std::string pairs_csv(const Summary& summary, const std::vector<PairRow>& rows);

}  // namespace floes
