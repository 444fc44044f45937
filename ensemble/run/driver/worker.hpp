#pragma once
// The loop of a rank that is not the master: members in, answers out.

#include "attempt/helper.hpp"
#include "driver/silence.hpp"
#include "wire/link.hpp"

namespace floes {

/// Serves the master (rank 0) until it ends the run. `threads`: members at a time; 0: the cores of this rank. `helper`:
/// computes members in isolated processes, see run_campaign(). Returns the exit status sent by the master, or 1 if the
/// master has been silent for too long. Errors here are reported to the master, which ends the run.
int serve_campaign(Link& link, int threads, const MemberFunction& compute, Helper* helper = nullptr,
                   const SilenceLimits& patience = {});

/// The number of threads of a rank: `asked`, or its cores if that is 0.
int threads_of(const Link& link, int asked);

}  // namespace floes
