#pragma once
// How many simulations of what: structure and ice, to scale.

#include "findings/evidence.hpp"
#include "tables/section.hpp"

namespace floes {

/// In sentences and figures, without a table.
Section what_was_run(Evidence& evidence);

}  // namespace floes
