#pragma once
// Members in processes of their own. A process with threads, or with MPI started, must not fork: the child would
// inherit locks that nobody opens. So a helper is forked before either begins, stays small and single-threaded, and
// forks a child for each attempt when asked; the result comes back over a socket. A member that crashes, hangs or runs
// away with memory takes down its child alone, and the helper says how it ended.
//
//     Helper helper(compute);             // first thing in main()
//     helper.prepare(campaign);
//     Attempted attempt = helper.run(number, limits, stop);   // from any thread
//
// The limit of memory is RLIMIT_AS, counted from what the helper has mapped: a child has one thread and maps hardly
// anything that it does not use, so the address space is a fair measure, and the limit holds at once, without anybody
// looking, mostly as a failed allocation that can be told apart from a crash.
//
// Children die with their helper, the helper dies with the process that started it (PR_SET_PDEATHSIG).

#include <sys/types.h>

#include <chrono>
#include <stop_token>

#include "attempt/attempt_here.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"

namespace floes {

/// The helper is gone, or does not answer: nothing can be computed apart in this process any more.
class HelperLost : public RunError {
  public:
    using RunError::RunError;
};

class Helper {
  public:
    /// Forks the helper, which will compute members with `compute`. Must be called from the main thread while it is the
    /// only one, before MPI is started. Throws RunError when the system refuses.
    explicit Helper(MemberFunction compute);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    /// Ends the helper and what it runs.
    ~Helper();

    /// The campaign of all runs from now on.
    void prepare(const Campaign& campaign);

    /// One attempt at the member in a process of its own: the result, or a failed one with the reason of the crash, or
    /// none when `stop` is requested first. Throws HelperLost.
    Attempted run(int number, const AttemptLimits& limits, const std::stop_token& stop) const;

    pid_t pid() const { return pid_; }

  private:
    Descriptor control_;
    pid_t pid_ = -1;
};

}  // namespace floes
