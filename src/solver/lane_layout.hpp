#pragma once
// Where the kernels find things. Bodies and joints lie in groups of `width` lanes, one floe a lane; a field of a group
// is `width` doubles side by side, so a kernel loads it as one vector. Plain constants and pointers only: this header
// is compiled under every instruction set, and nothing inline may leak from one of those to another.

#include <cstddef>
#include <cstdint>

namespace floes {

/// Fields of a body that a step reads once. Rotation is row by row, body -> world; SI units, world axes.
namespace body_field {
inline constexpr int position = 0;
inline constexpr int rotation = 3;
inline constexpr int velocity = 12;
inline constexpr int spin = 15;
inline constexpr int force = 18;            ///< sum of applied forces, weight included
inline constexpr int torque = 21;           ///< about the centre of mass
inline constexpr int inverse_inertia = 24;  ///< principal, own axes; 0 for a body that never moves
inline constexpr int start_velocity = 27;   ///< velocity + what force does in the step
inline constexpr int start_spin = 30;       ///< spin + what torque and the gyroscopic term do in the step
inline constexpr int count = 33;
}  // namespace body_field

/// Fields of a body that every sweep reads.
namespace sweep_field {
inline constexpr int velocity = 0;         ///< change by joints and contacts so far
inline constexpr int spin = 3;             ///< likewise
inline constexpr int inverse_inertia = 6;  ///< world axes: xx xy xz yy yz zz
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
    double* delta;  ///< velocity and spin change per body slot, 8 doubles {v, 0, w, 0}: the contacts' view of `sweep`
};

/// One row of a contact (normal or friction) scaled like a joint row; the fourth place of each vector holds a scalar.
struct alignas(32) ContactRow {
    double axis[4];      ///< s * direction; target
    double torque_a[4];  ///< lever a x axis; accumulated impulse over s
    double torque_b[4];  ///< lever b x axis; friction: bound / normal impulse, both scaled
    double spin_a[4];    ///< I_a^-1 torque_a; inverse mass of a
    double spin_b[4];    ///< I_b^-1 torque_b; inverse mass of b
};

/// Slots of the two bodies of a contact.
struct ContactBodies {
    std::uint32_t a;
    std::uint32_t b;
};

/// The kernels of one lane width. Every width gives the same bits.
struct LaneKernels {
    int width;
    /// body groups [0, groups): world inertia, start velocities, changes set to zero.
    void (*prepare_bodies)(const LaneArrays&, std::size_t groups, double time_step);
    /// Frames, joint error, rows and right-hand sides of a block.
    void (*prepare_joints)(const LaneArrays&, const LaneBlock&, double time_step);
    /// `sweeps` Gauss-Seidel sweeps over the joints of each block.
    void (*sweep)(const LaneArrays&, const LaneBlock* blocks, std::size_t count, int sweeps);
    void (*reactions)(const LaneArrays&, const LaneBlock&, double time_step);
    /// body groups [0, groups): velocity and spin at the end of the step, and the pose they lead to.
    void (*advance_bodies)(const LaneArrays&, std::size_t groups, double time_step);
    /// sweep -> delta and back, for the bodies of a block.
    void (*to_contacts)(const LaneArrays&, const LaneBlock&);
    void (*from_contacts)(const LaneArrays&, const LaneBlock&);
    void (*solve_normals)(double* delta, ContactRow*, const ContactBodies*, std::size_t count);
    void (*solve_frictions)(double* delta, ContactRow*, const ContactRow* normals, const ContactBodies*,
                            std::size_t count);
};

}  // namespace floes
