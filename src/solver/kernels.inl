// All kernels of one lane width. A source that CMake writes (floes_lane_kernels) defines FLOES_LANES and
// FLOES_KERNELS and includes this once; its own compiler flags choose the instruction set.

#include "solver/carried_water.hpp"
#include "solver/lane_layout.hpp"

#if FLOES_LANES > 1
#include <immintrin.h>
#endif

namespace floes {
namespace {
// Each is written in terms of those before it.
// clang-format off
#include "solver/pack.inl"
#include "solver/joint_kernels.inl"
#include "solver/body_kernels.inl"
#include "solver/contact_impulses.inl"
#include "solver/contact_setup.inl"
#include "solver/contact_kernels.inl"
#include "solver/direct_joints.inl"
#include "solver/direct_contacts.inl"
// clang-format on
}  // namespace

extern const LaneKernels FLOES_KERNELS;
const LaneKernels FLOES_KERNELS{
    FLOES_LANES,
    turns,
    prepare_bodies,
    prepare_joints,
    sweep,
    reactions,
    advance_bodies,
    to_contacts,
    from_contacts,
    prepare_contacts,
    prepare_limits,
    start_contacts,
    solve_normals,
    solve_frictions,
    solve_cones,
    {carry_water, begin_local, press_joints, from_pieces, direct_reactions, add_velocity_changes,
     prepare_direct_contacts, start_direct_contacts, solve_direct_contacts, move_contacts_ahead, sum_direct_contacts}};

}  // namespace floes
