#pragma once
// Fewer sweeps where a thrust passes through many pieces: each sweep begins ahead of where the last one ended.

#include <array>
#include <cstdint>
#include <span>

#include "solver/aligned_array.hpp"

namespace floes {

/// Nesterov's momentum for the sweeps of one step, with Gauss-Seidel sweeps in place of gradient steps (Mazhar, Heyn,
/// Negrut and Tasora 2015, for contacts). It starts anew where a sweep turns back (O'Donoghue and Candes 2015,
/// "gradient scheme") or where sweeps begin to run away, which friction makes possible.
///
/// Velocities follow linearly from impulses, so both are moved ahead alike and stay consistent. An impulse that is
/// moved out of its cone comes back in the next sweep, which is the last word.
class Acceleration {
  public:
    /// What sweeps change.
    struct State {
        std::array<double*, 3> impulse;        ///< of the three rows of each contact, by place
        std::span<const std::uint32_t> place;  ///< by contact, in an order that the lanes do not decide
        std::size_t places;                    ///< with those of empty lanes
        double* delta;                         ///< 8 numbers by slot
        std::span<const std::uint32_t> slots;  ///< that impulses change
    };

    /// Before the first sweep.
    void begin(const State& state);

    /// Between two sweeps.
    void move_ahead(const State& state);

  private:
    bool turned(const State& state);

    std::array<AlignedArray<double>, 3> begun_, ended_;  ///< impulses when the last sweep began, when that before ended
    AlignedArray<double> ended_delta_;
    double momentum_ = 1, least_change_ = 0;
};

}  // namespace floes
