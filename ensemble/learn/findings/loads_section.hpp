#pragma once
// The loads of every case as the report shows them first: averaged, and as in Table 3.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// A line for each case and averaging time; no line but the heading where nothing was averaged.
Table averaged_table(const Summary& summary);

/// The table with its meaning; empty where nothing was averaged.
Section averaged_section(Evidence& evidence);

/// Table 3 beside the paper's figures, and every arrangement with the mean of its case.
Section table3_section(Evidence& evidence);

}  // namespace floes
