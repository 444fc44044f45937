#pragma once
// The largest joint reactions of a run.

namespace floes {

/// Largest value over the run of each part of the joint reactions, over all joints (N, N m); magnitudes.
struct PeakReactions {
    double compression = 0;
    double tension = 0;
    double shear = 0;
    double bending = 0;
    double torsion = 0;
    double in_plane_bending = 0;
    friend bool operator==(const PeakReactions&, const PeakReactions&) = default;
};

}  // namespace floes
