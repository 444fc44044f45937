#pragma once
// How joints fail, the largest reactions that they carried, and what floes fell into.

#include <array>
#include <cstdint>

namespace floes {

enum class FailureMode : std::int8_t {
    bending = 0,
    shear = 1,
    compression = 2,
    tension = 3,
    torsion = 4,
    in_plane_bending = 5
};

inline constexpr std::array<const char*, 6> failure_mode_names{"bending", "shear",   "compression",
                                                               "tension", "torsion", "in_plane_bending"};

/// One failed joint.
struct BreakEvent {
    double time = 0;                          ///< end of the step in which it failed, s
    std::int32_t floe = 0;                    ///< index of the floe in the arrangement
    std::int32_t joint = 0;                   ///< index of the joint within its floe, in creation order
    FailureMode mode = FailureMode::bending;  ///< the largest λ/ε
    friend bool operator==(const BreakEvent&, const BreakEvent&) = default;
};

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

/// A piece of a floe that cracked through, at the end of a run.
struct PieceArea {
    int floe = 0;     ///< its number in the order of entry: its index in the arrangement, if the field has an end
    double area = 0;  ///< of the upper side, m²
};

}  // namespace floes
