#pragma once
// The scenes that benchmarks step: the default channel with 189 floes, with the ice at rest and packed.

#include <string>
#include <string_view>

#include "arrangement/arrangement.hpp"
#include "scenario/keys.hpp"
#include "scenario/scenario.hpp"
#include "simulation/simulation.hpp"

namespace floes::bench {

/// The structure's wall: straight at 45 degrees, or at 75.4 degrees below the waterline as in the default scenario.
/// Both are written out in scene.cpp, since stored states belong to them.
enum class Wall { straight, steep };

/// "straight" or "steep"; throws InputError for another name.
Wall wall_named(std::string_view name);

/// Sweeps over contacts that an ensemble needs of the direct solver: docs/convergence.md.
inline constexpr int direct_iterations = 20;

/// The solver, and for the direct one beam joints, its iterations and its tolerance.
void choose_solver(Scenario& scenario, SolverKind solver);

/// The default scenario, but with the given wall and the structure 0.2 m before the ice: a tow that needs no run-up.
Scenario tow_scenario(SolverKind solver, Wall wall);

/// A tow at some time, with the poses that its floes began from.
struct Scene {
    Wall wall = Wall::straight;
    std::vector<PlanarPose> poses;
    SimulationState state;
};

/// Text with one record a line. Positions to 1 nm and velocities to 7 digits: a state of its own, near that of the run.
std::string write_scene(const Scene& scene);
Scene read_scene(Wall wall, const std::string& text);

/// bench/late_state.csv and bench/late_state_steep.csv, see late_state.cpp.
Scene late_scene();
Scene late_steep_scene();
Scene early_scene();  ///< the floes of late_scene at t = 0, at rest

}  // namespace floes::bench
