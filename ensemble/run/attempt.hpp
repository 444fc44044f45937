#pragma once
// One attempt at a member, in this process or in one of its own: its limits, and reasons for attempts without a result.
// If possible, a reason depends on the member alone, because it is stored in the campaign file.

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "campaign/campaign.hpp"
#include "core/descriptor.hpp"
#include "core/error.hpp"
#include "member/result.hpp"

namespace floes {

struct AttemptLimits {
    double deadline = 0;  ///< s of wall clock; 0: none
    std::uint64_t memory =
        0;              ///< bytes beyond those at process start; 0: no limit. Enforced only in isolated processes.
    double grace = 60;  ///< s in which a member that polls every step must react to a stop
};

AttemptLimits limits_of(const RunRules& rules);

/// How the process of a member ended, as seen by its helper.
struct Ending {
    int wait_status = 0;            ///< of waitpid()
    bool at_deadline = false;       ///< the helper killed it at its deadline
    std::uint64_t peak_memory = 0;  ///< largest resident set, bytes
};

/// "The process of the member was killed by SIGSEGV (Segmentation fault)."
std::string reason_of(const Ending& ending, const AttemptLimits& limits);

// The function that computes a member. It is an argument of the driver, so that tests can pass fast, slow or broken
// members.

/// How far a member has come.
struct MemberProgress {
    int number = 0;
    double time = 0;  ///< simulated, s
    double end = 0;   ///< of the simulation, s
};

/// What a member function hears and tells while it computes. All may be called at every step.
struct Attempting {
    std::stop_token stop{};                             ///< after a request it must throw soon
    std::function<bool()> is_put_off{};                 ///< whether the member is to be run again, later; empty: never
    std::function<void(const MemberProgress&)> tell{};  ///< empty: nobody listens

    Attempting(std::stop_token until = {}) : stop(std::move(until)) {}  // NOLINT: most functions hear no more
    operator std::stop_token() const { return stop; }                   // NOLINT: likewise
};

/// (campaign, member number, what it hears): the result, a pure function of the first two. Called from many threads at
/// once. An exception means that the member failed; its what() is the reason. After a stop request the function must
/// throw soon, and the exception means that the member was abandoned and is to be run again.
using MemberFunction = std::function<MemberResult(const Campaign&, int number, const Attempting&)>;

/// The MemberFunction of real campaigns: run_member() on the scenario of the member's case, with the seed and the
/// number of its arrangement.
MemberResult compute_member(const Campaign& campaign, int number, std::stop_token stop);

// One attempt at a member in this process.

/// How an attempt ended. No result: abandoned on request, to be run again later.
struct Attempted {
    std::optional<MemberResult> result;
    std::uint64_t peak_memory = 0;  ///< of the process that computed it, bytes
};

/// Returns the result if it is a failed one or if its statistics are numbers. Throws MemberFailure otherwise: NaN must
/// not pass as a measured value.
MemberResult checked(MemberResult result);

/// Computes the member. An exception or a missed deadline gives a failed result with the reason; a stop before the
/// result gives none. The deadline requests a stop that the member must poll. A member that still runs limits.grace
/// after it cannot be ended in this process: `stuck` is then called, once, from another thread. `tell`: how far the
/// member has come, from the thread that computes it.
Attempted attempt_here(const MemberFunction& compute, const Campaign& campaign, int number, const AttemptLimits& limits,
                       std::stop_token stop, const std::function<void()>& stuck,
                       const std::function<void(const MemberProgress&)>& tell = {});

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

/// The helper is gone or does not answer: this process can run no more isolated members.
class HelperLost : public RunError {
  public:
    using RunError::RunError;
};

class Helper {
  public:
    /// Forks the helper, which will compute members with `compute`. Must be called from the main thread while it is the
    /// only one, before MPI is started. Throws RunError if the system refuses. `patience`: s that a member has, when it
    /// is put off, to save what it has.
    explicit Helper(MemberFunction compute, double patience = 0);
    Helper(const Helper&) = delete;
    Helper& operator=(const Helper&) = delete;
    /// Ends the helper and its children.
    ~Helper();

    /// Sets the campaign of all following run() calls.
    void prepare(const Campaign& campaign);

    /// One attempt at the member in an isolated process: the result, a failed result with the reason of the crash, or
    /// none if `stop` is requested first. Throws HelperLost. `tell`: how far the member has come, in this thread.
    Attempted run(int number, const AttemptLimits& limits, const std::stop_token& stop,
                  const std::function<void(const MemberProgress&)>& tell = {}) const;

    pid_t pid() const { return pid_; }

  private:
    Descriptor control_;
    pid_t pid_ = -1;
    double patience_;
};

}  // namespace floes
