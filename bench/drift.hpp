#pragma once
// Floes of any number and size on a square lattice, each drifting its own way: cost against size.

#include "simulation/simulation.hpp"

namespace floes::bench {

struct Drift {
    int floes = 189;
    int elements_along = 3;  ///< elements of 0.2 m along each side of a floe
    double concentration = 0.75;
    double speed = 0.3;                     ///< m/s
    SolverKind solver = SolverKind::lanes;  ///< direct: with beam joints and the physical laws of contact
    bool hexagons = false;                  ///< regular ones of the same area; concentration at most 0.6
};

Simulation make_drift(const Drift& drift);

}  // namespace floes::bench
