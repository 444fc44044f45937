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

// A joint that cracks: a cohesive hinge. At the strength the joint carries the moment M₀ at the rotation θ₀; from there
// the moment falls linearly and is 0 at θ_u, so that the crack takes the energy of its area whatever the elements are
// (crack band, Bažant and Oh 1983):
//
//   ½ M₀ θ_u = G_f L T,   θ_u = 2 G_f L T / M₀ = 12 G_f / (σ_b T) for M₀ = σ_b L T²/6
//
// M and θ are the norms of bending and torsion, for which a joint has the same stiffness K. Unloaded, the joint goes
// straight back to 0 with the stiffness that is left, sound · K. Where θ_u <= θ₀ the joint holds more energy than the
// crack takes (snap-back): it fails at its strength, and what is left over goes into motions smaller than an element,
// which the grid has not.

struct CohesiveLaw {
    double stiffness = 0;      ///< K, N m
    double peak_rotation = 0;  ///< θ₀
    double open_rotation = 0;  ///< θ_u

    bool snaps_back() const { return open_rotation <= peak_rotation; }

    /// M(θ) of a joint that was never turned further, N m; 0 from θ_u on.
    double moment(double rotation) const;

    /// Work from 0 to θ, N m.
    double work(double rotation) const;

    /// Mean of M from one rotation to a larger one, N m.
    double mean_moment(double from, double to) const;
};

/// By how much a joint at its peak, turned by `rotation`, exceeds what cracks it: 1 where it begins to. `strength`: of
/// the stress with what contacts add, over the strength; `smooth`: without that. The peak below a contact begins a
/// crack only if the ice gives the energy that an element's length of it takes (coupled criterion, Leguillon 2002):
/// three times the joint's own, ½ K θ², at the rim of a floe, where it turns three times as far when the joint is gone
/// (docs/figures/fracture.py; 1.7 times inside a sheet). A joint that is longer than its span holds less of what its
/// crack sets free: 1 + 2 length/span times its own. A smooth stress needs no such proof: the hinge that opens has it.
double cracking(double strength, double smooth, double stiffness, double rotation, double energy,
                double length_over_span = 1);

/// The law of a joint of stiffness K, N m, that reaches its strength at the rotation θ₀, for a crack that takes
/// `energy`, N m. Without rotation it never opens.
CohesiveLaw cohesive_law(double stiffness, double peak_rotation, double energy);

/// A joint on its way from its strength to a crack.
class Crack {
  public:
    explicit Crack(const CohesiveLaw& law) : law_(law) {}

    /// After a step that ended with this rotation and its rate, 1/s; Δt of the coming one, s. An implicit step knows
    /// one stiffness: the one chosen has the law's mean moment over the rotation that is expected by its end.
    void follow(double rotation, double rate, double time_step);

    bool is_open() const { return open_; }     ///< the joint carries nothing any more
    double sound() const { return sound_; }    ///< share of K in the coming step, 0-1
    double energy() const { return energy_; }  ///< taken so far, N m
    void archive(StateArchive& state);         ///< core/state_archive.hpp

  private:
    CohesiveLaw law_;
    double sound_ = 1;
    double energy_ = 0;
    bool open_ = false;
};

}  // namespace floes
