#pragma once
// `floes run --ranks N`: the program starts itself again as N ranks on this machine.

#include <span>

namespace floes {

/// Runs `command` (the words of this process, the first of them the program) under mpirun and waits for it. Ctrl-C,
/// SIGTERM and SIGHUP ask the ranks to stop, as SIGUSR1 does; a second one of them ends mpirun. mpirun ends if this
/// process dies. Returns mpirun's exit status, or 128 and its signal. The environment variable FLOES_MPIRUN names
/// another mpirun. Throws RunError if it cannot be started. Call it before any thread.
int run_ranks(int ranks, std::span<char* const> command);

}  // namespace floes
