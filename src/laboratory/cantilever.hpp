#pragma once
// The cantilever test on numerical ice: a beam one element wide, clamped at one end, loaded at the other until a joint
// fails. Measures the strength of the beam. Also shears or crushes one element against the clamp.

#include "ice/failure_mode.hpp"
#include "scenario/scenario.hpp"

namespace floes {

enum class BeamLoad { bending, shear, compression };

struct BeamTest {
    BeamLoad load = BeamLoad::bending;
    int elements = 3;          ///< of the beam, at least 1; the load acts on the middle of the last one
    bool floating = false;     ///< on the scenario's water instead of dry and weightless
    double increment = 0.005;  ///< of the load, as a fraction of the load that the strength predicts
};

struct BeamStrength {
    FailureMode mode = FailureMode::bending;  ///< of the joint that failed first
    int joint = 0;                            ///< its index, from 0 at the clamp
    double length = 0;                        ///< m, from the load to that joint
    double load = 0;                          ///< N, at failure
    double strength =
        0;  ///< Pa, measured: bending 6 P L/(b h²), otherwise P/(b h), or P/(b h²) as Eqs. (1)-(2) are printed
    double set = 0;  ///< Pa, the scenario's strength of that kind
};

/// Raises the load in increments, each settled, until a joint fails. Uses general, ice, joint, floe.element of the
/// scenario (and water density when floating). Throws InputError when the test is not possible or nothing fails.
BeamStrength measure_beam_strength(const Scenario& scenario, const BeamTest& test);

}  // namespace floes
