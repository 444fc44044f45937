#pragma once
// The empty world of a scenario, the common start of a tow and of a laboratory test.

#include "scenario/scenario.hpp"
#include "world/world.hpp"

namespace floes {

/// Time step, iterations, solver, gravity and contacts are those of the scenario. Throws InputError for values that
/// World refuses.
World scenario_world(const Scenario& scenario);

}  // namespace floes
