#pragma once
// A run of six seconds in which much happens.

#include "support/sweeping_scenario.hpp"

namespace floes {

/// A small closed channel that the structure fills half: floes jam, bend and break within seconds.
inline Scenario jam_scenario() {
    Scenario scenario = sweeping_scenario();
    scenario.ice.bending_strength = 10e3;
    scenario.field.floes = 12;
    scenario.field.begin = 2.0;
    scenario.field.half_width = 1.25;
    scenario.arrangement.sweeps = 200;
    scenario.structure.start = 1.38;
    scenario.structure.speed = 0.1;
    scenario.analysis.steady_start = 1.0;
    scenario.analysis.window = 5.0;
    scenario.analysis.segments = 5;
    return scenario;
}

}  // namespace floes
