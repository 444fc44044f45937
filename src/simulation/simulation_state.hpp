#pragma once
// Where a tow is: enough to go on from there.

#include <vector>

#include "ice/failure_mode.hpp"
#include "world/state.hpp"

namespace floes {

struct SimulationState {
    int steps = 0;                    ///< completed
    std::vector<BodyState> elements;  ///< at their end, in the order of IceField::elements()
    std::vector<BreakEvent> breaks;   ///< so far, by time
};

}  // namespace floes
