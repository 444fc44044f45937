#pragma once
// The channel of configs/smoke.toml.

#include "scenario/scenario.hpp"

namespace floes {

/// The scenario with the floes, the channel, the structure and the tow of configs/smoke.toml.
inline Scenario in_smoke_channel(Scenario scenario) {
    scenario.field.floes = 24;
    scenario.field.begin = 2.0;
    scenario.field.half_width = 1.25;
    scenario.structure.shape = Shape({{-0.443, 0.43}, {0.0, 0.614}, {0.122, 0.736}});
    scenario.structure.start = 1.38;
    scenario.structure.speed = 0.1;
    return scenario;
}

}  // namespace floes
