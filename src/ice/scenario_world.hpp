#pragma once
// The empty world of a scenario, the common start of a tow and of a laboratory test.

#include "scenario/scenario.hpp"
#include "world/world.hpp"

namespace floes {

/// Thickness of the scenario's ice over that of the paper's tank, 0.033 m: the scale of lengths that have no key.
double size_of_ice(const Scenario& scenario);

/// Time step, iterations, solver, gravity and contacts are those of the scenario; the unit of length is the size of its
/// ice, so that Bullet's margins keep their share of the thickness. Throws InputError for values that World refuses.
World scenario_world(const Scenario& scenario);

}  // namespace floes
