#pragma once
// The checks behind validate.hpp. Each adds the contradictions that it finds.

#include <vector>

#include "scenario/validate.hpp"

namespace floes {

using Contradictions = std::vector<Contradiction>;

void check_elements(const Scenario& scenario, Contradictions& found);  ///< floes are whole elements, not too many
void check_floating(const Scenario& scenario, Contradictions& found);  ///< the ice floats, heave is stable
void check_time(const Scenario& scenario, Contradictions& found);      ///< whole steps, segments, history values
void check_levels(const Scenario& scenario, Contradictions& found);    ///< load levels rise
void check_shape(const Scenario& scenario, Contradictions& found);     ///< a body that stands in the water
void check_tow(const Scenario& scenario, Contradictions& found);       ///< it meets the ice and stays in it
void check_wake(const Scenario& scenario, Contradictions& found);      ///< the structure strikes no resting floe
void check_lattice(const Scenario& scenario, Contradictions& found);   ///< the floes fit
void check_poses(const Scenario& scenario, Contradictions& found);     ///< given poses belong to the field

}  // namespace floes
