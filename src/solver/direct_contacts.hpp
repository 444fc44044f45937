#pragma once
// Contacts of pieces whose joints are solved exactly: per contact a normal row, rigid or bounded by crushing, and two
// friction rows within Coulomb's cone. An impulse moves the whole piece.

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "solver/aligned_array.hpp"
#include "solver/contact_law.hpp"
#include "solver/contact_order.hpp"
#include "solver/direct_floes.hpp"
#include "solver/lane_layout.hpp"
#include "solver/solver_parts.hpp"

namespace floes {

// Fewer sweeps where a thrust passes through many pieces: each sweep begins ahead of where the last one ended.

/// Nesterov's momentum for the sweeps of one step, with Gauss-Seidel sweeps in place of gradient steps (Mazhar, Heyn,
/// Negrut and Tasora 2015, for contacts). It starts anew where a sweep turns back (O'Donoghue and Candes 2015,
/// "gradient scheme") or where sweeps begin to run away, which friction makes possible.
///
/// Velocities follow linearly from impulses, so both are moved ahead alike and stay consistent. An impulse that is
/// moved out of its cone comes back in the next sweep, which is the last word.
class Acceleration {
  public:
    /// How far to move ahead after a sweep, of the way from where the last one ended.
    double after(const SweepChange& sweep);

  private:
    double momentum_ = 1;
    double least_square_ = std::numeric_limits<double>::infinity();
};

class DirectContacts {
  public:
    /// Rows of the contacts, in an order that follows from theirs. To be called after floes.touch().
    void prepare(std::span<const SolverContact> contacts, const LaneArrays& all, DirectFloes& floes,
                 const LaneKernels& kernels, const ContactLaw& law, double time_step);

    /// The impulses that contacts bring along, then sweeps, until none changes the velocity at a contact by more than
    /// the tolerance. Returns their number; none where nothing touches.
    int solve(const LaneArrays& all, DirectFloes& floes, const LaneKernels& kernels, const Sweeps& sweeps);

    /// Impulses and friction directions back into the contacts.
    void finish(std::span<SolverContact> contacts) const;

  private:
    DirectRowArrays rows();
    void begin_sweeps(const MovedAhead& moved);

    int width_ = 1;
    std::vector<ContactOrder::Contact> to_order_;
    ContactOrder order_;
    AlignedArray<double> points_, friction_start_, row_;
    std::array<AlignedArray<double>, 3> target_, impulse_, ended_;
    AlignedArray<double> ended_delta_;
    std::array<AlignedArray<double>, 2> scale_;
    bool limited_ = false;
    AlignedArray<double> yield_, give_;  ///< where limited, of the normal rows
};

}  // namespace floes
