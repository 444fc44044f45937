#pragma once
// Where the kernels find things. Bodies and joints lie in groups of `width` lanes, one floe a lane; a field of a group
// is `width` doubles side by side, so a kernel loads it as one vector. Plain constants, numbers and pointers only: this
// header is compiled under every instruction set, and nothing inline may leak from one of those to another.

#include <cstddef>
#include <cstdint>

#include "solver/body_motion.hpp"
#include "solver/contact_law.hpp"
#include "solver/contact_layout.hpp"
#include "solver/direct_layout.hpp"

namespace floes {

/// Fields of a body that a step reads once. Rotation is row by row, body -> world; SI units, world axes.
namespace body_field {
inline constexpr int position = 0;
inline constexpr int rotation = 3;
inline constexpr int velocity = 12;
inline constexpr int angular_velocity = 15;
inline constexpr int force = 18;            ///< sum of applied forces, weight included, of this step
inline constexpr int torque = 21;           ///< about the centre of mass
inline constexpr int inverse_inertia = 24;  ///< principal, own axes; 0 for a body that never moves
inline constexpr int start_velocity = 27;   ///< velocity + what force does in the step
inline constexpr int start_angular_velocity =
    30;                                       ///< angular velocity + what torque and the gyroscopic term do in the step
inline constexpr int half_extent = 33;        ///< of a box, own axes; 0: flat and unbounded
inline constexpr int covered = 36;            ///< 1 for a face on which a joint holds another body: +x +y +z -x -y -z
inline constexpr int crushing_pressure = 42;  ///< 0: that of the contact law
inline constexpr int count = 43;
}  // namespace body_field

/// Fields of a body that every sweep reads.
namespace sweep_field {
inline constexpr int velocity = 0;          ///< change by joints and contacts so far
inline constexpr int angular_velocity = 3;  ///< likewise
inline constexpr int inverse_inertia = 6;   ///< world axes: xx xy xz yy yz zz
inline constexpr int inverse_mass = 12;
inline constexpr int count = 13;
}  // namespace sweep_field

/// Fields of a joint that a step reads once: its frames in the two bodies, row by row.
namespace frame_field {
inline constexpr int rotation_a = 0;
inline constexpr int origin_a = 9;
inline constexpr int rotation_b = 12;
inline constexpr int origin_b = 21;
inline constexpr int erp = 24;
inline constexpr int alive = 25;  ///< 1; 0 for a broken joint or an empty lane
inline constexpr int count = 26;
}  // namespace frame_field

/// Fields of a joint's six rows that every sweep reads: 43 doubles instead of the 216 of Bullet's six rows. Row i is
/// scaled by s = (J M^-1 J^T)^-1/2, which makes its effective mass 1: the Jacobian and its transpose are then one
/// vector.
namespace row_field {
inline constexpr int axis = 0;      ///< s * axis of rows 0-2 (angular), 3-5 (linear)
inline constexpr int lever_a = 18;  ///< from centre of mass to pivot, world
inline constexpr int lever_b = 21;
inline constexpr int coupling = 24;  ///< J M^-1 J^T off the diagonal: 10 20 21 of the angular, then of the linear rows
inline constexpr int target = 30;    ///< right-hand side
inline constexpr int impulse = 36;   ///< accumulated, over s
inline constexpr int cfm = 42;
inline constexpr int count = 43;
}  // namespace row_field

/// What a joint carries, in its own frame in body a: exerted on a, moment about the pivot, N and N m.
namespace reaction_field {
inline constexpr int force = 0;
inline constexpr int moment = 3;
inline constexpr int scale = 6;  ///< s of the linear rows
inline constexpr int count = 9;
}  // namespace reaction_field

/// What acts on a body in the coming step, by number of a body.
namespace force_field {
inline constexpr int force = 0;   ///< N
inline constexpr int weight = 3;  ///< N, upwards, in every step
inline constexpr int torque = 4;  ///< about the centre of mass, N m
inline constexpr int count = 8;
}  // namespace force_field

/// `width` floes with the same elements and joints, side by side.
struct LaneBlock {
    const std::int32_t* pairs;  ///< bodies a and b of every joint, counted within the block
    std::int32_t joints;
    std::int32_t bodies;
    std::size_t first_body_group;
    std::size_t first_joint_group;
};

/// The arrays of a system; each field of each group starts on a vector boundary.
struct LaneArrays {
    double* body;
    double* sweep;
    double* frame;
    double* row;
    double* reaction;
    double* delta;  ///< velocity and angular velocity change per body slot, {v, inverse mass, w, 0}: the contacts' view
                    ///< of `sweep`, and a spare slot
    double* force;  ///< by number of a body; a spare one for empty lanes
    BodyMotion* motion;                 ///< likewise
    const std::uint32_t* body_of_slot;  ///< its number
};

/// The kernels of one lane width. Every width gives the same bits.
struct LaneKernels {
    int width;
    int turns;  ///< of a pack of contacts, at most
    /// body groups [0, groups): world inertia, start velocities, changes set to zero; forces, which are used up.
    void (*prepare_bodies)(const LaneArrays&, std::size_t groups, double time_step);
    /// Frames, joint error, rows and right-hand sides of a block.
    void (*prepare_joints)(const LaneArrays&, const LaneBlock&, double time_step);
    /// `sweeps` Gauss-Seidel sweeps over the joints of each block.
    void (*sweep)(const LaneArrays&, const LaneBlock* blocks, std::size_t count, int sweeps);
    void (*reactions)(const LaneArrays&, const LaneBlock&, double time_step);
    /// body groups [0, groups): velocity and angular velocity at the end of the step, and the pose they lead to; also
    /// into `motion`.
    void (*advance_bodies)(const LaneArrays&, std::size_t groups, double time_step);
    /// sweep -> delta and back, for some body groups.
    void (*to_contacts)(const LaneArrays&, const std::uint32_t* groups, std::size_t count);
    void (*from_contacts)(const LaneArrays&, const std::uint32_t* groups, std::size_t count);
    /// Rows of the points; targets of those normal rows that correct a penetration outside the impulse, minus infinity,
    /// which exerts nothing, for the others.
    void (*prepare_contacts)(const LaneArrays&, const ContactPacks&, const double* points,
                             const ContactRowArrays& normals, const FrictionArrays& frictions, double* split_target,
                             const ContactStep&);
    /// How much the prepared normal rows can carry at most, where ice crushes or internal edges do not act.
    void (*prepare_limits)(const LaneArrays&, const ContactPacks&, const double* points, const double* normal_scale,
                           const LimitArrays&, const ContactLaw&, double time_step);
    /// Applies the impulses that rows start from; one sweep over all normal rows; one over all friction rows in one
    /// direction; one over all rows of cones, contact by contact.
    void (*start_contacts)(double* delta, const ContactPacks&, const ContactRowArrays&);
    void (*solve_normals)(double* delta, const ContactPacks&, const ContactRowArrays&, const LimitArrays&);
    void (*solve_frictions)(double* delta, const ContactPacks&, const ContactRowArrays&, const double* normal_impulse);
    void (*solve_cones)(double* delta, const ContactPacks&, const ContactRowArrays& normals, const FrictionArrays&,
                        const LimitArrays&);
    DirectKernels direct;
};

}  // namespace floes
