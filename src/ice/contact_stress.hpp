#pragma once
// What a grid of elements does not show of a load: the stress right below a contact. A joint's moment is a mean over
// the width of an element, but below a small contact the stress of a plate grows as the logarithm of the contact's size
// (theory/westergaard.hpp). The difference between the patch that a joint feels and the contact's own size b₀ is added:
//
//   Δσ = C log10(b_L / b₀),   C = stress per decade, at an edge or inside
//
// b_L is the radius of the circle below which the formula has the stress that the joint of the grid shows: a constant
// times the element's side, less the nearer the contact is to the joint (docs/figures/fracture.py computes it from the
// grid; docs/fracture.md). Near a second free edge, a corner, the logarithm ends at the distance to it.

#include <array>
#include <cstdint>

namespace floes {

/// A square element as a contact meets it. SI.
struct PressedElement {
    double side = 0;
    double thickness = 0;
    double poisson_ratio = 0;
    double crushing_pressure = 0;  ///< above 0: a force crushes a circle of this pressure
    std::uint8_t joined = 0;       ///< bits of Edge: faces with a live joint; the others are free
};

/// A contact force on an element, in the element's own axes.
struct Press {
    double x = 0;  ///< of the contact, from the middle of the element, m
    double z = 0;
    double down = 0;  ///< N, along -y
};

/// Of one direction, along x or z: the stress that the nearer joint in that direction does not see.
struct SideStress {
    double stress = 0;      ///< Pa, tension in the lower fibre positive
    std::uint8_t face = 0;  ///< bit of Edge: the face of that joint; 0: there is none
};

/// Along x and along z.
std::array<SideStress, 2> contact_stress(const PressedElement& element, const Press& press);

/// The most that a force of 1 N can add to either, wherever it acts, Pa: from the smallest contact to the largest patch
/// that a joint feels, an element's side.
double most_contact_stress(const PressedElement& element);

}  // namespace floes
