#pragma once
// Runs a campaign from its journal's state to its end: the front door of the driver on rank 0. The other ranks are in
// serve_campaign() (driver/worker.hpp) meanwhile.

#include <functional>
#include <ostream>
#include <string>

#include "attempt/helper.hpp"
#include "driver/progress.hpp"
#include "driver/recorder.hpp"
#include "driver/silence.hpp"
#include "driver/walltime.hpp"
#include "wire/link.hpp"

namespace floes {

struct RunOptions {
    Recorder::Places places;
    int threads = 0;             ///< members at a time on this rank; 0: its cores
    std::string resume_command;  ///< what the user is to type to go on after a stop
    Walltime walltime = Walltime();
    Patience patience = {};
};

/// `helper` computes the members that campaign.run, or an attempt that was lost with its process, asks to be computed
/// in a process of their own; without one all are computed here. Returns 0 when every member is done, 1 when members
/// failed, 85 when it was stopped and can be resumed. Throws InputError when it cannot begin with what the user gave,
/// RunError when it cannot go on; the journal then has all that was finished.
int run_campaign(const Campaign& campaign, const RunOptions& options, Link& link, const MemberFunction& compute,
                 Progress& progress, Helper* helper = nullptr);

/// Does `body` on rank 0 while the others wait for its messages, turns what it throws into a sentence on `errors` and
/// an exit status (InputError 2, others 1), and lets every other rank leave with that status.
int lead_ranks(Link& link, std::ostream& errors, const std::function<int()>& body);

}  // namespace floes
