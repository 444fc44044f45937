#pragma once
// The members of a run that this rank computes, one for each thread. Assignments go in; outcomes come out in order of
// completion. The thread that owns the crew never computes.

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "run/attempt.hpp"
#include "run/core_pool.hpp"
#include "store/member_record.hpp"

namespace floes {

/// One execution of a member.
struct Assignment {
    int number = 0;
    int attempt = 1;
    bool apart = false;  ///< in an isolated process, regardless of run.isolation
};

/// How the assignment of a member ended. No record: abandoned, to be run again later.
struct Outcome {
    int number = 0;
    std::optional<MemberRecord> record;  ///< its arrays packed
};

/// Why a crew cannot continue.
struct CrewTrouble {
    std::string sentence;
    bool stuck = false;  ///< a thread never returns from its member: the crew cannot even end
};

/// What a crew uses to compute members.
struct CrewSetup {
    MemberFunction compute;
    int threads = 1;           ///< members at a time, >= 1
    Helper* helper = nullptr;  ///< for members in isolated processes; nullptr: all are computed in this process
    SharedCores cores = {};    ///< the threads that compute them
    const System& system = this_system();  ///< whose clock tells how long they take
    int rank = 0;                          ///< of this process
};

class Crew {
  public:
    /// `campaign`, the helper and shared cores must outlive the crew. Members follow campaign.run.
    Crew(const Campaign& campaign, CrewSetup setup);
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    /// Abandons everything and waits until the threads have finished with it.
    ~Crew();

    /// Starts the assignment on a free thread, or as soon as one is free. After abandon() its outcome is "abandoned".
    void begin(Assignment assignment);

    /// Asks running members to stop and drops waiting ones. Each still gives an outcome.
    void abandon() { stop_.request_stop(); }

    /// The outcomes since the last call.
    std::vector<Outcome> take();

    /// Sleeps until there is an outcome to take or the time has passed.
    void wait(std::chrono::microseconds longest);

    /// How far running members have come, as far as they have told, in the order of their numbers.
    std::vector<MemberProgress> progress() const;

    /// Once there is some, nothing more is computed here, and all assignments are abandoned.
    std::optional<CrewTrouble> trouble() const;

    /// Assignments begun whose outcome has not been taken.
    int held() const { return held_; }
    int threads() const { return setup_.threads; }
    /// Those held that no thread has begun (between take() and the next outcome).
    int waiting() const { return std::max(held_ - setup_.threads, 0); }

  private:
    void execute_next();
    Outcome execute(Assignment assignment);
    Attempted attempt(Assignment assignment);
    void give_up(CrewTrouble trouble);

    const Campaign& campaign_;
    CrewSetup setup_;
    AttemptLimits limits_;
    std::string host_;
    std::vector<std::string> case_keys_;
    std::stop_source stop_;
    int held_ = 0;

    mutable std::mutex mutex_;  // guards the six members below
    std::condition_variable changed_;
    std::deque<Assignment> waiting_;
    std::vector<Outcome> outcomes_;
    int unfinished_ = 0;
    std::optional<CrewTrouble> trouble_;
    std::map<int, MemberProgress> progress_;  // by number

    std::optional<CorePool> own_cores_;  // where none are shared; last, because its tasks use all of the above
};

}  // namespace floes
