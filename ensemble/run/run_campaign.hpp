#pragma once
// Runs a campaign from the state of its journal to its end: the entry point of the driver on rank 0. The other ranks
// run serve_campaign() (run/worker.hpp) meanwhile.

#include <functional>
#include <ostream>
#include <string>

#include "run/attempt.hpp"
#include "run/core_pool.hpp"
#include "run/link.hpp"
#include "run/progress.hpp"
#include "run/recorder.hpp"
#include "run/signals.hpp"
#include "run/worker.hpp"

namespace floes {

struct CaseStatus;

struct RunOptions {
    Recorder::Places places;
    int threads = 0;             ///< members at a time on this rank; 0: its cores
    int writers = 0;             ///< ranks that keep records, see Groups
    std::string resume_command;  ///< command with which the user resumes after a stop
    Walltime walltime = Walltime();
    SilenceLimits patience = {};
    double saves_every = 0;  ///< s of wall clock, as long_members() (run/saved_members.hpp) has it
    SharedCores cores = {};  ///< of runs in one process; `threads` are then those of the pool
    /// Told once the members of this campaign, or part, that are done, failed and missing, also where the run fails.
    std::function<void(const CaseStatus&)> at_end = [](const CaseStatus&) {};
};

/// `helper` computes members in isolated processes: all of them if campaign.run says so, otherwise those that were lost
/// with their process. Without a helper all are computed in this process. Returns 0 if every member is done, 1 if
/// members failed, 85 if the run was stopped and can be resumed. Throws InputError if the user's input does not allow a
/// start, RunError if the run cannot continue; the journal then has all finished members. Several may run at once, in
/// threads of one process: with files, helpers and links of their own, one lock (Recorder::Places::publishing), and
/// within StopSignals of the process, which stop them all.
int run_campaign(const Campaign& campaign, const RunOptions& options, Link& link, const MemberFunction& compute,
                 Progress& progress, Helper* helper = nullptr);

/// Runs `body` on rank 0 while the other ranks wait for messages. Turns an exception into a sentence on `errors` and an
/// exit status (InputError 2, others 1), and lets every other rank leave with that status.
int lead_ranks(Link& link, std::ostream& errors, const std::function<int()>& body);

}  // namespace floes
