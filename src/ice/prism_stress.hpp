#pragma once
// The stress below a contact on an element that is a convex prism: ice/contact_stress.hpp for any outline. A square
// given as an outline has the stress of a square.
//
// The ice below the contact has Westergaard's stress whatever the elements are, so what a joint lacks of it is the same
// logarithm, from the contact to the circle b_L that its grid feels (ice/felt_patch.hpp):
//
//   inside   in every direction, up to the nearest free edge
//   at it    along that edge, from there on; a joint sees the component along its normal, and the shear
//
// Where the edge ends at another free one, a corner that turns by φ, the logarithm goes on with √(max(0, cos φ)): as
// ever along a straight rim, not at all at the corner of a square, where the moment below a load is finite. In between
// it is a fit: below a load on a corner of 120° grids of any elements then have the same stress (docs/fracture.md).

#include <array>
#include <vector>

#include "ice/contact_stress.hpp"
#include "outline/polygon.hpp"

namespace floes {

/// A joint as one of its elements has it, in the axes of the floe from the element's centroid. SI.
struct PrismJoint {
    Corner outward;    ///< along x or z
    Corner pivot;      ///< halfway between the centroids of the two elements
    double length;     ///< of the common edge
    double span;       ///< between the centroids
    unsigned edge;     ///< bit of the element's edge that it holds
    bool live = true;  ///< or the edge is free there

    std::size_t axis() const { return outward.x != 0 ? 0 : 1; }
};

struct PressedPrism {
    Outline corners;  ///< in the axes of the floe, about the centroid
    double thickness = 0;
    double poisson_ratio = 0;
    double crushing_pressure = 0;  ///< as of PressedElement
    std::vector<PrismJoint> joints{};
};

/// Of the nearest joint along x and the nearest along z, Pa; tension in the lower fibre positive.
struct PrismStress {
    static constexpr std::size_t none = ~std::size_t{0};

    std::array<double, 2> stress{};                   ///< along x and z; 0 without a joint
    double shear = 0;                                 ///< σ_xz
    std::array<std::size_t, 2> joint = {none, none};  ///< by number in the prism's
};

/// `press`: in the axes of the floe from the centroid.
PrismStress contact_stress(const PressedPrism& prism, const Press& press);

/// The most that a force of 1 N can add at any of the joints, its shear included, wherever it acts, Pa.
double most_contact_stress(const PressedPrism& prism);

}  // namespace floes
