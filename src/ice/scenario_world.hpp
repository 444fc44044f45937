#pragma once
// The world that a scenario asks for, still empty: a tow and a laboratory test begin from the same one.

#include "scenario/scenario.hpp"
#include "world/world.hpp"

namespace floes {

/// Time step, iterations, solver, gravity and contacts as the scenario says. Throws InputError for what World refuses.
World scenario_world(const Scenario& scenario);

}  // namespace floes
