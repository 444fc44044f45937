#pragma once
// The joints and contacts of many floes, solved side by side. The physics is that of Bullet 3.24's sequential-impulse
// solver with fixed joints (btGeneric6DofSpring2Constraint locked in all six axes) and one friction direction, or
// Coulomb's cone in place of that and edges that crush; each floe's rows are solved in the order in which its joints
// are given. Or joints are solved exactly, and only contacts are iterated. A step reads:
//
//   system.add_force(body, force, torque);         // and set_state for bodies that something else moves
//   system.prepare(time_step);
//   system.solve(contacts, law, {iterations});       // contacts in the order in which they are to be solved
//   system.advance();
//   system.state(body); system.reaction(joint);
//
// A floe is a set of bodies connected by joints. Where joints are swept, floes with the same pattern of joints go into
// the lanes of a block; where they are solved directly, bodies and joints fill the lanes by their numbers, whatever
// floes they are of. A removed joint stays in its lane and does nothing. Everything is the same, to the bit, at every
// lane width.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solver/aligned_array.hpp"
#include "solver/contact_rows.hpp"
#include "solver/direct_contacts.hpp"
#include "solver/direct_floes.hpp"
#include "solver/lane_layout.hpp"
#include "solver/solver_kind.hpp"
#include "solver/solver_parts.hpp"

namespace floes {

class LaneSystem {
  public:
    /// width: one of lane_widths(); `lanes` uses no more than there are equal floes. solver: lanes or direct.
    LaneSystem(std::span<const SolverBody> bodies, std::span<const SolverJoint> joints, int width,
               SolverKind solver = SolverKind::lanes);

    std::size_t body_count() const { return slot_of_body_.size(); }
    std::size_t joint_count() const { return slot_of_joint_.size(); }
    int width() const { return kernels_->width; }

    void remove_joint(std::size_t joint);

    /// From the coming step on the joint has this share, above 0, of the stiffness against bending and torsion that it
    /// was made with. Throws RunError where joints are not solved directly.
    void soften_joint(std::size_t joint, double sound);

    void set_state(std::size_t body, const SolverState& state);

    /// Adds up until the coming step; the torque is about the centre of mass.
    void add_force(std::size_t body, const std::array<double, 3>& force, const std::array<double, 3>& torque);

    /// The state of all bodies as they are now.
    const BodyMotion* motions() const { return motion_.data(); }

    /// Takes over the motions and the forces added so far from a system of the first of these bodies, its memory for
    /// contacts, and the reactions of joints. `joints`: which of its joints each of these is; any other number is none.
    void take_over(LaneSystem&& other, std::span<const std::size_t> joints);

    /// From the coming step on. Throws RunError where joints are not solved directly.
    void set_water(std::size_t body, const CarriedWater& water);

    void prepare(double time_step);
    /// Returns the number of sweeps.
    int solve(std::span<SolverContact> contacts, const ContactLaw& law, const Sweeps& sweeps);

    /// Ends the step: velocities, then positions moved with them.
    void advance();

    SolverState state(std::size_t body) const;

    /// Velocity and angular velocity that only move the body out of a penetration (split impulse), for the caller to
    /// apply to its pose between solve and advance; zero without a penetration that deep.
    bool pushed() const { return contact_rows_.any_split(); }
    std::array<double, 6> push(std::size_t body) const { return contact_rows_.push(slot_of_body_[body]); }

    /// After a solve; zero for a removed joint.
    SolverReaction reaction(std::size_t joint) const;

    /// Everything that the next steps depend on, saved or set (core/state_archive.hpp), of the same bodies and joints;
    /// lanes may be of another width.
    void archive(StateArchive& state);

  private:
    struct Floe;
    std::vector<Floe> find_floes(std::span<const SolverBody>, std::span<const SolverJoint>) const;
    // Each returns the number of groups of joints so far.
    std::size_t place_by_number();
    std::size_t place_floes(std::vector<Floe> floes);
    std::size_t place_equal(std::vector<Floe>& floes, std::size_t joint_groups);
    void make_arrays(std::size_t joint_groups);
    void fill(std::span<const SolverBody>, std::span<const SolverJoint>);
    void fill(std::size_t slot, const SolverJoint& joint);
    void cover(std::size_t joint, double more);
    LaneArrays arrays();
    void find_touched(std::span<const SolverContact> contacts);
    void keep_on_rails();
    int solve_directly(std::span<SolverContact> contacts, const ContactLaw& law, const Sweeps& sweeps);

    const LaneKernels* kernels_;
    std::vector<std::vector<std::int32_t>> pairs_;  ///< of the blocks
    std::vector<LaneBlock> blocks_;
    std::vector<std::uint32_t> slot_of_body_;  ///< group * width + lane
    std::vector<std::uint32_t> slot_of_joint_;
    std::vector<std::pair<std::uint32_t, int>> rails_;  ///< slots of bodies on rails, and their axes
    std::vector<std::pair<std::uint32_t, std::uint32_t>> bodies_of_joint_;
    std::vector<bool> is_moving_box_;  ///< by body: its faces are covered by joints; others count their edges
    std::vector<std::uint32_t> block_of_body_;
    std::vector<std::uint8_t> block_touched_, group_touched_;  ///< in this step
    std::vector<std::uint32_t> touched_groups_;                ///< of bodies with contacts
    std::vector<LaneBlock> touched_blocks_;                    ///< with joints and contacts
    std::vector<LaneBlock> free_blocks_;                       ///< with joints, no contact
    std::size_t body_groups_ = 0;
    double time_step_ = 0;
    AlignedArray<double> body_, sweep_, frame_, row_, reaction_, delta_, force_;
    AlignedArray<BodyMotion> motion_;
    std::vector<std::uint32_t> body_of_slot_;
    ContactRows contact_rows_;
    std::optional<DirectFloes> direct_;  ///< where joints are solved exactly
    DirectContacts direct_contacts_;
};

}  // namespace floes
