#pragma once
// How long each rank has been silent. If a rank dies under mpirun --enable-recovery, MPI calls report nothing. So every
// rank sends a regular sign of life, and its silence is measured.

#include <algorithm>
#include <chrono>
#include <vector>

namespace floes {

/// How often signs of life are sent, and how long silence is tolerated. A master that publishes to a slow disk is
/// silent for long.
struct SilenceLimits {
    double sign_of_life = 5;       ///< s between two of them
    double with_a_worker = 60;     ///< s of silence after which its members are given to others
    double with_the_master = 600;  ///< s of silence after which a worker leaves
    double with_answers = 0.05;    ///< s for which a worker may hold back an answer while it has members to compute
};

class Silence {
  public:
    using Time = std::chrono::steady_clock::time_point;

    Silence(int ranks, Time now) : heard_(static_cast<std::size_t>(ranks), 0.0), last_(now) {}

    void heard(int rank) { heard_.at(static_cast<std::size_t>(rank)) = listened_; }

    /// To be called after all arrived messages were taken. Time in which this process did not listen, because it was
    /// stopped or wrote to a slow disk, is not silence of the others: of a longer gap, one second counts.
    void listened(Time now) {
        listened_ += std::min(1.0, std::chrono::duration<double>(now - last_).count());
        last_ = now;
    }

    double of(int rank) const { return listened_ - heard_.at(static_cast<std::size_t>(rank)); }  ///< s
    double total() const { return listened_; }                                                   ///< s listened

  private:
    std::vector<double> heard_;
    double listened_ = 0;
    Time last_;
};

}  // namespace floes
