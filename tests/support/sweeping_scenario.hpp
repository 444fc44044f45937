#pragma once
// Sweeps over joints that follow Σ, with contacts that are physics: the tank of table3_physical.toml.

#include "scenario/keys.hpp"
#include "scenario/scenario.hpp"

namespace floes {

inline Scenario sweeping_scenario() {
    Scenario scenario = paper_scenario();
    scenario.contact = with_preset(scenario.contact, ContactPreset::physical);
    return scenario;
}

}  // namespace floes
