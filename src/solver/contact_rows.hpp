#pragma once
// Contacts as rows: one normal row a contact, as Bullet 3.24 sets it up (restitution 0, no contact softness) or
// bounded by crushing, and for friction one along the sliding velocity, as Bullet's, or two in the contact plane,
// bounded together by the cone.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/aligned_array.hpp"
#include "solver/contact_law.hpp"
#include "solver/contact_order.hpp"
#include "solver/lane_layout.hpp"
#include "solver/solver_parts.hpp"

namespace floes {

class ContactRows {
  public:
    /// Rows of the contacts, ordered such that the result is that of the given order. `arrays.delta` has `body_slots`
    /// slots of bodies and a spare one after them.
    void prepare(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
                 std::size_t body_slots, const LaneArrays& arrays, const LaneKernels& kernels, const ContactLaw& law,
                 double time_step);

    /// The changes of velocity by the impulses that contacts bring along.
    void start(const LaneKernels& kernels, double* delta);
    void solve_penetrations(const LaneKernels& kernels, int iterations);
    void sweep(const LaneKernels& kernels, double* delta);

    /// Impulses and friction directions back into the contacts.
    void finish(std::span<SolverContact> contacts) const;

    bool any_split() const { return any_split_; }
    std::array<double, 6> push(std::uint32_t slot) const;

  private:
    /// The rows of one kind, in lanes.
    struct Rows {
        AlignedArray<double> row, target, impulse, scale;

        void reserve(std::size_t slots);
        ContactRowArrays arrays() { return {row.data(), target.data(), impulse.data(), scale.data()}; }
    };
    void order(std::span<const SolverContact> contacts, std::span<const std::uint32_t> slot_of_body,
               const LaneArrays& arrays, std::size_t body_slots, const LaneKernels& kernels);
    FrictionArrays friction_arrays() { return {frictions_.arrays(), seconds_.arrays(), friction_start_.data()}; }
    LimitArrays limit_arrays() { return limited_ ? LimitArrays{yield_.data(), give_.data()} : LimitArrays{}; }
    std::array<double, 3> row_axis(const Rows& rows, std::uint32_t slot) const;

    int width_ = 1;
    std::vector<ContactOrder::Contact> to_order_;
    ContactOrder order_;
    AlignedArray<double> points_;
    Rows normals_, frictions_;
    bool cone_ = false;
    Rows seconds_;  ///< with the cone: the friction rows at right angles to frictions_
    AlignedArray<double> friction_start_;
    bool any_split_ = false;
    bool limited_ = false;
    AlignedArray<double> yield_, give_;                  ///< where limited, of the normal rows
    AlignedArray<double> split_target_, split_impulse_;  ///< of the normal rows, for deep penetrations
    AlignedArray<double> push_;
};

}  // namespace floes
