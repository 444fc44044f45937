#pragma once
// The scenes that benchmarks step: the default channel with 189 floes, with the ice at rest and packed.

#include <string>

#include "arrangement/arrangement.hpp"
#include "scenario/keys.hpp"
#include "scenario/scenario.hpp"
#include "simulation/simulation.hpp"

namespace floes::bench {

/// The paper's squares, with a straight wall of 45 degrees and the structure 0.2 m before the ice: a tow that needs no
/// run-up. With the direct solver its joints and contacts are those of the default, else the paper's, which Bullet's
/// own solver has, too.
Scenario tow_scenario(SolverKind solver);

/// A tow at some time, with the poses that its floes began from.
struct Scene {
    std::vector<PlanarPose> poses;
    SimulationState state;
};

/// Text with one record a line. Positions to 1 nm and velocities to 7 digits: a state of its own, near that of the run.
std::string write_scene(const Scene& scene);
Scene read_scene(const std::string& text);

Scene late_scene();   ///< bench/late_state.csv, see late_state.cpp
Scene early_scene();  ///< the floes of late_scene at t = 0, at rest

}  // namespace floes::bench
