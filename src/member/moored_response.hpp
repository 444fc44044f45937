#pragma once
// How a structure on moorings that give way moved in the analysis window, and what held it.

#include <span>
#include <vector>

#include "scenario/scenario.hpp"
#include "simulation/record.hpp"
#include "statistics/oscillator.hpp"

namespace floes {

/// What a history of every step of a run has of the window.
inline std::span<const double> in_window(const Scenario& scenario, const std::vector<double>& history) {
    return std::span(history).subspan(static_cast<std::size_t>(scenario.first_window_step()));
}

/// All but its lines, whose tensions are of the whole run. `motion`: of every step of the run.
MooredResponse moored_response(const Scenario& scenario, const MotionHistory& motion);

}  // namespace floes
