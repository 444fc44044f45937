#pragma once
// The campaign beside closed formulas: the hybrid model (the paper's Fig. 8) and plate tests of its ice (Fig. 2).

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// Of the first case; without the hybrid model where Lindqvist's formula does not apply to its wall, without plate
/// tests where none were made.
Section closed_formulas_section(Evidence& evidence);

}  // namespace floes
