#pragma once
// The master's view of the ranks: gathered before the first member is handed out, watched for heartbeats, and dismissed
// at the end.

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "core/descriptor.hpp"
#include "run/link.hpp"
#include "run/messages.hpp"
#include "run/worker.hpp"
#include "run/writer.hpp"

namespace floes {

struct Muster {
    std::vector<Hello> hellos;    ///< by rank
    bool stop_requested = false;  ///< a rank received a signal meanwhile

    int cores() const;  ///< of all ranks
};

/// Sends the campaign to every other rank, in a run with several writers with its post, and waits until each has said
/// hello. `journal`: whose pieces the writers open. `own`: the master's own hello. Throws
/// RunError if a rank read a different campaign, reports trouble, or if those that have not answered are silent for
/// twice the patience with a worker.
Muster muster(Link& link, const Campaign& campaign, const Groups& groups, const std::filesystem::path& journal,
              const Hello& own, const SilenceLimits& patience);

class RankWatch {
  public:
    using Time = std::chrono::steady_clock::time_point;

    struct Lost {
        int rank = 0;
        double silence = 0;  ///< s
    };

    /// `link` must outlive the watch. `mustered`: of muster().
    RankWatch(Link& link, const Muster& mustered, const SilenceLimits& patience, Time now);

    /// To be called when a message of the rank has arrived.
    void heard(int rank) { silence_.heard(rank); }

    /// To be called after all arrived messages were taken. Sends the other ranks a sign of life when it is due. Returns
    /// the ranks that have now been silent for too long; the link has abandoned them.
    std::vector<Lost> watch(Time now);

    /// Kills lost ranks of this machine that still exist, because mpirun would wait for them, and lets the others leave
    /// without them. Does nothing if no rank was lost.
    void part();

  private:
    Link& link_;
    SilenceLimits patience_;
    Silence silence_;
    double next_sign_ = 0;                 // of life, in time listened
    std::map<int, Descriptor> processes_;  // of the ranks on this machine, by descriptors that stay valid
    std::set<int> lost_;
};

}  // namespace floes
