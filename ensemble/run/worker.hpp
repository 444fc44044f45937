#pragma once
// A rank that is not the master: members in, answers out, pauses between polls, and how long each rank has been silent.
// If a rank dies under mpirun --enable-recovery, MPI calls report nothing, so every rank sends a regular sign of life.

#include <algorithm>
#include <chrono>
#include <vector>

#include "run/attempt.hpp"
#include "run/link.hpp"

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

// How long the thread that waits for messages sleeps between two polls: briefly after an event, then longer and longer.
// A rank that waits for another's last member must not take a core from it.

class Pause {
  public:
    /// `longest`: how late a message may be noticed.
    explicit Pause(std::chrono::microseconds longest) : longest_(longest) {}

    void something_happened() { next_ = shortest; }

    /// How long to sleep now.
    std::chrono::microseconds next() {
        const auto now = std::min(next_, longest_);
        next_ = std::min(next_ * 2, longest_);
        return now;
    }

  private:
    static constexpr std::chrono::microseconds shortest{50};
    std::chrono::microseconds longest_;
    std::chrono::microseconds next_ = shortest;
};

/// With several ranks a message is noticed within 10 ms, which is short compared with the work queued for the cores. A
/// poll costs some 40 us; polling five times as often took 2 % of a core. A single rank polls only for signals and
/// timers, because an outcome wakes the sleeper.
inline Pause pause_between_polls(int ranks) {
    return Pause(ranks > 1 ? std::chrono::milliseconds(10) : std::chrono::milliseconds(50));
}

/// Serves the master (rank 0) until it ends the run. `threads`: members at a time; 0: the cores of this rank. `helper`:
/// computes members in isolated processes, see run_campaign(). Returns the exit status sent by the master, or 1 if the
/// master has been silent for too long. Errors here are reported to the master, which ends the run.
int serve_campaign(Link& link, int threads, const MemberFunction& compute, Helper* helper = nullptr,
                   const SilenceLimits& patience = {});

/// The number of threads of a rank: `asked`, or its cores if that is 0.
int threads_of(const Link& link, int asked);

}  // namespace floes
