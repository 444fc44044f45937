#pragma once
// Where the kernels find contacts; see lane_layout.hpp.

#include <cstddef>
#include <cstdint>

#include "solver/contact_law.hpp"

namespace floes {

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
};

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
    double inverse_step;  ///< 1/s
    double split_depth;   ///< penetrations this deep are corrected outside the impulse, m; infinite for none
    const ContactLaw& law;
};

}  // namespace floes
