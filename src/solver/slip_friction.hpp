#pragma once
// How a coefficient of friction depends on the speed of sliding, docs/convergence.md#friction-and-speed.

#include "solver/contact_law.hpp"

namespace floes {

/// The law of one kind of surfaces, with its coefficient.
struct SlipLaw {
    SlipEffect effect = SlipEffect::constant;
    double coefficient = 0;  ///< of surfaces that slide steadily at the speed of the parameters
    double exponent = 0;
};

SlipLaw slip_law(const ContactLaw& law, bool at_structure);

/// Coefficient of friction of surfaces that slide at `slip`, m/s, and remember `remembered`, m/s. Steady sliding
/// remembers its own speed. 0 where the law's coefficient is 0.
double friction_coefficient(const SlipLaw& law, const SlipFriction& parameters, double slip, double remembered);

/// What a contact that slid at `slip` for the time dt, s, remembers of it and of what it remembered before, m/s. Below
/// 0: it is new, and remembers this speed only.
double remembered_slip(const SlipFriction& parameters, double slip, double remembered, double dt);

}  // namespace floes
