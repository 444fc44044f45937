#pragma once
// Who computes what next: a pure state machine. Events in, commands out; no MPI, no clock, no physics, no randomness.
//
// Order: batch, then longest expected cost first, ties by member number. (Longest first keeps the last members short:
// 0.93 instead of 0.68 of the ideal speed for 192 members on 64 workers, 20 % error in the expectation.)
// A member goes to the worker with the most idle cores. Workers are given members ahead of their cores, in rounds of
// `prefetch`: one, or as many as take a fifth of a second by the members done so far, so that short ones travel many in
// a message. Nobody gets a round k ahead unless k + 1 members for every core are pending, so that near the end no
// member waits behind a busy core while another is idle; and none before the first answer, so that at the beginning no
// member waits while a worker has yet to join. Of a TimeLeft only members that can be done in it are handed out; one
// that is given k rounds ahead begins when k others have ended, so it counts k + 1 times.
//
//     Scheduler scheduler(tasks);
//     while (!scheduler.finished())
//         for (const Command& command : scheduler.handle(next_event())) obey(command);

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "schedule/events.hpp"

namespace floes {

class Scheduler {
  public:
    /// A member whose attempts failed `most_failures` times, >= 1, is set aside: that answer is kept. Attempts that
    /// were lost with their process do not count, since most of them only stood beside the cause; such a member is
    /// computed apart from then on, where it can harm nobody and its own end is seen. Throws std::logic_error if a
    /// number comes twice or a cost is not positive and finite.
    explicit Scheduler(std::vector<MemberTask> tasks, int most_failures = 1);

    /// Takes the event in and returns what to do, in order. Throws std::logic_error on an event that cannot be: a
    /// worker that joins twice or without cores. An answer that nobody waits for is no error: see late_answers().
    std::vector<Command> handle(const Event& event);

    /// Nothing is left to wait for: every member is done or the stop was requested, and every worker has left.
    bool finished() const;

    int total() const { return static_cast<int>(tasks_.size()); }
    int done() const { return done_; }
    int assigned() const { return assigned_; }  ///< handed out and not answered
    int pending() const { return static_cast<int>(pending_.size()); }
    int running() const { return running_; }                           ///< of the assigned, those that have a core
    int workers() const { return static_cast<int>(workers_.size()); }  ///< that have not left and are not lost
    int late_answers() const { return late_answers_; }                 ///< answers of attempts that had been given up
    bool stopping() const { return stopping_; }
    double done_cost() const { return done_cost_; }  ///< sum over done members
    double remaining_cost() const;                   ///< sum over all others

    /// Throws std::logic_error naming the first inconsistency of the books. O(members + workers); for tests.
    void check_invariants() const;

  private:
    using Index = std::size_t;  // into tasks_, which is in the order of handing out

    struct Entry {
        MemberTask task;
        int attempts = 0;
        int failures = 0;  // of these
        bool suspect = false;
        std::optional<int> worker;  // who holds it
        bool done = false;
    };
    struct Worker {
        int cores = 1;
        int prefetch = 0;
        std::set<Index> held;
        bool dismissed = false;

        int running() const { return std::min(static_cast<int>(held.size()), cores); }
        // Rounds that it holds ahead of its cores; idle cores count below 0.
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
    int rounds() const;  // to be held ahead, by what the members so far took
    std::set<Index>::iterator next(int level) const;
    void hand_out(std::vector<Command>& commands, int most_rounds);
    void dismiss_when_over(std::vector<Command>& commands);
    void offer(int worker);     // counts what the worker runs, and enters it among those with room
    void withdraw(int worker);  // takes both back, before its load changes

    int most_failures_;
    std::vector<Entry> tasks_;
    std::unordered_map<int, Index> index_of_;  // looked up for every answer, never walked
    std::set<Index> pending_;
    std::map<int, Worker> workers_;
    std::set<std::pair<int, int>> room_;  // (level, worker) of the workers that may be given something
    int cores_ = 0;                       // of all workers
    int done_ = 0;
    int assigned_ = 0;
    int running_ = 0;
    int late_answers_ = 0;
    double total_cost_ = 0;
    double done_cost_ = 0;
    double timed_cost_ = 0;  // of the members that were done with success
    double run_time_ = 0;    // theirs, s
    double affordable_ = std::numeric_limits<double>::infinity();
    bool stopping_ = false;
};

}  // namespace floes
