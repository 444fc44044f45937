#pragma once
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

namespace floes {

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

  private:
    CohesiveLaw law_;
    double sound_ = 1;
    double energy_ = 0;
    bool open_ = false;
};

}  // namespace floes
