#pragma once
// Events of a running campaign, and the commands that answer them. A worker is a rank, identified by its number. An
// attempt is one execution of a member, numbered from 1 so that a late answer is recognised.

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace floes {

/// A member still to be computed.
struct MemberTask {
    int number = 0;         ///< member number, >= 0, unique
    double cost = 0;        ///< expected run time in any unit, > 0
    int batch = 0;          ///< all members of a batch are handed out before any of a later batch
    int attempts_made = 0;  ///< in earlier runs; the next attempt is this + 1
    int failures = 0;       ///< those of these attempts that failed
    bool suspect = false;   ///< its process was lost during an attempt, so it is computed in an isolated process
};

// -- events

/// A worker is ready for members. It computes `cores` at a time and holds up to `prefetch` more (several times as many
/// short ones), so that no core waits for a round trip.
struct WorkerJoined {
    int worker = 0;
    int cores = 1;
    int prefetch = 0;
};

enum class AttemptEnd { done, failed };

/// The answer to an assignment has arrived.
struct MemberFinished {
    int worker = 0;
    int number = 0;
    int attempt = 0;
    AttemptEnd end = AttemptEnd::done;
    double run_time = 0;  ///< s, if done
};

/// A worker said farewell. The members that it held are to be run again.
struct WorkerLeft {
    int worker = 0;
};

/// A worker was lost. The members that it held are to be run again, and one of them may be the cause.
struct WorkerLost {
    int worker = 0;
};

/// The user or the batch system wants the run to end: nothing new is handed out.
struct StopRequested {};

/// Only members up to this cost can finish in time if started now.
struct TimeLeft {
    double cost = 0;
};

using Event = std::variant<WorkerJoined, MemberFinished, WorkerLeft, WorkerLost, StopRequested, TimeLeft>;

// -- commands

/// Give the member to the worker.
struct Assign {
    int worker = 0;
    int number = 0;
    int attempt = 0;
    bool apart = false;  ///< in an isolated process, even if the others are not
    friend bool operator==(const Assign&, const Assign&) = default;
};

/// Keep the answer of this attempt: the member's first valid answer or its last allowed failure. A late answer gets no
/// such command.
struct Keep {
    int number = 0;
    int attempt = 0;
    friend bool operator==(const Keep&, const Keep&) = default;
};

/// The attempt failed but was not the last one: remember the reason.
struct Retry {
    int number = 0;
    int attempt = 0;
    friend bool operator==(const Retry&, const Retry&) = default;
};

/// Tell the worker to abandon its members and say farewell; nothing more will come. Once for each worker.
struct Dismiss {
    int worker = 0;
    friend bool operator==(const Dismiss&, const Dismiss&) = default;
};

using Command = std::variant<Assign, Keep, Retry, Dismiss>;

// Decides which worker computes which member next: a pure state machine. Events in, commands out; no MPI, no clock, no
// physics, no randomness.
//
// Order: batch, then longest expected cost first, ties by member number. (Longest first keeps the last members short:
// 0.93 instead of 0.68 of the ideal speed for 192 members on 64 workers with 20 % error of the expected cost.) A member
// goes to the worker with the most idle cores. Workers get members ahead, in rounds of `prefetch`: one round, or as
// many as take a fifth of a second judged by the members done so far, so that many short members share a message. Round
// k ahead is given only while k + 1 members for every core are pending, so that near the end no member waits behind a
// busy core while another core is idle. No round is given before the first answer, so that at the start no member waits
// while a worker has yet to join. After a TimeLeft only members that can finish in that time are handed out; one that
// is given k rounds ahead starts after k others, so its cost counts k + 1 times.
//
//     Scheduler scheduler(tasks);
//     while (!scheduler.finished())
//         for (const Command& command : scheduler.handle(next_event())) obey(command);

class Scheduler {
  public:
    /// A member whose attempts failed `most_failures` times, >= 1, is set aside: its last answer is kept. Attempts that
    /// were lost with their process do not count, because the cause is usually another member; such a member is
    /// computed in an isolated process from then on, where it harms no other and its own failure shows. Throws
    /// ContractError if a number comes twice or a cost is not positive and finite.
    explicit Scheduler(std::vector<MemberTask> tasks, int most_failures = 1);

    /// Handles the event and returns the commands to obey, in order. Throws ContractError on an impossible event: a
    /// worker that joins twice or without cores. A late answer is not an error: see late_answers().
    std::vector<Command> handle(const Event& event);

    /// True if every member is done or the stop was requested, and every worker has left.
    bool finished() const { return workers_.empty() && (stopping_ || done_ == total()); }

    int total() const { return static_cast<int>(tasks_.size()); }
    int done() const { return done_; }
    int assigned() const { return assigned_; }  ///< handed out and not answered
    int pending() const { return static_cast<int>(pending_.size()); }
    int running() const { return running_; }                           ///< assigned members that have a core
    int workers() const { return static_cast<int>(workers_.size()); }  ///< neither left nor lost
    int late_answers() const { return late_answers_; }  ///< answers of attempts that had been considered lost
    bool stopping() const { return stopping_; }
    double done_cost() const { return done_cost_; }  ///< sum over done members
    /// Sum over all others.
    double remaining_cost() const { return done_ == total() ? 0.0 : total_cost_ - done_cost_; }

    /// Throws ContractError naming the first inconsistency of the state. O(members + workers); for tests.
    void check_invariants() const;

  private:
    using Index = std::size_t;  // into tasks_, which is sorted in the order of handing out

    struct Entry {
        MemberTask task;
        int attempts = 0;
        int failures = 0;  // of these
        bool suspect = false;
        std::optional<int> worker;  // that holds it
        bool done = false;
    };
    struct Worker {
        int cores = 1;
        int prefetch = 0;
        std::set<Index> held;
        bool dismissed = false;

        int running() const { return std::min(static_cast<int>(held.size()), cores); }
        // Rounds held ahead of its cores; negative if cores are idle.
        int level() const {
            const int ahead = static_cast<int>(held.size()) - cores;
            return ahead < 0 || prefetch == 0 ? ahead : ahead / prefetch;
        }
        bool takes_more() const { return level() < 0 || prefetch > 0; }
    };

    void take(const WorkerJoined& event);
    void take(const MemberFinished& event, std::vector<Command>& commands);
    enum class Leave { farewell, lost };
    void remove(int worker, Leave how);
    int rounds() const;  // to hold ahead, judged by the run times so far
    std::set<Index>::iterator next(int level) const;
    void hand_out(std::vector<Command>& commands, int most_rounds);
    void dismiss_when_over(std::vector<Command>& commands);
    void offer(int worker);     // counts its running members and enters it in room_
    void withdraw(int worker);  // undoes both, before its load changes

    int most_failures_;
    std::vector<Entry> tasks_;
    std::unordered_map<int, Index> index_of_;  // looked up for every answer, never walked
    std::set<Index> pending_;
    std::map<int, Worker> workers_;
    std::set<std::pair<int, int>> room_;  // (level, worker) of the workers that may get members
    int cores_ = 0;                       // of all workers
    int done_ = 0;
    int assigned_ = 0;
    int running_ = 0;
    int late_answers_ = 0;
    double total_cost_ = 0;
    double done_cost_ = 0;
    double timed_cost_ = 0;  // of the done members
    double run_time_ = 0;    // of the same members, s
    double affordable_ = std::numeric_limits<double>::infinity();
    bool stopping_ = false;
};

}  // namespace floes
