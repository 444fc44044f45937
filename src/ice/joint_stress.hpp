#pragma once
// Joints as elastic ice: stiffness in closed form from Young's modulus E, Poisson's ratio ν, thickness T and the side L
// of the square elements. Derivation: docs/fracture.md.
//
// Vertically a joint is the piece of plate from one element's centre to the next, of width L, bent as a beam: its
// relative rotation and displacement at the middle, where the joint is, do not couple. With D = E T³/(12 (1 - ν²)):
//
//   bending          D                       M = (D L) (θ / L)
//   shear up         12 D / (L² (1 + Φ))     Timoshenko's beam, Φ = 12 D / (κ G T L²), κ = 5/6, G = E / (2 (1 + ν))
//   torsion          D                       so that the lattice has the twisting energy of a plate, D w_xz²
//
// In its plane likewise a sheet of ν = 0, whichever way its joints point:
//
//   axial            E T
//   shear in plane   E T
//   in-plane bending E T L² / 12             linear stress across the face
//
// A sheet of such elements has the plate's bending equation D ∇⁴w inside; at free edges it is a plate of ν = 0. A beam
// one element wide bends as a strip of plate: 1 / (1 - ν²) stiffer than a narrow beam.

#include <optional>

#include "ice/failure.hpp"
#include "scenario/scenario.hpp"
#include "solver/solver_parts.hpp"
#include "world/state.hpp"

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

/// A joint of such a floe, as long as the edge that two elements share; nothing where joints follow Σ and Γ.
std::optional<JointSpring> joint_spring(const FloeShape& shape, const Material& material, double length, double span);

// The stress in the outer fibres of the ice at a joint, and the strength that it meets.
//
// The lattice of beams has the curvatures of the plate: a joint carries D w_nn per width and twists with D w_nt. The
// plate's moments follow with Poisson's ratio (docs/fracture.md):
//
//   m_n = M_n + ν M_t,   m_t = M_t + ν M_n,   m_nt = (1 - ν) M_nt
//
// M_t, across the joint, is that of the two elements' mean moments (ice/stress_field.hpp). With σ = 6 m/T², the stress
// in the plane N/(L T) and what contacts add, both fibres have a largest principal tension; where it pulls along the
// joint's normal rather than across it, it is this joint that cracks.
//
//   bending  σ_1 of either fibre                                               flexural strength
//   tension  σ_1 in the plane, N_n/(L T) + 6 |M_in plane|/(T L²) along it      tensile strength
//
// The crack lies across that tension, so it is shorter than the joint by the cosine of the angle between them: a crack
// along a zigzag of joints takes the energy of a straight one.
//
// Compression and shear are Eqs. (1) and (2) of the paper, as in ice/failure.hpp.

/// The ice at a joint as its stress needs it. SI.
struct IceSection {
    double side = 0;       ///< L, of an element; of polygons the length of the common edge
    double thickness = 0;  ///< T
    double poisson_ratio = 0;
    double flexural_strength = 0;  ///< Pa
    double tensile_strength = 0;   ///< Pa
};

/// What a joint bears, and what it gives when it cracks.
struct JointStrength {
    Thresholds thresholds{};
    IceSection section{};
    double stiffness = 0;         ///< K against bending, N m; 0 where the joints follow Σ and Γ
    double crack_energy = 0;      ///< G_f L T, N m
    double length_over_span = 1;  ///< of the joint, cracking()
};

/// For joints of this length across and this span between centres, m: of squares both are the element's side.
JointStrength joint_strength(const FloeShape& shape, const Material& material, double length, double span);

/// Stress that a contact adds, Pa, tension in the lower fibre positive.
struct LocalStress {
    double along = 0;   ///< along the joint's normal
    double across = 0;  ///< and across it
    double shear = 0;   ///< of both, by the joint's x and z

    void add(double share, const LocalStress& other) {
        along += share * other.along;
        across += share * other.across;
        shear += share * other.shear;
    }

    friend bool operator==(const LocalStress&, const LocalStress&) = default;
};

/// What acts at a joint.
struct JointLoad {
    JointReaction reaction = {};
    double across = 0;         ///< N m: mean bending moment of its elements across it, M_t L
    double pulled_across = 0;  ///< N: their mean force in the plane across it, N_t L, tension positive
    LocalStress sagging = {};  ///< of the contact on its elements that adds most tension to the lower fibre
    LocalStress hogging = {};  ///< to the upper fibre; each is at a place of its own, so they do not add up
};

/// A principal tension that pulls at a joint.
struct Tension {
    double stress = 0;  ///< Pa; negative under compression
    double facing = 1;  ///< cosine of the angle from the joint's normal, at least √½
};

/// Largest of either fibre.
Tension fibre_tension(const JointLoad& load, const IceSection& section);

/// Largest in the plane.
Tension tension_in_plane(const JointLoad& load, const IceSection& section);

/// Whether that exceeds the tensile strength. What turns nothing can open no hinge, and a hinge that has begun to open
/// holds a pull no better than sound ice.
bool is_pulled_apart(const JointLoad& load, const IceSection& section);

struct Utilisation {
    double share = 0;  ///< of the strength; above 1 the joint fails
    FailureMode mode = FailureMode::bending;
};

/// Without what contacts add to the moments that the grid shows.
JointLoad smoothed(const JointLoad& load);

/// Whether the utilisation may exceed 1 if contacts add at most `by_contacts`, Pa, to any tension: a bound that costs
/// less than the utilisation itself. That the largest principal tension is at most the tension along the joint's normal
/// and the twist together is why.
bool may_fail(const JointReaction& reaction, double across, double by_contacts, const IceSection& section,
              const Thresholds& thresholds);

/// By stress: bending and tension as above, the other modes as the thresholds have them.
Utilisation utilisation(const JointLoad& load, const IceSection& section, const Thresholds& thresholds);

}  // namespace floes
