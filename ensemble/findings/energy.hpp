#pragma once
// Where the work of the tow goes: the mean load as a sum of what ice, water and structure do with it.

#include "findings/evidence.hpp"

namespace floes {

/// Each share of the load over a case's arrangements: its work over the distance towed, N. By case, in the order of the
/// list of quantities; cases whose members did not measure it have none.
Results find_energy(const Sample& sample, const Summary& summary);

Section energy_section(Evidence& evidence);

}  // namespace floes
