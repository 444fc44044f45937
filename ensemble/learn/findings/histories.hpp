#pragma once
// The load over time of one arrangement in every case: the paper's Fig. 6.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// Of the first arrangement that every case has done, thinned to what a figure can show. Reads the file.
Section histories_section(Evidence& evidence);

}  // namespace floes
