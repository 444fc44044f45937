#pragma once
// The threads of this rank at work on members, one member a thread. Assignments go in, outcomes come out, in the order
// in which they finish; the thread that owns the crew never computes.

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "driver/member_function.hpp"

namespace floes {

/// One execution of a member.
struct Assignment {
    int number = 0;
    int attempt = 1;
};

/// How it ended. No result: abandoned, to be done again another time.
struct Outcome {
    Assignment assignment;
    std::optional<MemberResult> result;
};

class Crew {
  public:
    /// `campaign` must outlive the crew. threads >= 1.
    Crew(const Campaign& campaign, MemberFunction compute, int threads);
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    /// Abandons everything and waits until the threads have let go.
    ~Crew();

    /// Starts it on a free thread, or as soon as one is free. After abandon() its outcome is "abandoned".
    void begin(Assignment assignment);

    /// Asks running members to stop and drops those that wait. Each still gives an outcome.
    void abandon();

    /// The outcomes since the last call.
    std::vector<Outcome> take();

    /// Sleeps until there is an outcome to take or the time is over.
    void wait(std::chrono::microseconds longest);

    /// Assignments begun whose outcome has not been taken.
    int held() const { return held_; }

  private:
    void execute_next();
    Outcome execute(Assignment assignment) const;

    const Campaign& campaign_;
    MemberFunction compute_;
    std::stop_source stop_;
    int held_ = 0;

    std::mutex mutex_;  // guards the four below
    std::condition_variable changed_;
    std::deque<Assignment> waiting_;
    std::vector<Outcome> outcomes_;
    int unfinished_ = 0;

    tbb::global_control limit_;  // TBB would otherwise never start more threads than there are cores
    tbb::task_arena arena_;
};

}  // namespace floes
