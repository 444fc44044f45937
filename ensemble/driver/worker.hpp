#pragma once
// The loop of a rank that is not the master: members in, answers out.

#include "attempt/helper.hpp"
#include "driver/silence.hpp"
#include "wire/link.hpp"

namespace floes {

/// Serves the master (rank 0) until it says that the run is over. `threads`: members at a time; 0: the cores of this
/// rank. A master that is silent for too long is given up: the exit status is then 1. `helper`: computes members in
/// processes of their own; see run_campaign(). Returns the exit status that the master gave. What goes wrong here is
/// told to the master, who ends the run.
int serve_campaign(Link& link, int threads, const MemberFunction& compute, Helper* helper = nullptr,
                   const Patience& patience = {});

/// The threads that a rank is to use: `asked`, or its cores when that is 0.
int threads_of(const Link& link, int asked);

}  // namespace floes
