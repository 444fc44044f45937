#pragma once
// A cantilever of beam joints beside the closed form: how far it bends under a load, and how it swings when let go.

#include "ice/failure_mode.hpp"
#include "scenario/scenario.hpp"

namespace floes {

/// Measured, and of an elastic strip of plate of the same length (theory/beam.hpp).
struct BeamStiffness {
    double deflection = 0;          ///< m, at the middle of the last element, which carries the load
    double elastic_deflection = 0;  ///< m
    double frequency = 0;           ///< 1/s, of the lowest mode
    double elastic_frequency = 0;   ///< 1/s
};

/// Dry and weightless, one element wide, clamped at the face of the first of `elements` elements. Uses ice, joint,
/// floe.element and iterations of the scenario. The swing is computed in steps of 1/400 of its period. Throws
/// InputError unless joints are of the model beam, and when the beam does not come to rest.
BeamStiffness measure_beam_stiffness(const Scenario& scenario, int elements);

// The cantilever test on numerical ice: a beam one element wide, clamped at one end, loaded at the other until a joint
// fails. Measures the strength of the beam. Also shears or crushes one element against the clamp.

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
