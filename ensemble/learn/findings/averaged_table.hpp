#pragma once
// Loads with the time that they are averaged over, for a page.

#include "findings/summary.hpp"

namespace floes {

/// A line for each case and averaging time; no line but the heading where nothing was averaged.
Table averaged_table(const Summary& summary);

}  // namespace floes
