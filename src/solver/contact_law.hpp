#pragma once
// How bodies that touch act on each other, as one value. It goes whole from the keys of a scenario to the kernels and
// to Bullet, so a new parameter is a field here, its key, and what the solvers do with it.

namespace floes {

/// Direction and bound of friction, docs/convergence.md.
enum class Friction {
    one_direction,  ///< one row a contact along the sliding velocity, Bullet's default: nothing acts across it
    cone            ///< in the whole contact plane, |impulse| <= f * impulse of the normal; not in the stock solver
};

/// What bounds the normal impulse, docs/convergence.md.
enum class NormalLaw {
    rigid,    ///< nothing: it ends the approach within the step, and opens a penetration by erp
    crushing  ///< edges that crush at a pressure: overlap stays and does not push back; not in the stock solver
};

/// What the speed of sliding does to a coefficient of friction, docs/convergence.md.
enum class SlipEffect {
    constant,       ///< nothing
    power,          ///< a power of the speed
    rate_and_state  ///< the logarithms of the speed, and of the speed that the contact remembers
};

/// Of the coefficients of a contact law, which then hold for surfaces that slide steadily at `speed`.
struct SlipFriction {
    SlipEffect ice_ice = SlipEffect::constant;
    SlipEffect ice_structure = SlipEffect::constant;
    double ice_ice_exponent = 0.35;        ///< n of the power law, 0-2
    double ice_structure_exponent = 0.28;  ///< likewise
    double speed = 0.1;                    ///< V, m/s, above 0
    double direct = 0.31;                  ///< A of rate and state, 0-10: what a change of speed does at once
    double evolution = 0.382;              ///< B, 0-10: what the remembered speed does
    double memory = 10;                    ///< T, s, above 0: in which a contact forgets how fast it slid
    double least = 0.05;                   ///< bounds of every coefficient that is above 0
    double largest = 1;                    ///< up to 10, not below `least`
    double slowest = 1e-5;  ///< slower than this nothing slides, m/s: the slowest of the tests that the laws come from

    friend bool operator==(const SlipFriction&, const SlipFriction&) = default;
};

/// Restitution is 0 (Table 1). World refuses what is out of the ranges given here.
struct ContactLaw {
    double erp = 0.2;               ///< Γ, share of a penetration pushed out each step, 0-1
    double ice_ice_friction = 0.3;  ///< f_ii, Coulomb's coefficient between floes and on fixed ice, 0-10 (Table 1)
    double ice_structure_friction = 0.2;  ///< f_is, of ice on the structure, 0-10 (Table 1)
    SlipFriction slip{};                  ///< not in the stock solver
    bool split_impulse = true;            ///< correct penetrations deeper than split_impulse_depth outside the impulse
    double split_impulse_depth = 0.04;    ///< m, >= 0
    Friction friction = Friction::one_direction;
    NormalLaw normal = NormalLaw::rigid;  ///< crushing leaves erp and split impulse without effect
    double crushing_pressure = 0;         ///< p, Pa, above 0 with crushing
    bool internal_edges = true;           ///< faces and rims inside a body act like its outside, as in Bullet

    friend bool operator==(const ContactLaw&, const ContactLaw&) = default;
};

}  // namespace floes
