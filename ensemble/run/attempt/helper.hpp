#pragma once
// Members in isolated processes. A process with threads, or with MPI started, must not fork: the child would inherit
// locks that nobody releases. So a helper is forked before either starts, stays small and single-threaded, and forks a
// child for each attempt on request; the result comes back over a socket. A member that crashes, hangs or exhausts
// memory takes down only its child, and the helper reports how it ended.
//
//     Helper helper(compute);             // first thing in main()
//     helper.prepare(campaign);
//     Attempted attempt = helper.run(number, limits, stop);   // from any thread
//
// The memory limit is RLIMIT_AS, counted beyond what the helper has mapped. A child has one thread and maps hardly
// anything that it does not use, so the address space is a fair measure. The limit acts at once, without polling, and
// mostly shows as a failed allocation, which can be distinguished from a crash.
//
// Children die with their helper, the helper dies with the process that started it (PR_SET_PDEATHSIG).

#include <sys/types.h>

#include <chrono>
#include <stop_token>

#include "attempt/attempt_here.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"

namespace floes {

/// The helper is gone or does not answer: this process can run no more isolated members.
class HelperLost : public RunError {
  public:
    using RunError::RunError;
};

class Helper {
  public:
    /// Forks the helper, which will compute members with `compute`. Must be called from the main thread while it is the
    /// only one, before MPI is started. Throws RunError if the system refuses.
    explicit Helper(MemberFunction compute);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    /// Ends the helper and its children.
    ~Helper();

    /// Sets the campaign of all following run() calls.
    void prepare(const Campaign& campaign);

    /// One attempt at the member in an isolated process: the result, a failed result with the reason of the crash, or
    /// none if `stop` is requested first. Throws HelperLost.
    Attempted run(int number, const AttemptLimits& limits, const std::stop_token& stop) const;

    pid_t pid() const { return pid_; }

  private:
    Descriptor control_;
    pid_t pid_ = -1;
};

}  // namespace floes
