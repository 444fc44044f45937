#pragma once
// The ranks as the master knows them: gathered before the first member is handed out, watched for signs of life, and
// parted from at the end.

#include <chrono>
#include <map>
#include <set>
#include <vector>

#include "core/descriptor.hpp"
#include "driver/messages.hpp"
#include "driver/silence.hpp"
#include "wire/link.hpp"

namespace floes {

struct Muster {
    std::vector<Hello> hellos;    ///< by rank
    bool stop_requested = false;  ///< a rank got a signal meanwhile

    int cores() const;  ///< of all ranks
};

/// Sends the campaign to every other rank and waits until each has said hello. `own`: the master's own hello.
/// Throws RunError when a rank understood another campaign, is in trouble, or does not answer.
Muster muster(Link& link, const Campaign& campaign, const Hello& own);

class RankWatch {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Lost {
        int rank = 0;
        double silence = 0;  ///< s
    };

    /// `link` must outlive the watch. `mustered`: of muster().
    RankWatch(Link& link, const Muster& mustered, const Patience& patience, Time now);

    /// A message of the rank has arrived.
    void heard(int rank) { silence_.heard(rank); }

    /// To be called after all messages that had arrived were taken. Gives the others a sign of life when it is time.
    /// Returns the ranks that have been silent for too long since then: the link has abandoned them.
    std::vector<Lost> watch(Time now);

    /// Ends the ranks of this machine that were lost without being dead, which mpirun would wait for, and lets the
    /// others leave without them. Does nothing when no rank was lost.
    void part();

  private:
    Link& link_;
    Patience patience_;
    Silence silence_;
    double next_sign_ = 0;                 // of life, in time listened
    std::map<int, Descriptor> processes_;  // of the ranks on this machine, as the system knows them for good
    std::set<int> lost_;
};

}  // namespace floes
