#pragma once
// Contacts as the kernels see them, in the lanes of their rows.

#include <array>
#include <span>

#include "solver/aligned_array.hpp"
#include "solver/contact_order.hpp"
#include "solver/solver_contact.hpp"

namespace floes {

/// Fields of point_field, by groups of `width`. Empty places get a gap that never closes.
void fill_points(AlignedArray<double>& points, std::span<const SolverContact> contacts, const ContactOrder& order,
                 int width);

/// The friction impulses that contacts bring along, world axes, N s: 3 fields by groups of `width`.
void fill_friction_start(AlignedArray<double>& start, std::span<const SolverContact> contacts,
                         const ContactOrder& order, int width);

/// The friction that a solve found, world axes, N s: its size, and its direction where there is any.
void set_friction(SolverContact& contact, const std::array<double, 3>& impulse);

}  // namespace floes
