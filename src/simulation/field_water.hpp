#pragma once
// The models of the water of all elements, and which element has which.

#include <vector>

#include "ice/ice_field.hpp"
#include "scenario/floes.hpp"
#include "scenario/scenario.hpp"
#include "water/water_lanes.hpp"

namespace floes {

/// One model for all squares of the same size and density, and one for each polygon. floes: those at the places of the
/// ice.
WaterLanes make_water(const Scenario& scenario, const FloeSet& floes, const IceField& ice);

}  // namespace floes
