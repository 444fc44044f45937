#pragma once
// Who has not been heard for how long. A rank that dies under mpirun --enable-recovery says nothing: neither do the
// calls of MPI. So every rank gives a sign of life now and then, and silence is counted.

#include <algorithm>
#include <chrono>
#include <vector>

namespace floes {

/// How often, and how long one waits. A master that publishes to a slow disk is silent for long.
struct Patience {
    double sign_of_life = 5;       ///< s between two of them
    double with_a_worker = 60;     ///< s of silence after which its members are given to others
    double with_the_master = 600;  ///< s of silence after which a worker leaves
    double with_answers = 0.05;    ///< s that a worker holds one back while it has others to compute
};

class Silence {
  public:
    using Time = std::chrono::steady_clock::time_point;

    Silence(int ranks, Time now) : heard_(static_cast<std::size_t>(ranks), 0.0), last_(now) {}

    void heard(int rank) { heard_.at(static_cast<std::size_t>(rank)) = listened_; }

    /// To be called after all that had arrived was taken. Time in which nobody listened, since this process was stopped
    /// or wrote to a slow disk, is no silence of the others: of a longer gap one second counts.
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
