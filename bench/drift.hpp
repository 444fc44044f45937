#pragma once
// Any number of floes on a square lattice, each drifting its own way: cost against size.

#include "simulation/simulation.hpp"

namespace floes::bench {

/// Of nine elements each, at a concentration of 75 %; as they are by default, or as in the paper.
Simulation make_drift(int floes, bool by_default);

}  // namespace floes::bench
