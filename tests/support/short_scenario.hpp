#pragma once
// A run of two seconds in which the tow reaches the ice.

#include "support/sweeping_scenario.hpp"

namespace floes {

inline Scenario short_scenario() {
    Scenario scenario = sweeping_scenario();
    scenario.field.floes = 4;
    scenario.field.concentration = 0.4;
    scenario.field.begin = 2.0;
    scenario.field.half_width = 1.25;
    scenario.arrangement.sweeps = 50;
    scenario.structure.start = 1.38;
    scenario.structure.speed = 0.5;
    scenario.analysis.steady_start = 0.2;
    scenario.analysis.window = 2.0;
    return scenario;
}

}  // namespace floes
