#pragma once
// Joints as elastic ice: stiffness in closed form from Young's modulus E, Poisson's ratio ν, thickness T and the side L
// of the square elements. Derivation: docs/ice.md.
//
// Vertically a joint is the piece of plate from one element's centre to the next, of width L, bent as a beam: its
// relative rotation and displacement at the middle, where the joint is, do not couple. With D = E T³/(12 (1 - ν²)):
//
//   bending          D                       M = (D L) (θ / L)
//   shear up         12 D / (L² (1 + Φ))     Timoshenko's beam, Φ = 12 D / (κ G T L²), κ = 5/6, G = E / (2 (1 + ν))
//   torsion          D                       so that the lattice has the twisting energy of a plate, D w_xz²
//
// In its plane the lattice has the energy of a sheet that is stretched or sheared uniformly, without lateral
// contraction:
//
//   axial            E T
//   shear in plane   2 G T                   half of a uniform shear strain falls to each direction of joints
//   in-plane bending E T L² / 12             linear stress across the face
//
// A sheet of such elements has the plate's bending equation D ∇⁴w inside; at free edges it is a plate of ν = 0. A beam
// one element wide bends as a strip of plate: 1 / (1 - ν²) stiffer than a narrow beam.

#include <optional>

#include "scenario/scenario.hpp"
#include "solver/joint_spring.hpp"

namespace floes {

/// Ice as beam joints see it. SI.
struct ElasticIce {
    double elastic_modulus;  ///< E, Pa
    double poisson_ratio;    ///< ν, 0 to 0.5
    double thickness;        ///< T, m
    double damping_ratio;    ///< of two elements that swing against each other, of critical

    double flexural_rigidity() const;  ///< D of a plate, N m
};

ElasticIce elastic_ice(const FloeShape& shape, const Material& material);

/// The joint in the middle of a beam of this width and span, m. Between elements both are L; from the edge of an
/// element to its centre, where a clamp holds it, the span is L / 2.
JointSpring beam_joint(const ElasticIce& ice, double width, double span);

/// The joints of such a floe; nothing where they follow Σ and Γ.
std::optional<JointSpring> joint_spring(const FloeShape& shape, const Material& material);

}  // namespace floes
