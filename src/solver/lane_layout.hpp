#pragma once
// Where the kernels find things. Bodies and joints lie in groups of `width` lanes; a field of a group is `width`
// doubles side by side, so a kernel loads it as one vector. Where joints are swept a lane is a floe; where they are
// solved directly, bodies and joints fill the lanes by their numbers. Plain constants, numbers and pointers only: this
// header is compiled under every instruction set, and nothing inline may leak from one of those to another.

#include <cstddef>
#include <cstdint>

#include "solver/body_motion.hpp"
#include "solver/contact_law.hpp"

namespace floes {

// Where they find contacts.

/// Fields of a point at which two bodies touch.
namespace point_field {
inline constexpr int on_a = 0;
inline constexpr int on_b = 3;
inline constexpr int normal = 6;    ///< unit, from b to a
inline constexpr int distance = 9;  ///< infinite in an empty place
inline constexpr int friction = 10;
inline constexpr int impulse = 11;
inline constexpr int section = 12;  ///< m², below 0: that of the two boxes
inline constexpr int section_growth = 13;
inline constexpr int count = 14;
}  // namespace point_field

/// Fields of a contact's row, scaled like a joint row. Sweeps only read them: targets and accumulated impulses, over s,
/// are in arrays of their own. All rows have the fields given here; the others depend on the kind of row.
namespace contact_field {
inline constexpr int axis = 0;              ///< s * direction
inline constexpr int angular_change_a = 3;  ///< I_a^-1 (lever a x axis)
inline constexpr int angular_change_b = 6;
inline constexpr int count = 16;
}  // namespace contact_field

/// Further fields of a row that is solved by itself: a normal row, or friction in one direction.
namespace single_field {
inline constexpr int torque_a = 9;  ///< lever a x axis
inline constexpr int torque_b = 12;
inline constexpr int friction_coefficient = 15;  ///< friction: bound / normal impulse, both scaled
}  // namespace single_field

/// Further fields of the two friction rows of a cone. One sliding velocity serves all three rows.
namespace cone_first_field {
inline constexpr int lever_a = 9;  ///< from the centre of mass to the contact, world
inline constexpr int lever_b = 12;
inline constexpr int friction_coefficient = 15;  ///< bound / normal impulse, both scaled
}  // namespace cone_first_field
namespace cone_second_field {
inline constexpr int coupling = 9;  ///< J M^-1 J^T of the normal row with the first and with the second
}  // namespace cone_second_field

/// Pairs of bodies that touch, `width` side by side, no moving body twice; each pair's contacts one after the other.
/// With two turns a pack has twice as many pairs, whose rows alternate.
struct ContactPack {
    std::uint32_t turns;
    std::uint32_t first_row;  ///< in groups of `width`
    std::uint32_t end_row;
    std::uint32_t column;  ///< of sum_columns, that of its first pair: its place within the level
};

/// Sums over contacts are made by column and then over columns: in the same order at every lane width.
inline constexpr std::uint32_t sum_columns = 8;

/// A pair with fewer contacts than others, or none, has rows that exert nothing.
struct ContactPacks {
    const std::uint32_t* slots;  ///< by pack and turn: those of the bodies a, then those of b
    const ContactPack* packs;
    std::size_t count;
    std::uint32_t spare;  ///< the slot of both bodies in an empty lane
};

/// Normal or friction rows, by groups of `width`.
struct ContactRowArrays {
    double* row;
    double* target;
    double* impulse;
    double* scale;  ///< s
};

/// Friction rows. The cone has two at right angles in the contact plane; both with one scale, so that the bound on
/// their scaled impulses is a circle.
struct FrictionArrays {
    ContactRowArrays first;
    ContactRowArrays second;  ///< cone only, as `start`
    const double* start;      ///< impulse to start from, world axes, by groups of 3 fields
};

/// Upper bounds on the impulses of normal rows, by groups of `width`; null where there are none.
struct LimitArrays {
    double* yield;
    double* give;
};

struct ContactStep {
    double inverse_step;                   ///< 1/s
    double erp;                            ///< share of a penetration that is opened in the step
    double split_depth = __builtin_inf();  ///< penetrations this deep are corrected outside the impulse, m
    Friction friction = Friction::cone;
};

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
inline constexpr int covered = 36;            ///< joints that hold other bodies on a face: +x +y +z -x -y -z
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

// Where the kernels of the direct solver find things. A piece has axes of its own that turn with it; "local" is along
// these. A body's slot is its number, and likewise a joint's.

/// What an impulse on one body does to another, by three columns of 8 numbers, for an impulse {x, z, about y; y, about
/// x, about z}: of its first parts the changes of {x, z, about y, 0}, of its last those of {y, about x, about z, 0}.
/// The two halves do not mix.
inline constexpr std::size_t compliance_block = 24;

/// Numbers from one piece's frame to the next one's.
inline constexpr std::size_t frame_stride = 16;

/// Fields of a joint in an unstrained piece, local.
namespace spring_field {
inline constexpr int axes = 0;  ///< joint -> local, row by row
inline constexpr int lever_a = 9;
inline constexpr int lever_b = 12;
inline constexpr int stiffness = 15;  ///< Δt K of the linear, then of the angular parts
inline constexpr int hold = 21;       ///< Δt D + Δt² K likewise
inline constexpr int impulse = 27;    ///< on a, without what the velocities change in the step
inline constexpr int count = 33;
}  // namespace spring_field

struct DirectArrays {
    const double* frame;         ///< local -> world, row by row, of each piece
    const std::uint32_t* piece;  ///< of each body
    double* spring;
    const std::uint32_t* joined;  ///< by group of joints: bodies a of its lanes, then b; body 0 in an empty lane
    double* start;                ///< start velocity of each body {x, z, about y, 0, y, about x, about z, 0}, local;
                                  ///< with this solver `delta` has the same order
    double* impulse;              ///< on each body likewise: of joints and contacts together
};

/// Bodies of a piece that an impulse on one of them moves.
struct ComplianceColumn {
    const double* blocks;         ///< PieceCompliance::column() of the one that the impulse is on; null for none
    const double* self;           ///< its block there
    const std::uint32_t* slots;   ///< of those moved
    const std::uint32_t* within;  ///< numbers of their blocks
    std::size_t count;
};

/// Fields of a contact's three rows, each scaled: normal, then two in the contact plane.
namespace direct_field {
inline constexpr int on_a = 0;      ///< 3 x what an impulse along the row is on a {x, z, about y, y, about x, about z}
inline constexpr int on_b = 18;     ///< likewise, local of b
inline constexpr int moves_a = 36;  ///< 3 x what it does to the velocities of a
inline constexpr int moves_b = 54;
inline constexpr int coupling = 72;              ///< of the normal row with the first and the second
inline constexpr int friction_coefficient = 74;  ///< bound of friction / normal impulse, both scaled
inline constexpr int first = 75;                 ///< directions in the contact plane, world
inline constexpr int second = 78;
inline constexpr int change = 81;  ///< of the velocity along the normal row by its unit impulse, scaled, m/s; then that
                                   ///< along the two others
inline constexpr int count = 83;
}  // namespace direct_field

/// By groups of `width`, one field each.
struct DirectRowArrays {
    double* row;
    double* target[3];
    double* impulse[3];  ///< accumulated, over the scale
    double* ended[3];    ///< the same when the last sweep ended
    double* scale[2];    ///< s of the normal row, and of the two others
};

/// What one sweep over the contacts did.
struct SweepChange {
    double largest;  ///< change of velocity at a contact by its own new impulse, m/s
    double square;   ///< of the changes of scaled impulses, summed
    double onwards;  ///< sum of the changes times the way since the last sweep ended: below 0 where sweeps turn back
};

/// What moves between two sweeps, beside the impulses of the rows.
struct MovedAhead {
    double* delta;
    double* ended;               ///< `delta` when the last sweep ended: 8 numbers for each of the slots
    const std::uint32_t* slots;  ///< that impulses change
    std::size_t count;
    std::size_t places;  ///< of the impulses of a row, with those of empty lanes
};

/// The kernels of the direct solver, of one lane width. Every width gives the same bits.
struct DirectKernels {
    /// body groups [0, groups): start velocities anew, of bodies that carry water; `carried`: fields of carried_field.
    void (*carry_water)(const LaneArrays&, const double* carried, std::size_t groups, double time_step);
    /// body groups [0, groups): start velocities, local; impulses set to zero.
    void (*begin)(const LaneArrays&, const DirectArrays&, std::size_t groups);
    /// joint groups [0, groups): what they exert before velocities change, summed up by body in the order of joints.
    void (*press)(const LaneArrays&, const DirectArrays&, std::size_t groups, double time_step);
    /// body groups [0, groups): changes of velocity out of `delta`, in world axes.
    void (*from_pieces)(const LaneArrays&, const DirectArrays&, std::size_t groups);
    /// joint groups [0, groups)
    void (*reactions)(const LaneArrays&, const DirectArrays&, std::size_t groups, double time_step);
    /// Adds to `delta` what an impulse, 8 numbers as above, does.
    void (*add_velocity_changes)(double* delta, const ComplianceColumn&, const double* impulse);
    void (*prepare_contacts)(const LaneArrays&, const DirectArrays&, const ComplianceColumn*, const ContactPacks&,
                             const double* points, const double* friction_start, const DirectRowArrays&,
                             const ContactStep&);
    /// What the impulses do that rows begin with; one sweep over all contacts.
    void (*start_contacts)(double* delta, const ComplianceColumn*, const ContactPacks&, const DirectRowArrays&);
    SweepChange (*solve_contacts)(double* delta, const ComplianceColumn*, const ContactPacks&, const DirectRowArrays&,
                                  const LimitArrays&);
    /// Impulses, and velocities with them, from where a sweep ended to as much further as `ahead` of the way from where
    /// the last one did.
    void (*move_ahead)(const MovedAhead&, const DirectRowArrays&, double ahead);
    /// Adds the impulses of all rows to those of their bodies.
    void (*sum_contacts)(double* impulse, const ComplianceColumn*, const ContactPacks&, const DirectRowArrays&);
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
