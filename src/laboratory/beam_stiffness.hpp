#pragma once
// A cantilever of beam joints beside the closed form: how far it bends under a load, and how it swings when let go.

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

}  // namespace floes
