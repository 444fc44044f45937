#pragma once
// A tow through a field without end.

#include "support/jam_scenario.hpp"

namespace floes {

/// Of so many seconds at a third of a metre a second, with a window of a few floes: floes come and leave soon.
inline Scenario endless_scenario(double seconds, SolverKind solver = SolverKind::lanes) {
    Scenario scenario = jam_scenario();
    scenario.general.solver = solver;
    if (solver == SolverKind::direct) scenario.joint.model = JointModel::beam;
    scenario.arrangement.method = ArrangementMethod::scattered;
    scenario.field.far_end = FarEnd::never;
    scenario.field.ahead = 2.4;
    scenario.field.behind = 1.6;
    scenario.structure.speed = 0.3;
    scenario.analysis.window = seconds - scenario.analysis.steady_start;
    return scenario;
}

}  // namespace floes
