#pragma once
// How a structure on moorings that give way moved in the analysis window, and what held it.

#include "scenario/scenario.hpp"
#include "simulation/record.hpp"
#include "statistics/oscillator.hpp"

namespace floes {

/// All but its lines, whose tensions are of the whole run. `motion`: of every step of the run.
MooredResponse moored_response(const Scenario& scenario, const MotionHistory& motion);

}  // namespace floes
