#pragma once
// Where the kernels of the direct solver find things; see lane_layout.hpp. A piece has axes of its own that turn with
// it; "local" is along these.

#include <cstddef>
#include <cstdint>

namespace floes {

struct LaneArrays;
struct LaneBlock;
struct ContactPacks;
struct LimitArrays;

/// What an impulse on one body does to another, by three columns of 8 numbers, for an impulse {x, z, about y; y, about
/// x, about z}: of its first parts the changes of {x, z, about y, 0}, of its last those of {y, about x, about z, 0}.
/// The two halves do not mix.
inline constexpr std::size_t compliance_block = 24;

/// Fields of a body beside those of body_field.
namespace local_field {
inline constexpr int frame = 0;              ///< local -> world of its piece, row by row
inline constexpr int velocity = 9;           ///< start velocity, local; after the solve the change of it
inline constexpr int angular_velocity = 12;  ///< likewise
inline constexpr int impulse = 15;           ///< by its joints, local; then angular
inline constexpr int count = 21;
}  // namespace local_field

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
    double* local;
    double* spring;
    double* impulse;  ///< on each body, by slot {x, z, about y, 0, y, about x, about z, 0}, local: of joints and
                      ///< contacts together; with this solver `delta` has the same order
};

/// Bodies of a piece that an impulse on one of them moves.
struct ComplianceColumn {
    const double* blocks;         ///< PieceCompliance::column() of the one that the impulse is on; null for none
    const double* self;           ///< its block there
    const std::uint32_t* slots;   ///< of those moved
    const std::uint32_t* within;  ///< their numbers in the piece
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
    double* scale[2];    ///< s of the normal row, and of the two others
};

struct DirectContactStep {
    double inverse_step;  ///< 1/s
    double erp;
};

/// The kernels of the direct solver, of one lane width. Every width gives the same bits.
struct DirectKernels {
    /// body groups [0, groups): start velocities anew, of bodies that carry water; `carried`: fields of carried_field.
    void (*carry_water)(const LaneArrays&, const double* carried, std::size_t groups, double time_step);
    /// body groups [0, groups): start velocities, local; impulses set to zero.
    void (*begin)(const LaneArrays&, const DirectArrays&, std::size_t groups);
    /// What the joints of a block exert before velocities change, summed up by body.
    void (*press)(const LaneArrays&, const DirectArrays&, const LaneBlock&, double time_step);
    /// body groups [0, groups): impulses into `impulse`; changes of velocity out of `delta`, in world axes.
    void (*to_pieces)(const LaneArrays&, const DirectArrays&, std::size_t groups);
    void (*from_pieces)(const LaneArrays&, const DirectArrays&, std::size_t groups);
    void (*reactions)(const LaneArrays&, const DirectArrays&, const LaneBlock&, double time_step);
    /// Adds to `delta` what an impulse, 8 numbers as above, does.
    void (*add_velocity_changes)(double* delta, const ComplianceColumn&, const double* impulse);
    void (*prepare_contacts)(const LaneArrays&, const DirectArrays&, const ComplianceColumn*, const ContactPacks&,
                             const double* points, const double* friction_start, const DirectRowArrays&,
                             const DirectContactStep&);
    /// What the impulses do that rows begin with; one sweep over all contacts.
    void (*start_contacts)(double* delta, const ComplianceColumn*, const ContactPacks&, const DirectRowArrays&);
    /// Returns the largest change of velocity at a contact by its own new impulse, m/s.
    double (*solve_contacts)(double* delta, const ComplianceColumn*, const ContactPacks&, const DirectRowArrays&,
                             const LimitArrays&);
    /// Adds the impulses of all rows to those of their bodies.
    void (*sum_contacts)(double* impulse, const ComplianceColumn*, const ContactPacks&, const DirectRowArrays&);
};

}  // namespace floes
