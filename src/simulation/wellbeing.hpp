#pragma once
// Is a run still a simulation of floating ice? Elements that explode, leave the channel, fly or sink say it is not;
// then the member fails with a reason and gives no numbers.

#include <optional>
#include <string>

#include "scenario/scenario.hpp"
#include "simulation/channel.hpp"
#include "world/state.hpp"

namespace floes {

/// Where and how fast an element may be. m, m/s.
struct Wellbeing {
    double speed = 0;       ///< largest |velocity| of the centre of mass
    double begin = 0;       ///< least x: the channel's room before the wall sheets
    double end = 0;         ///< largest x: as far past them
    double outer_edge = 0;  ///< largest |z|: the outer edge of a wall sheet
    double top = 0;         ///< largest height: the same above the water
    double bottom = 0;      ///< least height: the same below the structure

    Wellbeing(const Scenario& scenario, const Channel& channel);

    /// What is wrong with an element in this state ("has run away at 12 m/s ..."); nothing if it is well. NaN is not
    /// well.
    std::optional<std::string> trouble(const BodyState& state) const;
};

}  // namespace floes
