#pragma once
// Contacts as rows: one normal and one friction row a contact, as Bullet 3.24 sets them up (restitution 0, no contact
// softness, friction along the sliding velocity).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/aligned_array.hpp"
#include "solver/lane_layout.hpp"

namespace floes {

/// One point of a contact: what the narrow phase says, and after a solve what was exerted. World axes, SI units.
struct SolverContact {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::array<double, 3> on_a{};
    std::array<double, 3> on_b{};
    std::array<double, 3> normal{};  ///< unit, from b to a
    double distance = 0;             ///< along the normal, negative when the bodies overlap
    double friction = 0;             ///< Coulomb coefficient
    double impulse = 0;              ///< N s, of the normal: in, the value to start from; out, what was exerted on a
    std::array<double, 3> slide{};   ///< out: unit vector of the friction row
    double friction_impulse = 0;     ///< out: N s, exerted on a along slide
};

/// How penetrations are corrected.
struct ContactRules {
    double erp = 0.2;                   ///< share corrected in a step
    bool split_impulse = true;          ///< correct deep ones outside the impulse
    double split_impulse_depth = 0.04;  ///< m
};

class ContactRows {
  public:
    /// Rows of the contacts, ordered such that the result is that of the given order but neighbouring rows seldom share
    /// a body; starts the changes of velocity in `arrays.delta` (assumed zero) with the impulses that contacts bring
    /// along.
    void prepare(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                 std::size_t body_slots, const LaneArrays& arrays, int width, const ContactRules& rules,
                 double time_step);

    void solve_penetrations(const LaneKernels& kernels, int iterations);
    void sweep(const LaneKernels& kernels, double* delta);

    /// Impulses and friction directions back into the contacts.
    void finish(std::span<SolverContact> contacts) const;

    bool any_split() const { return !split_rows_.empty(); }
    std::array<double, 6> push(std::uint32_t slot) const;

  private:
    void order(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
               std::size_t body_slots, const LaneArrays& arrays, int width);

    std::size_t count_ = 0;
    AlignedArray<ContactRow> normals_, frictions_;
    std::vector<ContactBodies> bodies_;
    std::vector<std::uint32_t> place_;  ///< row of each contact
    std::vector<std::uint32_t> level_of_slot_, level_of_contact_, level_start_;
    std::vector<double> normal_scale_, friction_scale_;  ///< by row
    std::vector<ContactRow> split_rows_;
    std::vector<ContactBodies> split_bodies_;
    AlignedArray<double> push_;
};

}  // namespace floes
