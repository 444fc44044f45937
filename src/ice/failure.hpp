#pragma once
// When a joint fails: Eqs. (1)-(3) of the paper. A joint fails when a part of its reaction λ exceeds its threshold ε.
//
//   compression  λ_c = max(0, -axial)                            ε_c = L_e T_e σ_c        (1)
//   shear        λ_s = |(shear_vertical, shear_in_plane)|        ε_s = L_e T_e σ_s        (2)
//   bending      λ_b = |bending + a shear_vertical|              ε_b = L_e T_e² σ_b / 6   (3)
//
// The paper prints (1) and (2) with T_e², which makes a moment of a force;
// ThresholdForm::as_printed compares these numbers as they stand. The arm a is 0, or L_e / 2 for the moment about the
// centre of element a, joint.moment_about. The paper has no criterion for the other parts. If a strength is given, they
// are
//
//   tension           λ = max(0, axial)       ε = L_e T_e σ_t
//   torsion           λ = |torsion|           ε = L_e T_e² τ / 3   thin rectangle, L_e >> T_e (Timoshenko and Goodier,
//                                                                  Theory of Elasticity, art. 109; 10 % high at 6:1)
//   in-plane bending  λ = |in_plane_bending|  ε = T_e L_e² σ / 6

#include <optional>

#include "ice/failure_mode.hpp"
#include "scenario/scenario.hpp"
#include "world/state.hpp"

namespace floes {

/// ε of each mode, N or N m; infinite where there is no criterion.
struct Thresholds {
    double bending;
    double shear;
    double compression;
    double tension;
    double torsion;
    double in_plane_bending;
    double bending_arm = 0;  ///< a, m
};

/// The thresholds of a floe: its strengths, element size, thickness and form of Eqs. (1)-(2).
Thresholds make_thresholds(const FloeShape& shape, const Material& material);

/// The same of a joint of another width than an element's and another span between centres, m.
Thresholds make_thresholds(double width, double span, double thickness, const Material& material);

/// The largest λ/ε of a joint with this reaction: 0 unloaded, above 1 it fails.
double utilisation(const JointReaction& reaction, const Thresholds& thresholds);

/// The mode in which a joint with this reaction fails: the one with the largest λ/ε, if that exceeds 1. Among equals,
/// the first in the order of FailureMode.
std::optional<FailureMode> failure(const JointReaction& reaction, const Thresholds& thresholds);

/// What is left of a reaction where bending is looked at by other means.
JointReaction without_bending(const JointReaction& reaction);

/// The peaks updated with this reaction of a joint.
PeakReactions raised(const PeakReactions& peaks, const JointReaction& reaction);

}  // namespace floes
