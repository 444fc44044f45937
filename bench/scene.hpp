#pragma once
// The scenes that benchmarks step: the default channel with 189 floes, with the ice at rest and packed.

#include <string>

#include "arrangement/arrangement.hpp"
#include "scenario/scenario.hpp"
#include "simulation/simulation_state.hpp"

namespace floes::bench {

/// The default scenario, but with a straight wall of 45 degrees and the structure 0.2 m before the ice: a tow that needs
/// no run-up.
Scenario tow_scenario(SolverKind solver);

/// A tow at some time, with the arrangement that it began from.
struct Scene {
    Arrangement arrangement;
    SimulationState state;
};

/// Text with one record a line. Positions to 1 nm and velocities to 7 digits: a state of its own, near that of the run.
std::string write_scene(const Scene& scene);
Scene read_scene(const std::string& text);

/// bench/late_state.csv, see late_state.cpp.
Scene late_scene();
Scene early_scene();  ///< the same floes at t = 0, at rest

}  // namespace floes::bench
