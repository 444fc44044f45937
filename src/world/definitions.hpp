#pragma once
// What a World is made of: plain values that describe, from which World builds. SI units, world axes as in
// core/vector.hpp.

#include <optional>

#include "core/vector.hpp"
#include "shapes/polygon.hpp"
#include "solver/contact_law.hpp"
#include "solver/solver_kind.hpp"
#include "solver/solver_parts.hpp"
#include "world/state.hpp"

namespace floes {

/// Time stepping, solver and contacts.
struct WorldDefinition {
    double time_step = 0.02;  ///< Δt, s
    int iterations = 50;  ///< Gauss-Seidel sweeps a step; where they solve joints, they set the stiffness at Σ near 0
    /// m/s, with the direct solver: sweeps end after one that changed the velocity at no contact by this. For ice as
    /// thick as in the paper's tank; a length_unit makes it greater by its root. 0: after `iterations`.
    double tolerance = 0;
    double gravity = 9.81;  ///< m/s², along -y
    ContactLaw contact = {};
    SolverKind solver = SolverKind::stock;
    /// m, above 0: Bullet's margins and tolerances, fixed for elements as in the paper's tank, grow with it. A scene
    /// scaled by Froude (lengths by this, times by its root) is the same scene again.
    double length_unit = 1;
    int lanes = 0;  ///< side by side at most: 0 for what the processor has, 1, 2, 4 or 8; never shows in a result
};

/// Bodies of the same piece (>= 0) never collide with each other; bodies of no piece collide with all.
inline constexpr int no_piece = -1;

/// An element of ice that moves freely: a prism, a convex polygon of even thickness.
struct ElementDefinition {
    Outline corners{};  ///< in its own x and z about the centre of mass, along principal axes, m; corners_of() a box's
    double half_thickness = 0;  ///< m, > 0, along its own y
    double mass = 0;            ///< kg, > 0, homogeneous
    Pose pose{};                ///< of the centre of mass
    int piece = no_piece;
    double crushing_pressure = 0;  ///< Pa, of its edges, with NormalLaw::crushing; 0: that of the contact law
};

/// A box of ice that never moves.
struct FixedBoxDefinition {
    Vec3 half_extents = Vec3::Zero();  ///< m
    Pose pose;                         ///< of the centre
};

/// A box of ice that moves along one of the world's axes only and never turns: an ice sheet that gives way. It has no
/// weight, floes touch it, and it touches neither the structure nor boxes like itself.
struct SlidingBoxDefinition {
    Vec3 half_extents = Vec3::Zero();  ///< m, along the world's axes
    Vec3 position = Vec3::Zero();      ///< of the centre
    double mass = 0;                   ///< kg, > 0
    int axis = 2;                      ///< 0 x, 1 y, 2 z
};

/// A half space that never moves, the sea bed or a wall: ice cannot come behind its plane.
struct PlaneDefinition {
    Vec3 point = Vec3::Zero();    ///< of the plane, m
    Vec3 normal = Vec3::UnitY();  ///< unit, towards the ice
    double friction = 0;          ///< Coulomb's coefficient of ice on it, 0-10, whatever the speed
};

/// A fixed joint between two moving bodies: relaxed in the configuration in which it is made.
/// cfm and erp are Bullet's numbers and act on all six axes: row by row the joint is a spring K = Γ / (Δt² Σ A) with a
/// damper D = (1 - Γ) / (Δt Σ A), A = J M⁻¹ Jᵀ the row's inverse effective mass (docs/fracture.md), in series with
/// what a finite number of sweeps leaves unsolved.
struct JointDefinition {
    BodyId a;
    BodyId b;
    Vec3 pivot = Vec3::Zero();      ///< m, in world axes: the middle of the common face
    Quat frame = Quat::Identity();  ///< joint -> world: x the face normal from a to b, y up, z horizontal in the face
    double cfm = 0;                 ///< Σ, 0 <= Σ < 1; above 0 with the direct solver
    double erp = 0.8;               ///< Γ, 0-1
    std::optional<JointSpring> spring{};  ///< the joint in place of Σ and Γ, with the direct solver only
};

}  // namespace floes
