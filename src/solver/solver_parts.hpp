#pragma once
// Bodies, joints and contacts as the solver is told about them, and what it tells back.

#include <array>
#include <cstdint>
#include <optional>

#include "solver/carried_water.hpp"

namespace floes {

/// Order of the parts as in SolverReaction. What two bodies that swing against each other lose is the same for each
/// part: a share of critical damping.
struct JointSpring {
    std::array<double, 3> force{};   ///< N/m: axial, shear up, shear in the plane
    std::array<double, 3> moment{};  ///< N m: torsion, in-plane bending, bending
    double damping_ratio = 0;        ///< of critical, >= 0

    friend bool operator==(const JointSpring&, const JointSpring&) = default;
};

/// How long a solve takes.
struct Sweeps {
    int most = 0;
    /// m/s: with the direct solver, sweeps end after one that changed the velocity at no contact by this; 0: after
    /// `most`.
    double tolerance = 0;
};

/// How much heavier a body on a rail is in every other direction.
inline constexpr double off_rail = 1e12;

/// What does not change about a body. Without mass: it never moves by itself.
struct SolverBody {
    double inverse_mass = 0;                  ///< 1/kg
    std::array<double, 3> inverse_inertia{};  ///< principal, about its own axes, 1/(kg m²)
    std::array<double, 3> half_extent{};      ///< of a box, own axes, m; 0: flat and unbounded, where ice crushes on it
    double crushing_pressure = 0;             ///< Pa, of its edges, above 0; 0: that of the contact law
    double weight = 0;                        ///< N, upwards, in every step
    CarriedWater water{};                     ///< where joints are solved directly
    bool is_prism = false;  ///< its contacts bring the section that crushes, and it has no box's faces
    int rail = -1;          ///< world axis 0-2 along which alone it moves, without turning; -1: free
};

/// A joint's frame in a body: rotation joint -> body row by row, origin in m from the centre of mass.
struct SolverFrame {
    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::array<double, 3> origin{};
};

/// A fixed joint between two bodies that move.
struct SolverJoint {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    SolverFrame in_a;
    SolverFrame in_b;
    double cfm = 0;                     ///< Σ, relative to the row's inverse effective mass; below 1
    double erp = 0;                     ///< Γ
    std::optional<JointSpring> spring;  ///< in place of Σ and Γ, where joints are solved directly
    /// Share, above 0, that is left of its stiffness against bending and torsion; below 1 where joints are solved
    /// directly.
    double sound = 1;
};

/// Motion of a body. World axes, SI units.
struct SolverState {
    std::array<double, 3> position{};                           ///< of the centre of mass
    std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< body -> world, row by row
    std::array<double, 3> velocity{};
    std::array<double, 3> angular_velocity{};
};

/// What a joint exerted on body a in the last solve: in the joint's frame in a, moment about the pivot; N and N m.
struct SolverReaction {
    std::array<double, 3> force{};
    std::array<double, 3> moment{};
};

/// One point of a contact of which at least one body moves: what the narrow phase says, and after a solve what was
/// exerted. World axes, SI units.
struct SolverContact {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::array<double, 3> on_a{};
    std::array<double, 3> on_b{};
    std::array<double, 3> normal{};  ///< unit, from b to a
    double distance = 0;             ///< along the normal, negative when the bodies overlap
    double friction = 0;             ///< Coulomb coefficient
    double impulse = 0;              ///< N s, of the normal: in, the value to start from; out, what was exerted on a
    /// Unit vector of the friction impulse. In: of the one to start from, cone only. With the cone zero where there is
    /// none.
    std::array<double, 3> slide{};
    double friction_impulse = 0;  ///< N s, exerted on a along slide; in and out likewise
    /// m², of a crushing contact: the area that crushes, in place of that of two boxes; below 0: that of the boxes.
    double section = -1;
    double section_growth = 0;  ///< m, what it gains per depth
    int solid = -1;             ///< of a structure's solids, which one it is at; -1: at none
};

}  // namespace floes
